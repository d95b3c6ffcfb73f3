#include "sim/suture/hole_limits.h"

#include <cmath>

#include "sim/join.h"
#include "sim/suture/holes.h"

namespace halsted {
namespace {

constexpr double kClearOfKnot = 0.5e-3;        // [m] a knot does not go through its hole
constexpr double kStraight = 0.9;              // [1] of the way: the tissue still answers to this step's forces, and needles are bent
constexpr double kNoThread = 0.2e-3;           // [m] between the holes of two bowels: the walls touch there, none is left to draw

bool inOtherBowel(const Model& m, const StrandState& s, int i, int other) {
  return m.bowels.count > 1 && bowelOf(m, s.holes[i]) != bowelOf(m, s.holes[other]);
}

/// Least thread between hole i and a neighbour.  [m] Two walls that touch may overlap a little: then it is none.
double leastTo(const Model& m, const State& state, int i, int other) {
  const Vec3 way = state.work.holes.point[other] - state.work.holes.point[i];   // [m]
  if (!inOtherBowel(m, state.strand, i, other)) return kStraight * way.norm();
  const Vec3 along = strandTangent(m.strand, state.strand, state.strand.holes[i].coordinate);
  return (way.dot(along) > 0.0) == (other > i) ? kStraight * way.norm() : 0.0;
}

/// Is there no thread left between this hole and the next on that side, in the other bowel? The strand inside one wall is straight and
/// carries the pull on; between two walls that touch it has no direction, and both holes must keep to the one place on it.
bool meetsOtherBowel(const Model& m, const StrandState& s, int i, int next) {
  return next >= 0 && next < s.holeCount && inOtherBowel(m, s, i, next) &&
         std::fabs(s.holes[next].coordinate - s.holes[i].coordinate) < kNoThread;
}

}  // namespace

bool leadsToOtherBowel(const Model& m, const StrandState& s, int i, int way) {
  const int next = i + way;
  return next >= 0 && next < s.holeCount && inOtherBowel(m, s, i, next);
}

bool leadsOverKnot(const Model& m, const State& state, int i) {
  const StrandState& s = state.strand;
  const bool outer = i == 0 || i + 1 == s.holeCount;
  return outer && state.assist && state.assist->placed && inOtherBowel(m, s, 0, s.holeCount - 1);
}

double withinReach(const Model& m, const State& state, int i, double wanted) {
  const StrandState& s = state.strand;
  const AssistKnot* knot = state.assist && state.assist->placed ? &*state.assist : nullptr;
  double low = -1.0, high = tipCoordinate(m.strand) + 2.0 * kOutOfHole;
  if (i > 0) low = s.holes[i - 1].coordinate + leastTo(m, state, i, i - 1);
  if (i + 1 < s.holeCount) high = s.holes[i + 1].coordinate - leastTo(m, state, i, i + 1);
  if (knot && i == 0) low = std::fmax(low, knot->tail + kClearOfKnot);
  if (knot && i + 1 == s.holeCount) high = std::fmin(high, knot->tip - kClearOfKnot);
  const double here = s.holes[i].coordinate;   // never thrown back by a neighbour that is already too near
  low = std::fmin(low, here);
  high = std::fmax(high, here);
  return wanted < low ? low : (wanted > high ? high : wanted);
}

bool blocked(const Model& m, const State& state, int i, double along) {      // [N]
  if (meetsOtherBowel(m, state.strand, i, along > 0.0 ? i + 1 : i - 1)) return true;
  if (!state.assist || !state.assist->placed) return false;
  const AssistKnot& knot = *state.assist;
  const double here = state.strand.holes[i].coordinate;
  if (along < 0.0) return i == 0 && here <= knot.tail + kClearOfKnot;
  return i + 1 == state.strand.holeCount && here >= knot.tip - kClearOfKnot;
}

}  // namespace halsted
