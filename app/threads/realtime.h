#pragma once
/// Who goes first among the running threads, beside the clock and scheduling of haptics/realtime.h.
#include <cstdint>

#include "haptics/realtime.h"

namespace halsted::app {

using haptics::becomeRealtime;
using haptics::monotonicNow;
using haptics::Nanoseconds;
using haptics::sleepUntil;
using haptics::touchStack;

inline constexpr int kHapticPriority = 80, kDevicePriority = 78, kPhysicsPriority = 70;

/// Where no real-time priority is granted, the calling thread at least yields to the others; threads that a library starts from
/// here inherit it. Does nothing where the system grants one.
void yieldToOthers() noexcept;
/// Keeps touched pages in memory, where that is permitted without a limit.
bool lockMemory() noexcept;

struct ThreadUsage { std::int64_t pageFaults = 0, voluntarySwitches = 0; };
ThreadUsage threadUsage() noexcept;            // of the calling thread since it started

}  // namespace halsted::app
