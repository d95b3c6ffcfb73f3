#include "app/report.h"

#include <algorithm>
#include <fstream>

#include "app/errors.h"

namespace halsted::app {
namespace {

constexpr double kPlotWidth = 900.0, kPlotHeight = 160.0;        // [px]
constexpr std::size_t kMaxPlotPoints = 1800;

const char* const kStyle =
    "body{font:15px/1.5 system-ui,sans-serif;max-width:60em;margin:2em auto;padding:0 1em;color:#1b1f24}"
    "table{border-collapse:collapse;margin:.6em 0}td,th{padding:.2em .9em;border-bottom:1px solid #d8dee4;text-align:left}"
    "td.n{text-align:right;font-variant-numeric:tabular-nums}.ok{color:#116329}.open{color:#9a6700}.bad{color:#b42318}"
    "svg{width:100%;height:auto;background:#f6f8fa}polyline{fill:none;stroke:#0550ae;stroke-width:1}"
    "text{font:11px system-ui,sans-serif;fill:#57606a}line{stroke:#d0d7de}";

std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text) {
    if (c == '<') out += "&lt;";
    else if (c == '>') out += "&gt;";
    else if (c == '&') out += "&amp;";
    else if (c == '"') out += "&quot;";
    else out += c;
  }
  return out;
}

std::string procedureTable(const RunSummary& run) {
  std::string html = "<table><tr><th>step</th><th>instruction</th><th>outcome</th><th>finished</th><th>faults</th></tr>";
  for (std::size_t row = 0; row < run.procedure.size(); ++row) {
    const ProcedureLine& line = run.procedure[row];
    html += "<tr><td>" + escaped(line.id) + "</td><td>" + escaped(line.instruction) + "</td><td class=" + (line.done ? "ok>done" : "open>open") +
            "</td><td class=n>" + (line.done ? number("%.2f s", line.time) : "") + "</td><td class=\"n" + (line.faults ? " bad" : "") + "\">" +
            std::to_string(line.faults);
    for (const FaultLine& fault : run.faults)
      if (fault.row == static_cast<int>(row)) html += number("<br>%.2f s ", fault.time) + escaped(fault.name);
    html += "</td></tr>";
  }
  return html + "</table>";
}

std::string metricsTable(const RunSummary& run) {
  std::string html = "<table><tr><th>metric (its unit is the last part of its name)</th><th>value</th></tr>";
  for (const auto& [name, value] : run.metrics)
    html += "<tr><td>" + escaped(name) + "</td><td class=n>" + number("%.5g", value) + "</td></tr>";
  return html + "</table>";
}

std::string axis(double peak, double duration) {   // [N], [s]
  std::string svg;
  for (int i = 0; i <= 4; ++i) {
    const double y = kPlotHeight * (1.0 - i / 4.0);              // [px]
    svg += "<line x1=0 x2=" + number("%.0f", kPlotWidth) + number(" y1=%.1f", y) + number(" y2=%.1f/>", y);
    svg += "<text x=4" + number(" y=%.1f>", std::max(y - 3.0, 11.0)) + number("%.2f N</text>", peak * i / 4.0);
  }
  svg += "<text x=" + number("%.0f", kPlotWidth - 60.0) + number(" y=%.0f>", kPlotHeight - 4.0) + number("%.1f s</text>", duration);
  return svg;
}

/// The largest force in each of at most kMaxPlotPoints stretches, so that a short peak stays visible.
std::string forcePlot(const Trace& trace, int hand) {
  const auto& samples = trace.samples();
  if (samples.empty()) return "<p>No samples.</p>";
  double peak = 0.1;                           // [N] at least, so that an idle hand shows a flat line
  for (const Trace::Sample& sample : samples) peak = std::max(peak, sample.force[hand]);
  const double duration = std::max(samples.back().time, 1e-9);   // [s]
  const std::size_t stride = samples.size() / kMaxPlotPoints + 1;
  std::string points;
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    double largest = 0.0;                      // [N]
    for (std::size_t j = i; j < std::min(i + stride, samples.size()); ++j) largest = std::max(largest, samples[j].force[hand]);
    points += number("%.1f,", kPlotWidth * samples[i].time / duration) + number("%.1f ", kPlotHeight * (1.0 - largest / peak));
  }
  return "<svg viewBox=\"0 0 " + number("%.0f ", kPlotWidth) + number("%.0f\">", kPlotHeight) + axis(peak, duration) + "<polyline points=\"" +
         points + "\"/></svg>";
}

