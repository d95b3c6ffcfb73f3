#pragma once
/// A procedure table that a test goes through with what it says is seen.
#include <vector>

#include "sim/procedure.h"

namespace halsted {

inline constexpr double kDt = 1e-3;            // [s]

struct Rehearsal {
  std::vector<ProcedureStep> table;
  ProcedureState state{};
  Observation seen{};
  int step = 0;

  double& operator[](Quantity q) { return seen[static_cast<int>(q)]; }
  ProcedureEvent once() { return advance(table, seen, kDt * ++step, kDt, state); }
  int countEvents(int steps, ProcedureEvent wanted) {
    int count = 0;
    for (int i = 0; i < steps; ++i) count += once() == wanted;
    return count;
  }
};

}  // namespace halsted
