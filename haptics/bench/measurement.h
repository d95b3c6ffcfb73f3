#pragma once
/// One number of the force-quality bench, with its unit and the bound that it must keep, if there is one.
/// The laws in tests/haptics assert `met`; `halsted devices --bench` prints the same numbers.
#include <string>
#include <vector>

namespace halsted::haptics::bench {

enum class Bound { kNone, kAtMost, kAtLeast };

struct Measurement {
  std::string quantity;                        // "Z-width", ...
  std::string condition;                       // what was pressed, with what hand, how fast
  double value = 0.0;                          // [unit] the one beside it
  std::string unit;
  Bound bound = Bound::kNone;
  double limit = 0.0;                          // [unit]

  bool met() const {                           // not a number meets no bound
    return bound == Bound::kNone || (bound == Bound::kAtMost ? value <= limit : value >= limit);
  }
};
using Measurements = std::vector<Measurement>;

/// "Z-width, 1 ms, normal grip: 4757 N/m, at least 1020"
std::string text(const Measurement&);

}  // namespace halsted::haptics::bench
