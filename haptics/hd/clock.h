#pragma once
/// The monotonic clock of haptics/realtime.h in the forms that the API needs. Any thread.
#include <ctime>

#include "haptics/realtime.h"

namespace halsted::haptics::hd {

using haptics::monotonicNow;
using haptics::Nanoseconds;
using haptics::sleepUntil;

inline constexpr Nanoseconds kSecond = 1'000'000'000;

inline timespec asTimespec(Nanoseconds when) noexcept {
  timespec time{};
  time.tv_sec = static_cast<time_t>(when / kSecond);
  time.tv_nsec = static_cast<long>(when % kSecond);
  return time;
}

inline double seconds(Nanoseconds span) noexcept { return static_cast<double>(span) * 1e-9; }  // [s]

}  // namespace halsted::haptics::hd
