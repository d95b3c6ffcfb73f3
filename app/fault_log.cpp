#include "app/fault_log.h"

#include "app/run_summary.h"

namespace halsted::app {

void FaultLog::add(const State& s, double dt) {   // [s]
  const ProcedureState& p = s.procedure;
  for (int row = 0; row < kMaxProcedureSteps; ++row) {
    for (; seen_[row] < p.faults[row]; ++seen_[row]) {
      const bool tooSlow = p.late && !late_;
      late_ = late_ || tooSlow;                // one that begins in the same step is the other kind
      if (count_ < kMost) begun_[count_++] = {row, tooSlow, static_cast<double>(s.step) * dt};
    }
  }
  late_ = p.late;
}

std::vector<FaultLine> FaultLog::lines(const Model& m) const {
  std::vector<FaultLine> lines;
  for (int i = 0; i < count_; ++i) {
    const Begun& b = begun_[i];
    const ProcedureStep& step = m.procedure[b.row];
    lines.push_back({b.row, b.tooSlow ? number("took longer than %g s", step.limit) : step.faultName, b.time});
  }
  return lines;
}

}  // namespace halsted::app
