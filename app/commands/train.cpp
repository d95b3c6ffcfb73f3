/// `halsted train`: a session in real time, in a window or without one. Main thread: options, window, start and stop.
#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "app/commands/commands.h"
#include "app/errors.h"
#include "app/progress.h"
#include "app/resources.h"
#include "app/threads/live_session.h"
#include "app/window.h"
#include "scenes/scene_reader.h"

namespace halsted::app {
namespace {

std::atomic<bool> interrupted{false};          // set by the signal handler, read by the main thread
static_assert(std::atomic<bool>::is_always_lock_free);

void listenToSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted.store(true); };
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void setUpLog(bool verbose) {
  auto log = spdlog::stderr_color_st("halsted");   // single-threaded sink: only the recorder thread logs
  log->set_pattern("%H:%M:%S.%e %^%l%$ %v");
  log->set_level(verbose ? spdlog::level::debug : spdlog::level::warn);
  spdlog::set_default_logger(log);
}

/// The software rasteriser would start a thread for each core, which take the cores from physics and haptics. The user's own setting stays.
void drawOnOneThread() { setenv("LP_NUM_THREADS", "0", 0); }

bool timeIsUp(const TrainOptions& options, const Stopwatch& watch) {
  return options.seconds > 0.0 && watch.seconds() >= options.seconds;
}

/// No hand is a person's, and the scripts have ended.
bool nothingLeft(const Scenario& scenario, const LiveSession& session) {
  return session.scriptsEnded() && !heldByPerson(scenario.devices[kLeft]) && !heldByPerson(scenario.devices[kRight]);
}

void waitHeadless(const TrainOptions& options, const Scenario& scenario, LiveSession& session) {
  const Stopwatch watch;
  Progress progress;
  while (session.running() && !interrupted.load() && !timeIsUp(options, watch) && !nothingLeft(scenario, session)) {
    sleepUntil(monotonicNow() + 20'000'000);
    progress.show(watch.seconds(), options.scene + " (Ctrl-C ends)");
  }
}

/// The hand whose instrument the assistant takes over.
int clampHand(const SimParams& p) { return p.tools[kRight].kind == ToolKind::kAllis || p.second[kRight].kind == ToolKind::kAllis ? kRight : kLeft; }

void runWindow(const TrainOptions& options, const Scenario& scenario, LiveSession& session, Window& window) {
  const Stopwatch watch;
  while (session.running() && !window.closed() && !interrupted.load() && !timeIsUp(options, watch)) {
    window.poll();
    session.links().mouseTarget.back() = window.target();
    session.links().mouseTarget.publish();
    session.links().helpVisible.store(window.helpVisible());
    session.links().otherView.store(window.otherView());
    if (window.takeThreadAsked()) session.links().commands.push({Command::Kind::kFreshThread, 0.0});
    if (window.takeInstrumentsAsked())
      for (int hand = 0; hand < kHands; ++hand) session.links().commands.push({Command::Kind::kChangeInstrument, static_cast<double>(hand)});
    if (window.takeClampAsked() && scenario.model.params.assistant.clamps > 0)
      session.links().commands.push({Command::Kind::kHandOver, static_cast<double>(clampHand(scenario.model.params))});
    if (session.links().frame.acquire()) window.show(session.links().frame.front());
    if (nothingLeft(scenario, session)) break;
  }
}

nlohmann::ordered_json lateness(const Durations& durations) {
  const Percentiles p = durations.percentiles(1e6);
  return {{"p50", p.p50}, {"p99", p.p99}, {"max", p.max}};
}

double rate(std::uint64_t count, double seconds) { return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0; }   // [s] -> [Hz]

/// The members that `train --json` adds to those of `replay --json`.
std::string liveMembers(const LiveOutcome& outcome) {
  nlohmann::ordered_json json;
  const Percentiles frame = outcome.render.frameTimes.percentiles(1e3), cpu = outcome.render.frameCpu.percentiles(1e3);
  json["haptic"] = {{"rate_hz", rate(outcome.haptic.ticks, outcome.haptic.seconds)},
                    {"lateness_us", lateness(outcome.haptic.lateness)},
                    {"bare_lateness_us", lateness(outcome.bareLateness)},
                    {"max_force_n", outcome.haptic.maxForce},
                    {"stale_ticks", outcome.haptic.staleTicks},
                    {"skipped_periods", outcome.haptic.skippedPeriods},
                    {"page_faults", outcome.haptic.usage.pageFaults},
                    {"realtime_priority", outcome.haptic.realtime}};
  json["physics"] = {{"rate_hz", rate(outcome.physics.steps, outcome.physics.seconds)}, {"late_steps", outcome.physics.lateSteps},
                     {"paused_s", outcome.physics.pausedSeconds}};
  json["render"] = {{"fps", rate(outcome.render.frames, outcome.render.seconds)},
                    {"start_up_s", outcome.render.startSeconds},
                    {"frame_ms", {{"p50", frame.p50}, {"p99", frame.p99}}},
                    {"frame_cpu_ms", {{"p50", cpu.p50}, {"p99", cpu.p99}}}};
  json["recorder"] = {{"steps", outcome.recorder.stepsRecorded}, {"dropped_records", outcome.recorder.dropped}};
  json["resident_mb"] = peakResidentMegabytes();
  const std::string text = json.dump();
  return text.substr(1, text.size() - 2);
}

std::string liveText(const LiveOutcome& outcome) {
  const Percentiles late = outcome.haptic.lateness.percentiles(1e6), bare = outcome.bareLateness.percentiles(1e6);
  std::string text = "  haptics " + number("%.1f Hz", rate(outcome.haptic.ticks, outcome.haptic.seconds)) + ", lateness p50 " +
                     number("%.1f us", late.p50) + ", p99 " + number("%.1f us", late.p99) + ", max " + number("%.0f us", late.max) +
                     ", stale ticks " + std::to_string(outcome.haptic.staleTicks) + ", largest force " + number("%.2f N", outcome.haptic.maxForce) + "\n";
  if (outcome.bareLateness.count() > 0)
    text += "  bare loop lateness p50 " + number("%.1f us", bare.p50) + ", p99 " + number("%.1f us", bare.p99) + ", max " +
            number("%.0f us", bare.max) + "\n";
  text += "  physics " + number("%.1f Hz", rate(outcome.physics.steps, outcome.physics.seconds)) + ", late steps " +
          std::to_string(outcome.physics.lateSteps) + "; pictures " + number("%.1f Hz", rate(outcome.render.frames, outcome.render.seconds)) +
          ", p50 " + number("%.1f ms", outcome.render.frameTimes.percentiles(1e3).p50) + ", CPU " +
          number("%.1f ms", outcome.render.frameCpu.percentiles(1e3).p50) +
          ", renderer start-up " + number("%.2f s", outcome.render.startSeconds) + "; most memory held " + number("%.0f MB", peakResidentMegabytes()) + "\n";
  return text;
}

LiveOptions liveOptions(const TrainOptions& options) {
  LiveOptions live;
  live.record = options.record;
  live.trainee = options.trainee;
  live.render = {options.width, options.height, 60.0, !options.headless};
  live.measureBareLoop = options.headless;
  return live;
}

/// What was asked for; where nothing was, hardware that is attached.
std::array<DeviceChoice, kHands> chosenDevices(const TrainOptions& options) {
  std::string left = options.left, right = options.right;
  if (left.empty() || right.empty()) takeAttached(attachedHardware(), left, right);
  std::array<DeviceChoice, kHands> devices{parseDevice("--left", left.empty() ? "virtual" : left),
                                           parseDevice("--right", !right.empty() ? right : options.headless ? "virtual" : "mouse")};
  for (DeviceChoice& device : devices) device.hardware.firmware = options.firmware;
  return devices;
}

/// What was asked for; where no preset was named, the one that the scene keeps for `train` comes first, so that what was set wins over it.
std::vector<std::string> trainOverrides(const TrainOptions& options, const std::string& folder) {
  std::vector<std::string> overrides = options.overrides;
  const auto names = [](const std::string& text) { return text.rfind("preset=", 0) == 0; };
  const std::string preset = scenes::readScene(folder, overrides).trainPreset;
  if (preset.empty() || std::any_of(overrides.begin(), overrides.end(), names)) return overrides;
  overrides.insert(overrides.begin(), "preset=" + preset);
  std::fprintf(stderr, "halsted: %s is trained with its preset '%s'; --preset default for the scene as it is\n", options.scene.c_str(), preset.c_str());
  return overrides;
}

}  // namespace

