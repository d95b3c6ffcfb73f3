#include "app/progress.h"

#include <unistd.h>

#include <cstdio>

namespace halsted::app {

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()), last_(start_) {}

Progress::~Progress() {
  if (shown_) std::fprintf(stderr, "\r\033[K");
}

void Progress::show(double simulated, const std::string& what) {   // [s]
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - last_ < std::chrono::milliseconds(250)) return;
  last_ = now;
  shown_ = true;
  const double wall = std::chrono::duration<double>(now - start_).count();   // [s]
  std::fprintf(stderr, "\r\033[K%.1f s simulated, %.2f times real time  %s", simulated, simulated / wall, what.c_str());
  std::fflush(stderr);
}

}  // namespace halsted::app
