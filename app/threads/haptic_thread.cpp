#include "app/threads/haptic_thread.h"

#include <algorithm>

namespace halsted::app {
namespace {

constexpr Nanoseconds kPeriod = 1'000'000;     // [ns] kHapticPeriod

/// Absolute schedule: `next += period`. A late tick skips whole periods and counts them.
struct Schedule {
  Nanoseconds next;
  std::uint64_t tick = 0, skipped = 0;

  double wait() noexcept {                     // -> [s] lateness
    sleepUntil(next);
    return static_cast<double>(monotonicNow() - next) * 1e-9;
  }
  std::uint64_t finish() noexcept {            // periods skipped after this tick
    next += kPeriod;
    ++tick;
    const Nanoseconds behind = monotonicNow() - next;
    const std::uint64_t missed = behind > 0 ? static_cast<std::uint64_t>(behind / kPeriod) : 0;
    next += static_cast<Nanoseconds>(missed) * kPeriod;
    tick += missed;
    skipped += missed;
    return missed;
  }
};

const HandTarget kStill{};                      // not valid: the hand holds still

const HandTarget& targetOf(Mover mover, int hand, const Links& links) noexcept {
  if (mover == Mover::kScript) return links.scriptTargets.front()[hand];
  return mover == Mover::kMouse ? links.mouseTarget.front() : kStill;
}

/// A fault is reported when it begins, not at every tick that it lasts.
void reportFaults(const Hand& hand, int index, std::uint64_t tick, std::uint32_t before, Links& links) noexcept {
  const std::uint32_t fresh = hand.output.faults & ~before & haptics::kFaultCutMask;
  if (fresh == 0) return;
  links.hapticNotices.push({NoticeKind::kHandFault, tick, static_cast<std::int64_t>(fresh) << 8 | index});
  if (!(fresh & haptics::kFaultDeviceGone) || hand.device->mayReturn()) return;
  links.hapticNotices.push({NoticeKind::kDeviceGone, tick, index});
  links.goneHand.store(index);
  links.stop.store(true);
}

/// While a device that may come back is away, the session waits: physics takes no step until it is there again.
void pauseOrResume(const Hand& hand, int index, std::uint64_t tick, Links& links) noexcept {
  const std::uint32_t bit = 1u << index, paused = links.pausedHands.load(std::memory_order_relaxed);
  const bool away = (hand.output.faults & haptics::kFaultDeviceGone) && hand.device->mayReturn();
  if (away == ((paused & bit) != 0)) return;
  links.pausedHands.store(paused ^ bit, std::memory_order_release);
  const auto problem = static_cast<std::int64_t>(hand.device->status().problem);
  links.hapticNotices.push({away ? NoticeKind::kDevicePaused : NoticeKind::kDeviceBack, tick, problem << 8 | index});
}

void tickHands(Hands& hands, const std::array<Mover, kHands>& movers, std::uint64_t tick, Links& links, HapticOutcome& outcome) noexcept {
  links.contacts.acquire();
  links.scriptTargets.acquire();
  links.mouseTarget.acquire();
  bool stale = false;
  for (int i = 0; i < kHands; ++i) {
    Hand& hand = hands[i];
    const std::uint32_t before = hand.output.faults;
    haptics::tick(*hand.device, hand.config, links.contacts.front()[i], targetOf(movers[i], i, links), tick, hand.state, hand.output);
    links.samples.back()[i] = hand.output.sample;
    outcome.maxForce = std::max(outcome.maxForce, hand.output.force.norm());
    stale = stale || hand.output.stale;
    reportFaults(hand, i, tick, before, links);
    pauseOrResume(hand, i, tick, links);
  }
  links.samples.publish();
  outcome.staleTicks += stale;
}

/// The largest of the last hundred ticks or so.
struct WorstOfHundred {
  double last = 0.0, current = 0.0;            // [s]
  int count = 0;

  double update(double lateness) noexcept {    // [s]
    current = std::max(current, lateness);
    if (++count == 100) {
      last = current;
      current = 0.0;
      count = 0;
    }
    return std::max(last, current);
  }
};

void report(const Hands& hands, const Schedule& schedule, double lateness, WorstOfHundred& worst, Links& links,
            const HapticOutcome& outcome) noexcept {   // [s]
  HapticRecord record;
  record.tick = schedule.tick;
  record.latenessMicroseconds = static_cast<float>(lateness * 1e6);
  HapticLevel& level = links.hapticStatus.back();
  HapticStatus& status = level.status;
  for (int i = 0; i < kHands; ++i) {
    const Vec3& force = hands[i].output.force;
    record.force[i] = {static_cast<float>(force.x()), static_cast<float>(force.y()), static_cast<float>(force.z())};
    record.faults[i] = hands[i].output.faults;
    status.faultCode[i] = hands[i].output.faults & haptics::kFaultCutMask;   // the others only shape the force
    status.force[i] = force;
  }
  status.tick = schedule.tick;
  status.skippedPeriods = schedule.skipped;
  status.staleTicks = outcome.staleTicks;
  level.worstLateness = worst.update(lateness);
  links.hapticStatus.publish();
  links.hapticRecords.push(record);
}

}  // namespace

void runHaptic(Hands& hands, const std::array<Mover, kHands>& movers, Links& links, HapticOutcome& outcome) noexcept {
  outcome.realtime = becomeRealtime(kHapticPriority) == 0;
  if (!outcome.realtime) links.hapticNotices.push({NoticeKind::kNoRealtimePriority, 0, 0});
  touchStack();
  const Nanoseconds start = monotonicNow();
  Schedule schedule{start + kPeriod};
  WorstOfHundred worst;
  const ThreadUsage before = threadUsage();
  while (!links.stop.load(std::memory_order_relaxed)) {
    const double lateness = schedule.wait();   // [s]
    tickHands(hands, movers, schedule.tick, links, outcome);
    outcome.lateness.add(lateness);
    ++outcome.ticks;
    report(hands, schedule, lateness, worst, links, outcome);
    const std::uint64_t missed = schedule.finish();
    if (missed > 0) links.hapticNotices.push({NoticeKind::kSkippedPeriods, schedule.tick, static_cast<std::int64_t>(missed)});
  }
  const ThreadUsage after = threadUsage();
  outcome.usage = {after.pageFaults - before.pageFaults, after.voluntarySwitches - before.voluntarySwitches};
  outcome.skippedPeriods = schedule.skipped;
  outcome.seconds = static_cast<double>(monotonicNow() - start) * 1e-9;
}

void runDevice(haptics::Device& device, const std::atomic<bool>& stop) noexcept {
  becomeRealtime(kDevicePriority);
  device.serve(stop);
}

void runBareLoop(const std::atomic<bool>& stop, Durations& lateness) noexcept {
  becomeRealtime(kHapticPriority);
  touchStack();
  Schedule schedule{monotonicNow() + kPeriod + kPeriod / 2};     // between the ticks of the haptic thread
  while (!stop.load(std::memory_order_relaxed)) {
    lateness.add(schedule.wait());
    schedule.finish();
  }
}

}  // namespace halsted::app
