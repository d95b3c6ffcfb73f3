#include "haptics/realtime.h"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>

#include <cerrno>
#include <ctime>

namespace halsted::haptics {

Nanoseconds monotonicNow() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<Nanoseconds>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

void sleepUntil(Nanoseconds when) noexcept {
  timespec until{};
  until.tv_sec = static_cast<time_t>(when / 1'000'000'000);
  until.tv_nsec = static_cast<long>(when % 1'000'000'000);
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {}
}

int becomeRealtime(int priority) noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);                  // 1 ns; the default of 50 us would show in every tick
  sched_param wanted{};
  wanted.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted);
}

void touchStack() noexcept {
  constexpr int kBytes = 256 * 1024;
  volatile char stack[kBytes];
  for (int i = 0; i < kBytes; i += 1024) stack[i] = 0;
  (void)stack[0];
}

}  // namespace halsted::haptics
