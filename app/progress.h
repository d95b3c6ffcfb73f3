#pragma once
/// A line on the terminal while something long runs; silent when standard error is not a terminal. One thread.
#include <chrono>
#include <string>

namespace halsted::app {

class Progress {
 public:
  Progress();
  ~Progress();
  void show(double simulated, const std::string& what);          // [s] at most four times a second
  void show(const std::string& what);          // the same for work that has no clock of its own

 private:
  bool due();

  bool terminal_, shown_ = false;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace halsted::app
