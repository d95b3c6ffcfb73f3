#pragma once
/// The servo loop of both hands at 1 kHz. Between waking and writing the force there is no heap, lock, log, file, exception or
/// system call but the device's own (DESIGN 8).
#include <array>

#include "app/hands.h"
#include "app/threads/links.h"
#include "app/threads/realtime.h"
#include "app/timing.h"

namespace halsted::app {

struct HapticOutcome {
  std::uint64_t ticks = 0, skippedPeriods = 0, staleTicks = 0;
  double maxForce = 0.0;                       // [N] sent to either device
  double seconds = 0.0;                        // [s] from first to last tick
  Durations lateness;                          // of the wake-up after its scheduled time
  ThreadUsage usage;                           // of the loop alone, without start-up
  bool realtime = false;                       // the system granted the priority
};

/// Runs until `links.stop`. Haptic thread. `movers` says whose target moves each hand.
void runHaptic(Hands&, const std::array<Mover, kHands>& movers, Links&, HapticOutcome&) noexcept;

/// The thread of a device behind a cable, until `stop`: its transfers, and everything about it that may wait.
void runDevice(haptics::Device&, const std::atomic<bool>& stop) noexcept;

/// The same wake-ups without the work: what this machine can do at this load.
void runBareLoop(const std::atomic<bool>& stop, Durations& lateness) noexcept;

}  // namespace halsted::app
