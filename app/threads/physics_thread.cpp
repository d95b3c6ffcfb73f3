#include "app/threads/physics_thread.h"

#include "app/threads/realtime.h"
#include "sim/step.h"

namespace halsted::app {
namespace {

constexpr double kSnapshotInterval = 8e-3;     // [s] faster than any frame rate

/// When each step is due. A step that begins a whole dt too late has lost that time for good.
struct Clock {
  Nanoseconds next, dt;

  std::uint64_t wait() noexcept {              // -> steps lost
    sleepUntil(next);
    const Nanoseconds behind = monotonicNow() - next;
    const std::uint64_t lost = behind > 0 ? static_cast<std::uint64_t>(behind / dt) : 0;
    next += static_cast<Nanoseconds>(lost + 1) * dt;
    return lost;
  }
};

struct Physics {
  const Scenario& scenario;
  State& state;
  Links& links;
  PhysicsOutcome& outcome;
  Surgeons& surgeons;
  StepRecord record;
  StepOutput output;
  bool scriptsBusy = true;

  void takeInput() {
    links.samples.acquire();
    record.step = state.step;
    record.input.tools = links.samples.front();
    record.input.command = surgeons.command();
    if (record.input.command.kind == Command::Kind::kNone) links.commands.pop(record.input.command);
  }

  void tellHaptics() {
    links.contacts.back() = output.contact;
    links.contacts.publish();
    if (!surgeons.any()) return;
    const bool busy = surgeons.advance(state);
    for (int hand = 0; hand < kHands; ++hand) links.scriptTargets.back()[hand] = surgeons.target(hand);
    links.scriptTargets.publish();
    if (!busy && scriptsBusy) links.physicsNotices.push({NoticeKind::kScriptEnded, state.step, 0});
    if (!busy) links.scriptsEnded.store(true);
    scriptsBusy = busy;
  }

  void tellRecorder() {
    record.stateHash = hash(state);
    links.steps.push(record);
    for (int i = 0; i < output.eventCount; ++i) {
      links.events.push(output.events[i]);
      links.shownEvents.push(output.events[i]);
    }
    if (state.step % kStateInterval != 0) return;
    links.wholeState.back() = state;           // same sizes: copies, does not allocate
    links.wholeState.publish();
  }

  void tellRenderer(double stepSeconds, std::uint64_t every) {   // [s]
    PhysicsStatus& status = links.physicsStatus.back();
    status = {state.step, outcome.lateSteps, stepSeconds * 1e3};
    links.physicsStatus.publish();
    if (state.step % every != 0) return;
    fillSnapshot(scenario.model, state, links.snapshot.back());
    links.snapshot.publish();
  }
};

void stepThrough(Surgeons& surgeons, State& state, Links& links, PhysicsOutcome& outcome) {
  const Scenario& scenario = surgeons.scenario();
  outcome.realtime = becomeRealtime(kPhysicsPriority) == 0;
  if (!outcome.realtime) links.physicsNotices.push({NoticeKind::kNoRealtimePriority, 0, 0});
  touchStack();
  Physics physics{scenario, state, links, outcome, surgeons, {}, {}, true};
  const double dt = scenario.model.params.dt;                    // [s]
  const auto every = static_cast<std::uint64_t>(std::max(1.0, kSnapshotInterval / dt));
  const Nanoseconds start = monotonicNow();
  Clock clock{start, static_cast<Nanoseconds>(dt * 1e9 + 0.5)};
  while (!links.stop.load(std::memory_order_relaxed)) {
    const std::uint64_t lost = clock.wait();
    if (links.pausedHands.load(std::memory_order_acquire) != 0) {
      outcome.pausedSeconds += dt * static_cast<double>(lost + 1);   // simulated time stands still
      continue;
    }
    outcome.lateSteps += lost;
    physics.takeInput();
    const Nanoseconds before = monotonicNow();
    step(scenario.model, physics.record.input, state, physics.output);
    const double seconds = static_cast<double>(monotonicNow() - before) * 1e-9;   // [s]
    outcome.stepTimes.add(seconds);
    ++outcome.steps;
    outcome.faults.add(physics.output, dt);
    physics.tellHaptics();
    physics.tellRecorder();
    physics.tellRenderer(seconds, every);
  }
  outcome.seconds = static_cast<double>(monotonicNow() - start) * 1e-9;
  outcome.failure = surgeons.failure();
  outcome.lostStitches = surgeons.lost();
}

}  // namespace

void runPhysics(Surgeons& surgeons, State& state, Links& links, PhysicsOutcome& outcome) noexcept {
  try {
    stepThrough(surgeons, state, links, outcome);
  } catch (const std::exception& error) {
    outcome.fault = error.what();
    links.stop.store(true);
  }
}

}  // namespace halsted::app
