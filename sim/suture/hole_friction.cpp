#include "sim/suture/hole_friction.h"

#include <cmath>

#include "sim/lanes.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"

namespace halsted {
namespace {

constexpr double kNeedleFriction = 0.10;       // [1] polished steel in wet tissue, along the arc (design)

/// Length of strand inside the wall at this hole's bite: the holes of a bite follow each other.  [m]
double insideLength(const StrandState& s, int hole) {
  int first = hole, last = hole;
  while (first > 0 && s.holes[first - 1].bite == s.holes[hole].bite) --first;
  while (last + 1 < s.holeCount && s.holes[last + 1].bite == s.holes[hole].bite) ++last;
  return std::fabs(s.holes[last].coordinate - s.holes[first].coordinate);
}

/// Of what is inside, each of the two ends carries half.  [N]
double channelDrag(const Model& m, const StrandState& s, int hole) {
  return (onNeedle(m, s.holes[hole]) ? m.params.needle.shaftFriction : m.params.thread.channelDrag) * (0.5 * insideLength(s, hole));
}

}  // namespace

bool dragHolds(const Model& m, const StrandState& s, int hole, double along) { return magnitude(along) <= channelDrag(m, s, hole); }   // [N]

double frictionBound(const Model& m, const StrandState& s, int hole) {
  const Hole& h = s.holes[hole];
  const double drag = channelDrag(m, s, hole);                  // [N]
  if (onNeedle(m, h)) {
    const Vec3 t = strandTangent(m.strand, s, h.coordinate);
    const double lateral = (h.force - h.force.dot(t) * t).norm();
    return kNeedleFriction * lateral + drag;
  }
  const double least = std::fmin(strandTension(m.strand, s, h.coordinate, -1), strandTension(m.strand, s, h.coordinate, 1));   // [N]
  if (least == 0.0) return drag;               // slack on one side, whatever the turn
  const double reach = 1.5 * m.strand.segment;                 // [m] tangents are taken just outside the hole
  const double excess = capstanExcess(strandTangent(m.strand, s, h.coordinate - reach), strandTangent(m.strand, s, h.coordinate + reach),
                                      m.params.contact.threadTissueFriction);
  return least * excess + drag;
}

std::optional<double> creepRound(const Model& m, const StrandState& s, int hole) {
  const Hole& h = s.holes[hole];
  constexpr double kSharp = 0.3;               // [1] cosine of the turn
  constexpr double kCreep = 5e-5;              // [m/N] a step: some of what tissue, the softest part of the loop, gives under that force
  if (onNeedle(m, h)) return std::nullopt;
  const double reach = segmentAt(m.strand, h.coordinate);      // [m]
  const Vec3 in = strandTangent(m.strand, s, h.coordinate - reach), out = strandTangent(m.strand, s, h.coordinate + reach);
  if (in.dot(out) > kSharp) return std::nullopt;
  const double drawn = strandTension(m.strand, s, h.coordinate, 1) - strandTension(m.strand, s, h.coordinate, -1);   // [N] toward the needle
  const double excess = magnitude(drawn) - frictionBound(m, s, hole);   // [N]
  const double creep = excess > 0.0 ? std::fmin(kMostSlide, kCreep * excess) : 0.0;   // [m]
  return drawn > 0.0 ? -creep : creep;
}

}  // namespace halsted
