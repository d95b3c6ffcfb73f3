#pragma once
/// A session's report as one self-contained HTML page: procedure, metrics, force on each hand over time, what happened.
#include <array>
#include <string>
#include <vector>

#include "app/run_summary.h"
#include "sim/exchange.h"

namespace halsted::app {

/// Gathered while a run goes on, a hundred samples a second.
class Trace {
 public:
  explicit Trace(double dt) : every_(dt < 10e-3 ? static_cast<std::uint64_t>(10e-3 / dt + 0.5) : 1), dt_(dt) {}   // [s]
  void add(const State&, const Event* events, int count);

  struct Sample { double time; std::array<double, kHands> force; };   // [s], [N] largest since the last sample
  const std::vector<Sample>& samples() const { return samples_; }
  const std::vector<Event>& events() const { return events_; }
  double dt() const { return dt_; }            // [s]

 private:
  std::uint64_t every_;
  double dt_;                                  // [s]
  std::array<double, kHands> peak_{};          // [N]
  std::vector<Sample> samples_;
  std::vector<Event> events_;
};

std::string reportHtml(const RunSummary&, const Trace&);
/// Throws SystemFault when the file cannot be written.
void writeReport(const std::string& path, const RunSummary&, const Trace&);

}  // namespace halsted::app
