#include "app/threads/realtime.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>

namespace halsted::app {

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

bool becomeRealtime(int priority) noexcept {
  prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);                  // 1 ns; the default of 50 us would show in every tick
  sched_param wanted{};
  wanted.sched_priority = priority;
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &wanted) == 0;
}

void yieldToOthers() noexcept {
  constexpr int kNice = 10;
  sched_param lowest{}, normal{};
  lowest.sched_priority = 1;
  if (pthread_setschedparam(pthread_self(), SCHED_FIFO, &lowest) == 0) {   // granted: asked only to know
    pthread_setschedparam(pthread_self(), SCHED_OTHER, &normal);
    return;
  }
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), kNice);
}

bool lockMemory() noexcept {
  rlimit limit{};
  getrlimit(RLIMIT_MEMLOCK, &limit);
  // Under a limit a later allocation would fail instead of merely being slow.
  if (limit.rlim_cur != RLIM_INFINITY && geteuid() != 0) return false;
#ifdef MCL_ONFAULT
  return mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) == 0;
#else
  return false;
#endif
}

void touchStack() noexcept {
  constexpr int kBytes = 256 * 1024;
  volatile char stack[kBytes];
  for (int i = 0; i < kBytes; i += 1024) stack[i] = 0;
  (void)stack[0];
}

ThreadUsage threadUsage() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return {usage.ru_minflt + usage.ru_majflt, usage.ru_nvcsw};
}

}  // namespace halsted::app