/// Of an event's value (sim/exchange.h); null where an event has none.
const char* unitOf(EventKind kind) {
  switch (kind) {
    case EventKind::kNeedleEntered:
    case EventKind::kNeedleExited:
    case EventKind::kNeedleReleased:
    case EventKind::kThreadReleased:
    case EventKind::kTissueReleased:
    case EventKind::kChannelTorn:
    case EventKind::kThreadBroken:
    case EventKind::kLayerPunctured:
    case EventKind::kClampReleased:
    case EventKind::kWallPerforated: return "N";
    case EventKind::kBiteCompleted:
    case EventKind::kNeedleGrasped:
    case EventKind::kThreadGrasped:
    case EventKind::kStitchFinished: return "m";
    case EventKind::kThrowTied: return "turns";
    case EventKind::kTissueCut: return "J";
    case EventKind::kPieceFree:
    case EventKind::kPieceTaken: return "m^3";
    default: return nullptr;
  }
}

std::string valueOf(const Event& event) {
  const char* unit = unitOf(event.kind);
  return unit && event.value != 0.0 ? number("%.4g ", event.value) + unit : "";   // where it is not told, as at a suture's entry, it is zero
}

std::string eventTable(const Trace& trace) {
  std::string html = "<table><tr><th>time</th><th>event</th><th>hand</th><th>index</th><th>value</th></tr>";
  for (const Event& event : trace.events()) {
    const char* hand = event.hand == kLeft ? "left" : event.hand == kRight ? "right" : "";
    html += "<tr><td class=n>" + number("%.3f s", static_cast<double>(event.step) * trace.dt()) + "</td><td>" + escaped(name(event.kind)) +
            "</td><td>" + hand + "</td><td class=n>" + (event.index >= 0 ? std::to_string(event.index) : "") + "</td><td class=n>" +
            valueOf(event) + "</td></tr>";
  }
  return html + "</table>";
}

}  // namespace

void Trace::add(const State& state, const Event* events, int count) {
  events_.insert(events_.end(), events, events + count);
  for (int hand = 0; hand < kHands; ++hand) peak_[hand] = std::max(peak_[hand], state.tools[hand].force.norm());
  if (state.step % every_ != 0) return;
  samples_.push_back({static_cast<double>(state.step) * dt_, peak_});
  peak_ = {};
}

std::string reportHtml(const RunSummary& run, const Trace& trace) {
  std::string html = "<!doctype html><html lang=en><meta charset=utf-8><title>" + escaped(run.title) + "</title><style>" + kStyle + "</style>";
  html += "<h1>" + escaped(run.title) + "</h1><p><b class=" + (run.completed ? "ok>Completed" : "open>Not completed") + "</b> after " +
          number("%.2f s", static_cast<double>(run.steps) * run.dt) + " (" + std::to_string(run.steps) + " steps of " +
          number("%g ms", run.dt * 1e3) + "), final state " + hexadecimal(run.stateHash) + ".</p>";
  if (run.assist != "none") html += "<p class=bad>With assistance: " + escaped(run.assist) + ". Knots were placed and held by the program, not tied by friction.</p>";
  html += "<h2>Procedure</h2>" + procedureTable(run);
  html += "<h2>Metrics</h2>" + metricsTable(run);
  html += "<h2>Force on the left hand</h2>" + forcePlot(trace, kLeft) + "<h2>Force on the right hand</h2>" + forcePlot(trace, kRight);
  html += "<h2>Events</h2>" + eventTable(trace);
  html += "<p>Physics step: p50 " + number("%.3f ms", run.stepMilliseconds.p50) + ", p99 " + number("%.3f ms", run.stepMilliseconds.p99) + ".</p></html>\n";
  return html;
}

void writeReport(const std::string& path, const RunSummary& run, const Trace& trace) {
  std::ofstream out(path, std::ios::binary);
  out << reportHtml(run, trace);
  out.close();
  if (!out) throw SystemFault(path + ": cannot write the report");
}

}  // namespace halsted::app
