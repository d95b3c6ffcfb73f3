#pragma once
/// Clock and scheduling of the running threads: the only place that talks to the kernel about either.
#include <cstdint>

namespace halsted::app {

using Nanoseconds = std::int64_t;

Nanoseconds monotonicNow() noexcept;
void sleepUntil(Nanoseconds) noexcept;         // CLOCK_MONOTONIC, absolute: a late wake-up does not move the next one

inline constexpr int kHapticPriority = 80, kDevicePriority = 78, kPhysicsPriority = 70;

/// First-in first-out scheduling and a timer without slack for the calling thread; false when the system does not permit it.
bool becomeRealtime(int priority) noexcept;
/// Where no real-time priority is granted, the calling thread at least yields to the others; threads that a library starts from
/// here inherit it. Does nothing where the system grants one.
void yieldToOthers() noexcept;
/// Keeps touched pages in memory, where that is permitted without a limit.
bool lockMemory() noexcept;
/// Touches the stack that a real-time thread may use, so that it does not fault later.
void touchStack() noexcept;

struct ThreadUsage { std::int64_t pageFaults = 0, voluntarySwitches = 0; };
ThreadUsage threadUsage() noexcept;            // of the calling thread since it started

}  // namespace halsted::app
