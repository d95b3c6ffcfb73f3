#pragma once
/// Clock and scheduling of a thread that serves a device: the tick of a session and the servo loop of the HD API use the same.
/// Any thread; nothing here allocates.
#include <cstdint>

namespace halsted::haptics {

using Nanoseconds = std::int64_t;

Nanoseconds monotonicNow() noexcept;
void sleepUntil(Nanoseconds) noexcept;         // CLOCK_MONOTONIC, absolute: a late wake-up does not move the next one

/// First-in first-out scheduling and a timer without slack for the calling thread. 0, or the system's errno for a refusal; the
/// timer is without slack in both cases.
int becomeRealtime(int priority) noexcept;
/// Touches the stack that a real-time thread may use, so that it does not fault later.
void touchStack() noexcept;

}  // namespace halsted::haptics
