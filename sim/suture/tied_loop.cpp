#include "sim/suture/tied_loop.h"

#include <algorithm>
#include <span>

#include "sim/model.h"
#include "sim/state.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"
#include "sim/suture/knotting.h"

namespace halsted {
namespace {

constexpr double kTaut = 0.01;                 // [N]

const Hole& firstHole(const State& s) { return s.strand.holes[0]; }
const Hole& lastHole(const State& s) { return s.strand.holes[s.strand.holeCount - 1]; }

bool needleInTissue(const Model& m, const State& s) {
  return lastHole(s).coordinate > m.strand.length || lastHole(s).role == static_cast<std::int32_t>(HoleRole::kTip);
}

std::optional<TiedLoop> tiedLoop(const State& s) {
  if (s.assist && s.assist->locked) return TiedLoop{s.assist->tail, s.assist->tip};
  const KnotState& k = s.knot;
  if (!k.complete || locks(k) < 1) return std::nullopt;
  return TiedLoop{std::clamp(k.tail, 0.0, firstHole(s).coordinate), std::max(k.tip, lastHole(s).coordinate)};
}

/// Of the segments between two coordinates; of that at the first where they are one.  [N]
double meanTension(const Model& m, const State& s, double from, double to) {   // [m]
  const int a = threadSpot(m.strand, from).node, b = threadSpot(m.strand, to).node;
  double sum = 0.0;                            // [N]
  for (int i = a; i <= b; ++i) sum += std::max(0.0, s.strand.tension[i]);
  return sum / (b - a + 1);
}

double apart(const Model& m, const State& s, const Hole& a, const Hole& b) {   // [m]
  return (holePoint(m, a, s.tissue.position) - holePoint(m, b, s.tissue.position)).norm();
}

}  // namespace

std::optional<TiedLoop> finishedLoop(const Model& m, const State& s) {
  if (s.strand.holeCount < 2 || needleInTissue(m, s)) return std::nullopt;
  const std::optional<TiedLoop> loop = tiedLoop(s);
  if (!loop) return std::nullopt;
  const double end = threadEnd(m, s, lastHole(s).coordinate);    // [m]
  return end < m.strand.length && end > loop->tip ? loop : std::nullopt;
}

double loopPull(const Model& m, const State& s, const TiedLoop& loop) {
  return std::min(meanTension(m, s, loop.tail, firstHole(s).coordinate), meanTension(m, s, lastHole(s).coordinate, loop.tip));
}

double loopTension(const Model& m, const State& s, const TiedLoop& loop) { return meanTension(m, s, loop.tail, loop.tip); }

bool isTaut(const Model& m, const State& s, const TiedLoop& loop) { return loopPull(m, s, loop) > kTaut; }

double threadBeyondWay(const Model& m, const State& s, const TiedLoop& loop) {
  const std::span<const Hole> holes(s.strand.holes.data(), static_cast<std::size_t>(s.strand.holeCount));
  double beyond = firstHole(s).coordinate - loop.tail + loop.tip - lastHole(s).coordinate - apart(m, s, firstHole(s), lastHole(s));   // [m]
  for (std::size_t i = 1; i + 1 < holes.size(); i += 2) beyond += holes[i + 1].coordinate - holes[i].coordinate - apart(m, s, holes[i], holes[i + 1]);
  return beyond;
}

double loopSlack(const Model& m, const State& s, const TiedLoop& loop) {
  return isTaut(m, s, loop) ? 0.0 : std::max(0.0, threadBeyondWay(m, s, loop));
}

}  // namespace halsted
