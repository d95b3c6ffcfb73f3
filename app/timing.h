#pragma once
/// Wall-clock durations and their percentiles. One thread.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

namespace halsted::app {

class Stopwatch {
 public:
  double seconds() const {                     // [s] since it was made
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct Percentiles { double p50 = 0.0, p99 = 0.0, max = 0.0; };   // [unit of the samples]

class Durations {
 public:
  void reserve(std::size_t count) { samples_.reserve(count); }
  void add(double seconds) {                   // [s]
    samples_.push_back(static_cast<float>(seconds));
    total_ += seconds;
  }
  /// No heap: false when the reserved room is used up. For real-time threads.
  bool addBounded(double seconds) noexcept {   // [s]
    total_ += seconds;
    if (samples_.size() == samples_.capacity()) return false;
    samples_.push_back(static_cast<float>(seconds));
    return true;
  }
  std::size_t count() const { return samples_.size(); }
  double total() const { return total_; }      // [s]
  Percentiles percentiles(double unit) const { // [1/s] 1e3 for ms, 1e6 for us
    if (samples_.empty()) return {};
    std::vector<float> sorted = samples_;
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double share) { return unit * sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))]; };
    return {at(0.5), at(0.99), at(1.0)};
  }

 private:
  std::vector<float> samples_;                 // [s]
  double total_ = 0.0;                         // [s]
};

}  // namespace halsted::app
