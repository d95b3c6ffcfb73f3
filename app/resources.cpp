#include "app/resources.h"

#include <sys/resource.h>

#include <ctime>

namespace halsted::app {

double peakResidentMegabytes() noexcept {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024.0 * 1e-6;   // Linux counts in KiB
}

double threadCpuTime() noexcept {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace halsted::app
