#include "sim/suture/hole_sides.h"

#include "sim/lanes.h"
#include "sim/suture/exchange.h"
#include "sim/suture/holes.h"
#include "sim/suture/strand_sample.h"

namespace halsted {
namespace {

/// The hole that leads the strand at a coordinate; nullptr: none does.  [m]
const Hole* leadingHole(const Model& m, const StrandState& s, double coordinate) {
  const Hole* best = nullptr;
  double least = kLedSegments * m.strand.segment;      // [m]
  for (int i = 0; i < s.holeCount; ++i) {
    if (s.holes[i].role == static_cast<std::int32_t>(HoleRole::kTip)) continue;
    const double off = magnitude(s.holes[i].coordinate - coordinate);   // [m]
    if (off < least) { least = off; best = &s.holes[i]; }
  }
  return best;
}

}  // namespace

bool onMucosa(const Model& m, const Hole& h) {
  return wallShare(m, placeOf(h)) > 0.5;
}

void rememberSides(const Model& m, State& state) {
  StrandState& s = state.strand;
  if (m.bowels.count < 2 || s.holeCount == 0) return;
  for (std::size_t i = 0; i < s.nearVertex.size(); ++i) {
    const std::size_t nodes = static_cast<std::size_t>(m.strand.nodes);
    const Hole* h = leadingHole(m, s, i < nodes ? m.strand.place[i] : m.strand.sampleCoordinate[i - nodes]);
    if (h == nullptr) continue;
    const bool inside = m.bowels.wallDepth[s.nearVertex[i]] > 0.5;
    if (inside != onMucosa(m, *h)) follow(m, static_cast<int>(i), vertexOf(m, *h), s);
  }
}

}  // namespace halsted
