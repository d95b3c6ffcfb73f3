#pragma once
/// The monotonic clock, in integers. Any thread.
#include <ctime>

#include <cerrno>
#include <cstdint>

namespace halsted::haptics::hd {

using Nanoseconds = std::int64_t;
inline constexpr Nanoseconds kSecond = 1'000'000'000;

inline Nanoseconds monotonicNow() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<Nanoseconds>(now.tv_sec) * kSecond + now.tv_nsec;
}

inline timespec asTimespec(Nanoseconds when) noexcept {
  timespec time{};
  time.tv_sec = static_cast<time_t>(when / kSecond);
  time.tv_nsec = static_cast<long>(when % kSecond);
  return time;
}

/// An absolute time: a late wake-up does not move the next one.
inline void sleepUntil(Nanoseconds when) noexcept {
  const timespec until = asTimespec(when);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {}
}

inline double seconds(Nanoseconds span) noexcept { return static_cast<double>(span) * 1e-9; }  // [s]

}  // namespace halsted::haptics::hd
