#include "sim/suture/hole_compliances.h"

#include "sim/lanes.h"
#include "sim/suture/holes.h"

namespace halsted {
namespace {

/// Sixty-four entries of a matrix of megabytes for each hole: most of what many holes would cost.
void lookUpCompliances(const Model& m, const StrandState& s, HoleWork& w) {
  std::array<bool, StrandState::kMaxHoles> moved{};
  for (int i = 0; i < StrandState::kMaxHoles; ++i) {
    const TissuePoint place = i < s.holeCount ? placeOf(s.holes[i]) : TissuePoint{};
    moved[i] = !(place == w.seen[i]);
    w.seen[i] = place;
    if (moved[i] && i < s.holeCount) w.self[i] = complianceBetween(m, place, place);
  }
  for (int i = 0; i < s.holeCount; ++i)
    for (int j = i + 1; j < s.holeCount && j <= i + HoleWork::kNeighbours; ++j)
      if (moved[i] || moved[j]) w.shared[i][j - i - 1] = magnitude(complianceBetween(m, w.seen[i], w.seen[j]));
}

}  // namespace

void holeCompliances(const Model& m, const StrandState& s, HoleWork& w) {
  constexpr double kFarShare = 0.06;           // [1] of the own compliance per farther hole; tuned: rings of 20 holes converge
  lookUpCompliances(m, s, w);
  for (int i = 0; i < s.holeCount; ++i) w.bound[i] = w.self[i] * (1.0 + kFarShare * s.holeCount);
  for (int i = 0; i < s.holeCount; ++i) {
    for (int j = i + 1; j < s.holeCount && j <= i + HoleWork::kNeighbours; ++j) {
      w.bound[i] += w.shared[i][j - i - 1];
      w.bound[j] += w.shared[i][j - i - 1];
    }
  }
}

}  // namespace halsted
