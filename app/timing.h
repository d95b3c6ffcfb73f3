#pragma once
/// Wall-clock durations and their percentiles.
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

/// A histogram: adding allocates nothing, however long the session. Percentiles are exact to one bin, the maximum exactly.
/// One thread at a time.
class Durations {
 public:
  explicit Durations(double bin = 0.5e-6, std::size_t bins = 100'000) : bin_(bin), bins_(bins + 1, 0) {}   // [s]

  void add(double seconds) noexcept {          // [s] negative counts as 0
    const double clamped = std::max(seconds, 0.0);
    const double index = std::min(clamped / bin_, static_cast<double>(bins_.size() - 1));
    ++bins_[static_cast<std::size_t>(index)];
    ++count_;
    max_ = std::max(max_, clamped);
    total_ += clamped;
  }
  std::uint64_t count() const { return count_; }
  double total() const { return total_; }      // [s]
  Percentiles percentiles(double unit) const { // [1/s] 1e3 for ms, 1e6 for us
    return {unit * quantile(0.5), unit * quantile(0.99), unit * max_};
  }

 private:
  double quantile(double share) const {        // [1] -> [s]
    if (count_ == 0) return 0.0;
    const auto rank = static_cast<std::uint64_t>(share * static_cast<double>(count_ - 1)) + 1;
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i + 1 < bins_.size(); ++i) {
      seen += bins_[i];
      if (seen >= rank) return std::min((static_cast<double>(i) + 0.5) * bin_, max_);
    }
    return max_;                               // among those too long for the bins
  }

  double bin_;                                 // [s]
  std::vector<std::uint32_t> bins_;            // the last one holds everything longer
  std::uint64_t count_ = 0;
  double max_ = 0.0, total_ = 0.0;             // [s]
};

}  // namespace halsted::app
