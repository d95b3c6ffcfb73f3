/// `halsted bench`: what a step and a frame cost here, beside the published figures.
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/progress.h"
#include "app/resources.h"
#include "app/stress/series.h"

namespace fs = std::filesystem;

namespace halsted::app {
namespace {

/// The paper's frame of 12 ms (82 frames a second); every preset is compared over the same simulated time.
constexpr double kFrame = 12e-3;               // [s]

struct Published { const char* scene; double milliseconds; const char* hardware; };   // [ms] a frame
constexpr Published kPublished[] = {
    {"purse_string", 5.61, "Intel Core i7-13700KF, 16 cores"},   // paper 003, table 1: solver time while suturing
    {"stay", 6.33, "Intel Core i7-13700KF, 16 cores"},           // table 3, while suturing
    {"connell", 6.78, "Intel Core i7-13700KF, 16 cores"},        // table 2, while suturing
    {"lembert", 11.95, "Intel Core i7-13700KF, 16 cores"},       // table 4, the largest of its columns
};

/// Settings by the name of their preset: those of the scene, and "default", the scene as it is.
std::map<std::string, std::vector<std::string>> presetsOf(const std::string& folder) {
  auto presets = scenes::readScene(folder, {}).presets;
  presets["default"] = {};
  return presets;
}

Scenario benchScenario(const std::string& folder, const std::vector<std::string>& overrides) {
  const fs::path script = fs::path(folder) / "expert.toml";
  std::error_code ignored;
  if (fs::exists(script, ignored)) return scenarioFromFile(script.string(), overrides);
  return scenarioFromScene(folder, overrides, {});
}

nlohmann::ordered_json measure(const std::string& folder, const std::string& preset, const std::vector<std::string>& overrides, int steps) {
  const Scenario scenario = benchScenario(folder, overrides);
  Lockstep run(scenario);
  Progress progress;
  for (int i = 0; i < steps && run.advance(); ++i) progress.show(run.time(), scenario.scene.name + " " + preset);
  const Durations& times = run.stepTimes();
  const Percentiles step = times.percentiles(1e3);
  const double mean = times.count() > 0 ? 1e3 * times.total() / static_cast<double>(times.count()) : 0.0;   // [ms]
  nlohmann::ordered_json row = {{"scene", scenario.scene.name},
                                {"preset", preset},
                                {"particles", tissueParticles(scenario.model)},
                                {"tets", scenario.model.mesh.tets.size()},
                                {"thread_nodes", threadNodes(scenario.model)},
                                {"step_ms", {{"p50", step.p50}, {"p99", step.p99}}},
                                {"frame_ms", mean * kFrame / scenario.model.params.dt},
                                {"resident_mb", peakResidentMegabytes()},
                                {"published_ms", nullptr},
                                {"published_hardware", nullptr}};
  for (const Published& published : kPublished)
    if (scenario.scene.name == published.scene) {
      row["published_ms"] = published.milliseconds;
      row["published_hardware"] = published.hardware;
    }
  return row;
}

void printTable(const nlohmann::ordered_json& rows) {
  std::printf("%-14s %-8s %9s %6s %6s %12s %12s %12s %12s\n", "scene", "preset", "particles", "tets", "thread", "step p50", "step p99",
              "frame 12 ms", "published");
  for (const auto& row : rows) {
    const std::string published = row["published_ms"].is_null() ? "" : number("%.2f ms", row["published_ms"].get<double>());
    std::printf("%-14s %-8s %9d %6d %6d %9.3f ms %9.3f ms %9.2f ms %12s\n", row["scene"].get<std::string>().c_str(),
                row["preset"].get<std::string>().c_str(), row["particles"].get<int>(), row["tets"].get<int>(), row["thread_nodes"].get<int>(),
                row["step_ms"]["p50"].get<double>(), row["step_ms"]["p99"].get<double>(), row["frame_ms"].get<double>(), published.c_str());
  }
  std::printf("One physics thread. Published: solver time of one frame on %s.\n", kPublished[0].hardware);
}

nlohmann::ordered_json jsonOf(const StressSeries& series, const StressPoint& p) {
  return {{"series", series.name},
          {"stitches", p.stitches},
          {"particles", series.particles},
          {"thread_nodes", series.threadNodes},
          {"step_ms", {{"p50", p.stepMedian}, {"p99", p.step99}}},
          {"frame_ms", p.stepMedian * kFrame / series.dt},
          {"real_time_1", p.stepMedian > 0.0 ? 1e3 * series.dt / p.stepMedian : 0.0},
          {"thread_iterations", p.iterations},
          {"thread_speed_m_s", p.threadSpeed},
          {"tension_n", p.tension},
          {"edge_gap_mm", 1e3 * p.gap},
          {"torn", p.torn}};
}

void printSeries(const StressSeries& series) {
  std::printf("%s: %d particles, %d tets, %d thread nodes\n", series.what.c_str(), series.particles, series.tets, series.threadNodes);
  std::printf("%8s %11s %11s %12s %10s %7s %10s %11s %10s %5s\n", "stitches", "step p50", "step p99", "frame 12 ms", "real time", "solves", "thread",
              "tension", "edges", "torn");
  for (const StressPoint& p : series.points)
    if (p.stitches == 1 || p.stitches % 5 == 0)
      std::printf("%8d %8.3f ms %8.3f ms %9.2f ms %9.2fx %7.1f %6.2f m/s %9.2f N %7.2f mm %5d\n", p.stitches, p.stepMedian, p.step99,
                  p.stepMedian * kFrame / series.dt, p.stepMedian > 0.0 ? 1e3 * series.dt / p.stepMedian : 0.0, p.iterations, p.threadSpeed, p.tension,
                  1e3 * p.gap, p.torn);
}

int benchStress(const BenchOptions& options) {
  Progress progress;
  const StressSeries series = options.stress == "two-bodies" ? stressTwoBodies(progress) : stressOneBody(progress);
  const std::string plot = options.plot.empty() ? "stress-" + series.name + ".svg" : options.plot;
  if (!options.json) printSeries(series);
  else {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const StressPoint& p : series.points) rows.push_back(jsonOf(series, p));
    std::printf("%s\n", rows.dump(2).c_str());
  }
  writePlot(series, plot);                     // last: a path that cannot be written costs no figures
  if (!options.json) std::printf("plot: %s\n", plot.c_str());
  return 0;
}

}  // namespace

int bench(const BenchOptions& options) {
  if (!options.stress.empty()) return benchStress(options);
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  bool known = options.scene.empty(), knownPreset = options.preset.empty();
  for (const std::string& folder : scenes::sceneFolders()) {
    if (!options.scene.empty() && fs::path(folder).filename() != options.scene) continue;
    known = true;
    for (const auto& [preset, overrides] : presetsOf(folder)) {
      if (!options.preset.empty() && options.preset != preset) continue;
      knownPreset = true;
      rows.push_back(measure(folder, preset, overrides, options.steps));
    }
  }
  if (!known) throw scenes::InputError(options.scene + ": unknown scene; see `halsted scenes`");
  if (!knownPreset) throw scenes::InputError(options.scene + ": has no preset '" + options.preset + "'");
  if (options.json) std::printf("%s\n", rows.dump(2).c_str());
  else printTable(rows);
  return 0;
}

}  // namespace halsted::app