int train(const TrainOptions& options) {
  drawOnOneThread();                           // before any thread or OpenGL context
  const std::array<DeviceChoice, kHands> devices = chosenDevices(options);
  const std::string folder = scenes::findScene(options.scene);
  const Scenario scenario = scenarioFromScene(folder, trainOverrides(options, folder), devices);
  setUpLog(options.verbose);
  std::unique_ptr<Window> window;
  const int moved = devices[kLeft].mover == Mover::kMouse ? kLeft : kRight;
  if (!options.headless)
    window = std::make_unique<Window>("Halsted: " + scenario.scene.title, options.width, options.height, scenario.start[moved], scenario.scene.camera);
  LiveSession session(scenario, liveOptions(options));
  listenToSignals();
  const Stopwatch watch;
  session.start();
  if (window) runWindow(options, scenario, session, *window);
  else waitHeadless(options, scenario, session);
  const LiveOutcome& outcome = session.stop();

  RunSummary summary = summariseRun(scenario.scene.name, scenario.scene.title, scenario.model, session.state(),
                                    outcome.physics.stepTimes, watch.seconds());
  summary.faults = outcome.physics.faults.lines(scenario.model);
  std::fputs((options.json ? jsonOf(summary, liveMembers(outcome)) : textOf(summary) + liveText(outcome)).c_str(), stdout);
  for (const std::string& why : outcome.physics.lostStitches) std::fprintf(stderr, "%s; the stitch was taken out and set anew\n", why.c_str());
  if (!outcome.physics.failure.empty()) std::fprintf(stderr, "%s\n", outcome.physics.failure.c_str());
  if (!outcome.fault.empty()) throw SystemFault(outcome.fault);
  return kDone;
}

}  // namespace halsted::app
