#include "haptics/bench/measurement.h"

#include <cstdio>

namespace halsted::haptics::bench {

std::string text(const Measurement& m) {
  char value[64], limit[64] = "";
  std::snprintf(value, sizeof value, "%.4g %s", m.value, m.unit.c_str());
  if (m.bound != Bound::kNone) std::snprintf(limit, sizeof limit, ", at %s %.4g", m.bound == Bound::kAtMost ? "most" : "least", m.limit);
  return m.quantity + ", " + m.condition + ": " + value + limit;
}

}  // namespace halsted::haptics::bench
