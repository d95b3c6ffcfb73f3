#include "app/threads/realtime.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace halsted::app {

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

ThreadUsage threadUsage() noexcept {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return {usage.ru_minflt + usage.ru_majflt, usage.ru_nvcsw};
}

}  // namespace halsted::app
