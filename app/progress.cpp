#include "app/progress.h"

#include <unistd.h>

#include <cstdio>

namespace halsted::app {

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()), last_(start_) {}

Progress::~Progress() {
  if (shown_) std::fprintf(stderr, "\r\033[K");
}

bool Progress::due() {
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || now - last_ < std::chrono::milliseconds(250)) return false;
  last_ = now;
  shown_ = true;
  return true;
}

void Progress::show(double simulated, const std::string& what) {   // [s]
  if (!due()) return;
  const double wall = std::chrono::duration<double>(last_ - start_).count();   // [s]
  std::fprintf(stderr, "\r\033[K%.1f s simulated, %.2f times real time  %s", simulated, simulated / wall, what.c_str());
  std::fflush(stderr);
}

void Progress::show(const std::string& what) {
  if (!due()) return;
  std::fprintf(stderr, "\r\033[K%s", what.c_str());
  std::fflush(stderr);
}

}  // namespace halsted::app
