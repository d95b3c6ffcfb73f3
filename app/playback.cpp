#include "app/playback.h"

#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <thread>

#include "app/errors.h"
#include "app/output_files.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/resources.h"
#include "app/session/session_writer.h"
#include "app/verifier.h"
#include "sim/outcome.h"

namespace halsted::app {
namespace {

/// What is done after every step besides stepping.
struct Audience {
  std::unique_ptr<SessionWriter> recorder;
  std::unique_ptr<Verifier> verifier;
  Watcher watcher;
  Trace trace;
  bool toTheEnd = true, seenEnough = false;    // others than the watcher want the whole run; it wants no more of it

  bool watch(const Lockstep& run) {
    seenEnough = watcher && !watcher(run);
    return !seenEnough || toTheEnd;
  }

  void record(const Lockstep& run) {
    recorder->addStep(run.input(), hash(run.state()));
    for (int i = 0; i < run.output().eventCount; ++i) recorder->addEvent(run.output().events[i]);
    if (run.state().step % kStateInterval == 0) recorder->addState(run.state().step, save(run.state()));
    recorder->commitWhenDue();
  }

  /// False: the run need not go on.
  bool see(const Lockstep& run) {
    trace.add(run.state(), run.output().events.data(), run.output().eventCount);
    if (recorder) record(run);
    const bool more = watch(run);
    return more && (!verifier || verifier->check(run));
  }
};

void pace(const std::chrono::steady_clock::time_point& start, double simulated) {   // [s]
  std::this_thread::sleep_until(start + std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(simulated)));
}

struct Spent { double wall = 0.0, cpu = 0.0; };   // [s]

/// Steps to the end.
Spent runThrough(const PlayOptions& options, Lockstep& run, Audience& audience) {
  const Stopwatch watch;
  const double cpu = threadCpuTime();          // [s]
  const auto start = std::chrono::steady_clock::now();
  const double begin = run.time();             // [s]
  Progress progress;
  bool more = audience.watch(run);
  while (more && run.advance()) {
    more = audience.see(run);
    if (options.realtime) pace(start, run.time() - begin);
    progress.show(run.time(), options.file);
  }
  return {watch.seconds(), threadCpuTime() - cpu};
}

constexpr double kRounding = 1e-6;             // [steps] 35 s / 1 ms is not 34 999

void checkFrom(const PlayOptions& options, const Scenario& scenario) {
  if (!scenario.recording) throw scenes::InputError(options.file + ": --from needs a recorded session, not a script");
  if (!options.record.empty()) throw scenes::InputError(options.record + ": --record begins at the start; leave out --from");
  const double end = static_cast<double>(scenario.recording->steps()) * scenario.model.params.dt;   // [s]
  if (options.from >= end) throw scenes::InputError(options.file + ": --from " + number("%g s", options.from) + ": the session ends at " + number("%g s", end));
}

/// What would fail at the end is better said before a run of minutes.
void checkOptions(const PlayOptions& options, const Scenario& scenario) {
  if (options.from > 0.0) checkFrom(options, scenario);
  if (options.verify && !scenario.recording) throw scenes::InputError(options.file + ": --verify needs a recorded session, not a script");
  checkOutputs(options.file, {{"--record", options.record}, {"--report", options.report}, {"--video", options.video}});
  if (!options.report.empty() && !std::ofstream(options.report, std::ios::app)) throw SystemFault(options.report + ": cannot write the report");
}

void finishRecording(SessionWriter& recorder, const Lockstep& run) {
  recorder.addState(run.state().step, save(run.state()));
  recorder.close();
}

int verdict(const PlayOptions& options, const Lockstep& run, const Audience& audience, const RunSummary& summary) {
  for (const std::string& why : run.lostStitches()) std::fprintf(stderr, "%s; the stitch was taken out and set anew\n", why.c_str());
  if (!run.failure().empty()) std::fprintf(stderr, "%s\n", run.failure().c_str());
  const SessionReader* recording = run.scenario().recording.get();
  if (recording && !recording->closedProperly())
    std::fprintf(stderr, "%s: the recording ends without a proper close; everything up to step %llu is here\n", options.file.c_str(),
                 static_cast<unsigned long long>(recording->steps()));
  if (audience.verifier && audience.verifier->failed()) {
    std::fprintf(stderr, "%s: %s\n", options.file.c_str(), audience.verifier->message().c_str());
    return kCheckFailed;
  }
  if (audience.verifier && audience.verifier->stepsChecked() == 0) {
    std::fprintf(stderr, "%s: nothing is verified: the recording holds no step\n", options.file.c_str());
    return kCheckFailed;
  }
  if (audience.verifier && !options.json)
    std::printf("  verified: all %llu state hashes are equal\n", static_cast<unsigned long long>(audience.verifier->stepsChecked()));
  if (audience.seenEnough && !audience.toTheEnd && !options.json) std::printf("  ended with the last of the frames asked for\n");
  if (options.requireComplete && !summary.completed) {
    std::fprintf(stderr, "%s: the procedure was not completed\n", options.file.c_str());
    return kCheckFailed;
  }
  return kDone;
}

}  // namespace

int play(const PlayOptions& options, const WatcherMaker& makeWatcher) {
  const Scenario scenario = scenarioFromFile(options.file, options.overrides);
  checkOptions(options, scenario);
  Lockstep run(scenario);
  if (options.from > 0.0) run.seek(static_cast<std::uint64_t>(options.from / scenario.model.params.dt + kRounding));
  Audience audience{nullptr, nullptr, nullptr, Trace(scenario.model.params.dt)};
  audience.toTheEnd = options.verify || options.requireComplete || !options.record.empty() || !options.report.empty();
  if (options.verify) audience.verifier = std::make_unique<Verifier>();
  if (makeWatcher) audience.watcher = makeWatcher(scenario);
  // Last: an earlier session gives way to a run that nothing else keeps from beginning.
  if (!options.record.empty()) audience.recorder = std::make_unique<SessionWriter>(options.record, sessionHeader(scenario, ""));

  const Spent spent = runThrough(options, run, audience);
  if (audience.recorder) finishRecording(*audience.recorder, run);
  RunSummary summary = summariseRun(scenario.scene.name, scenario.scene.title, scenario.model, run.state(), run.stepTimes(), spent.wall);
  if (!makeWatcher && spent.cpu > 0.0)         // who draws waits for threads that draw
    summary.realtimeFactorCpu = static_cast<double>(run.stepTimes().count()) * summary.dt / spent.cpu;
  summary.faults = run.faults().lines(scenario.model);
  for (const auto& row : summarise(testOutcome(scenario.model, run.state()))) summary.metrics.push_back(row);
  if (!options.report.empty()) writeReport(options.report, summary, audience.trace);
  std::fputs((options.json ? jsonOf(summary, "") : textOf(summary)).c_str(), stdout);
  return verdict(options, run, audience, summary);
}

}  // namespace halsted::app
