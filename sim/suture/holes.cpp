#include "sim/suture/holes.h"

#include <algorithm>
#include <cmath>

#include "sim/lanes.h"
#include "sim/suture/cut.h"
#include "sim/suture/exchange.h"
#include "sim/suture/hole_compliances.h"
#include "sim/suture/hole_friction.h"
#include "sim/suture/hole_limits.h"
#include "sim/suture/hole_sides.h"
#include "sim/suture/knotting.h"

namespace halsted {
namespace {

// Taut thread from bowel to bowel, straight or over a knot, slides through the holes at both its ends, and each of them would make up for
// the whole misfit. A share of it a step: at a third the pair of holes still chatters, at a tenth a drawn stitch comes to rest (tuned: the laws of AssistKnot).
constexpr double kSharedSlide = 0.1;           // [1]
// So do, along a thread with many holes, those at both ends of every stretch: past some twenty bites the misfit runs to and fro and the
// thread shakes by itself. A third of it a step ends that (tuned: `bench --stress one-body`). Fewer holes come to rest by their friction.
constexpr int kManyHoles = 18;
constexpr double kManyShare = 0.3;             // [1]
constexpr double kWithdrawForce = 0.02;        // [N] drag on a tip drawn back along its own cut (design)

StrandLink holeLink(const Model& m, const StrandState& s, int hole, const Vec3& point, double bound) {
  const Hole& h = s.holes[hole];
  StrandLink link;
  link.coordinate = h.coordinate;
  link.anchor = point;
  link.force0 = h.force;
  link.stiffness = (1.0 / bound) * Mat3::Identity();             // one division, not nine
  if (h.slip == 0) return link;
  const Vec3 t = strandTangent(m.strand, s, h.coordinate);     // sliding: only friction along the strand
  const Vec3 lateral = h.force - h.force.dot(t) * t;
  link.force0 = lateral + h.slip * frictionBound(m, s, hole) * t;
  link.stiffness -= t * t.transpose() / bound;
  return link;
}

/// Stick or slip along the strand after the solve; returns the force the hole now carries.
Vec3 settleFriction(const Model& m, State& state, int i, const Vec3& solved) {
  StrandState& s = state.strand;
  Hole& h = s.holes[i];
  const HoleWork& w = state.work.holes;
  if (const std::optional<double> creep = sumsExchange(m, state) ? creepRound(m, s, i) : std::nullopt) {
    h.slip = 0;
    if (*creep != 0.0 && !blocked(m, state, i, *creep)) h.coordinate = withinReach(m, state, i, h.coordinate + *creep);
    return solved;
  }
  const Vec3 t = strandTangent(m.strand, s, h.coordinate);
  const double along = solved.dot(t);
  if (h.slip == 0) {
    if (dragHolds(m, s, i, along)) return solved;
    const double bound = frictionBound(m, s, i);
    if (magnitude(along) <= bound || blocked(m, state, i, along)) return solved;
    h.slip = along > 0.0 ? 1 : -1;
    return solved - (along - h.slip * bound) * t;
  }
  const Vec3 point = w.point[i] - w.self[i] * (solved - h.force);
  const bool shared = leadsToOtherBowel(m, s, i, 1) || leadsToOtherBowel(m, s, i, -1) || leadsOverKnot(m, state, i);
  const double share = shared ? kSharedSlide : s.holeCount > kManyHoles ? kManyShare : 1.0;   // [1]
  const double slide = share * t.dot(point - strandPoint(m.strand, s, h.coordinate));   // [m]
  if (h.slip * slide < 0.0 || blocked(m, state, i, h.slip)) { h.slip = 0; return solved; }
  const double tip = tipCoordinate(m.strand);                  // past the tip there is no strand: the way out of the hole counts
  const double from = h.coordinate < tip ? h.coordinate : tip;
  const double wanted = from + (magnitude(slide) > kMostSlide ? h.slip * kMostSlide : slide);
  h.coordinate = withinReach(m, state, i, wanted);  // at its limit it slides on: the straight strand inside carries the pull to its neighbour
  if (h.coordinate != wanted && leadsToOtherBowel(m, s, i, h.slip)) h.slip = 0;   // no wall is there to lead it: it carries its own
  return solved;
}

/// The tip cuts forward past its resistance and slips back almost freely; returns the force it carries.
Vec3 settleTip(const Model& m, State& state, int i, const Vec3& solved, StepOutput& out) {
  StrandState& s = state.strand;
  Hole& h = s.holes[i];
  const Vec3 t = strandTangent(m.strand, s, h.coordinate);
  const double pushed = -solved.dot(t);                        // [N] forward push on the tissue
  const NeedleParams& needle = m.params.needle;
  const CutLimits limits{needle.cutForce, needle.exitForce, kWithdrawForce};
  const double excess = pushed > 0.0 ? pushed - limits.cut : pushed + limits.withdraw;
  if ((pushed > 0.0) != (excess > 0.0)) return solved;
  const CutResult cut = advanceCut(m, {state.tissue.position, state.tissue.gone}, excess * state.work.holes.bound[i] * t, h);
  if (cut == CutResult::kAtSurface && pushed > limits.exit) {
    h.role = static_cast<std::int32_t>(HoleRole::kExit);
    out.contact[0].puncture = out.contact[1].puncture = true;
    pushEvent(out, {state.step, EventKind::kNeedleExited, -1, h.bite, pushed});
    return Vec3::Zero();
  }
  return cut == CutResult::kMoved ? Vec3(solved + excess * t) : solved;
}

void removeHole(StrandState& s, int i) {
  for (int k = i + 1; k < s.holeCount; ++k) s.holes[k - 1] = s.holes[k];
  s.holes[--s.holeCount] = Hole{};
}

void addNodal(const Model& m, const Hole& h, const Vec3& f, std::vector<Vec3>& nodal) {
  for (int c = 0; c < 4; ++c) nodal[m.tissue.tets[h.tet][c]] -= h.weight[c] * f;
}

void dropHole(const Model& m, State& state, int i) {
  addNodal(m, state.strand.holes[i], -state.strand.holes[i].force, state.work.change);
  removeHole(state.strand, i);
}

void dropBite(const Model& m, State& state, int bite) {
  for (int i = state.strand.holeCount - 1; i >= 0; --i)
    if (state.strand.holes[i].bite == bite) dropHole(m, state, i);
}

/// Has a tip drawn back come so near to its entry that the channel is no longer than the needle is thick? Then nothing holds it.
bool drawnBackOut(const Model& m, const StrandState& s, int entry) {
  if (entry + 1 >= s.holeCount || s.holes[entry].role != static_cast<std::int32_t>(HoleRole::kEntry)) return false;
  const Hole& tip = s.holes[entry + 1];
  if (tip.role != static_cast<std::int32_t>(HoleRole::kTip) || tip.bite != s.holes[entry].bite) return false;
  const bool pulled = tip.force.dot(strandTangent(m.strand, s, tip.coordinate)) > 0.0;
  return pulled && tip.coordinate - s.holes[entry].coordinate < 2.0 * m.strand.needle.wireRadius;
}

/// Holes that tore, that the tail left, and that the tip left going backwards: an exit becomes the tip's cut again, an entry closes.
void removeLeftHoles(const Model& m, State& state, StepOutput& out) {
  StrandState& s = state.strand;
  const double tip = tipCoordinate(m.strand);
  for (int i = 0; i < s.holeCount; ++i) {
    Hole& h = s.holes[i];
    const bool atTip = h.coordinate >= tip + kOutOfHole;
    const double pull = h.force.norm();
    if (pull > m.params.needle.tearForce) {
      ++state.metrics.tears;
      pushEvent(out, {state.step, EventKind::kChannelTorn, -1, h.bite, pull});
      dropBite(m, state, h.bite);
      return;
    }
    if (h.coordinate <= 0.0 || partedAt(m, state, h.coordinate)) {
      pushEvent(out, {state.step, EventKind::kChannelEmptied, -1, h.bite, 0.0});
      dropHole(m, state, i);
      return;
    }
    if (atTip && (h.role == static_cast<std::int32_t>(HoleRole::kExit) || h.role == static_cast<std::int32_t>(HoleRole::kPassed))) {
      h.role = static_cast<std::int32_t>(HoleRole::kTip);
      h.coordinate = tip;
      h.slip = 0;
    } else if (drawnBackOut(m, s, i)) {
      pushEvent(out, {state.step, EventKind::kChannelEmptied, -1, h.bite, 0.0});
      dropBite(m, state, h.bite);
      return;
    }
  }
}

}  // namespace

double capstanExcess(const Vec3& before, const Vec3& after, double friction) {
  const Vec3 middle = before + after;                          // half the turn: its chord is short enough for the series
  const double size = middle.norm();
  const double c = size > 1e-9 ? (after - middle / size).norm() : 1.41421356237309515;    // [1] phi = 4 asin(c / 2)
  const double phi = 2.0 * c * (1.0 + c * c * (1.0 / 24.0 + c * c * (3.0 / 640.0 + c * c * (5.0 / 7168.0))));   // [rad]
  const double x = friction * phi;
  return x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x * (1.0 / 24.0 + x / 120.0))));
}

Vec3 holePoint(const Model& m, const Hole& h, std::span<const Vec3> x) { return pointOf(m, placeOf(h), x); }

namespace {

void listBites(const StrandState& s, HoleWork& w) {
  w.count = s.holeCount;
  w.aloneCount = 0;
  for (int i = 0; i < s.holeCount; ++i) {
    w.coordinate[i] = s.holes[i].coordinate;
    w.paired[i] = i + 1 < s.holeCount && s.holes[i].bite == s.holes[i + 1].bite;
    if (!w.paired[i] && (i == 0 || !w.paired[i - 1])) w.alone[w.aloneCount++] = i;
  }
}

/// An end of the thread is in the wall, on its way through: one hole is left of that bite, and the thread from it to its end is inside.
bool insideWithItsEnd(const Model& m, const State& state, int i, double coordinate, double margin) {   // [m]
  const Hole& h = state.strand.holes[i];
  if (static_cast<HoleRole>(h.role) == HoleRole::kEntry)         // what lies toward the needle is inside
    return coordinate > h.coordinate - margin && coordinate <= threadEnd(m, state, h.coordinate);
  return coordinate < h.coordinate + margin && h.coordinate <= threadEnd(m, state, coordinate);
}

}  // namespace

bool insideWall(const Model& m, const State& state, double coordinate, double margin) {
  const HoleWork& w = state.work.holes;
  for (int k = 0; k < w.aloneCount; ++k)
    if (insideWithItsEnd(m, state, w.alone[k], coordinate, margin)) return true;
  const auto begin = w.coordinate.begin(), end = begin + w.count;
  const auto next = std::partition_point(begin, end, [&](double hole) { return hole + margin <= coordinate; });
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, next - begin - 1); i < w.count && w.coordinate[i] - margin < coordinate; ++i)
    if (w.paired[i] && w.coordinate[i + 1] + margin > coordinate) return true;
  return false;
}

void gatherHoleForces(const Model& m, const StrandState& s, std::vector<Vec3>& nodal) {
  for (int i = 0; i < s.holeCount; ++i) addNodal(m, s.holes[i], s.holes[i].force, nodal);
}

void linkHoles(const Model& m, State& state) {
  StrandState& s = state.strand;
  HoleWork& w = state.work.holes;
  holeCompliances(m, s, w);
  listBites(s, w);
  if (sumsExchange(m, state)) {                // drawn tight on the tissue as a knot is, it presses on it all along
    gatherExchange(m, s, state.work.exchange);
    for (int i = 0; i < s.holeCount; ++i) w.bound[i] += movedByContacts(m, vertexOf(m, s.holes[i]), state.work.exchange);
  }
  for (int i = 0; i < s.holeCount; ++i) {
    w.point[i] = holePoint(m, s.holes[i], state.tissue.position);
    addLink(state.work.strand, holeLink(m, s, i, w.point[i], w.bound[i]));
  }
}

void settleHoles(const Model& m, State& state, StepOutput& out) {
  StrandState& s = state.strand;
  for (int i = 0; i < s.holeCount; ++i) {
    Hole& h = s.holes[i];
    const Vec3 solved = state.work.strand.links[i].force;
    const bool tip = h.role == static_cast<std::int32_t>(HoleRole::kTip);
    addNodal(m, h, -h.force, state.work.change);
    h.force = tip ? settleTip(m, state, i, solved, out) : settleFriction(m, state, i, solved);
    addNodal(m, h, h.force, state.work.change);
  }
  removeLeftHoles(m, state, out);
  rememberSides(m, state);
}

void tearHolesInGone(const Model& m, State& state, StepOutput& out) {
  StrandState& s = state.strand;
  for (int i = s.holeCount - 1; i >= 0; --i) {
    if (i >= s.holeCount || !state.tissue.gone[s.holes[i].tet]) continue;   // others of its bite went with one before
    ++state.metrics.tears;
    pushEvent(out, {state.step, EventKind::kChannelTorn, -1, s.holes[i].bite, s.holes[i].force.norm()});
    dropBite(m, state, s.holes[i].bite);
  }
}

bool openEntry(const Model& m, int triangle, const std::array<double, 3>& weight, const Vec3& normal, State& state, StepOutput& out) {
  StrandState& s = state.strand;
  if (s.holeCount + 2 > StrandState::kMaxHoles) return false;
  Hole h;
  h.tet = m.surface.triangleTet[triangle];
  for (int c = 0; c < 4; ++c)
    for (int k = 0; k < 3; ++k)
      if (m.tissue.tets[h.tet][c] == m.surface.triangles[triangle][k]) h.weight[c] = weight[k];
  h.coordinate = tipCoordinate(m.strand);
  h.bite = s.bitesBegun++;
  h.entryCosine = -strandTangent(m.strand, s, h.coordinate).dot(normal);
  h.role = static_cast<std::int32_t>(HoleRole::kEntry);
  s.holes[s.holeCount++] = h;
  h.entryCosine = 0.0;
  h.role = static_cast<std::int32_t>(HoleRole::kTip);
  s.holes[s.holeCount++] = h;
  out.contact[0].puncture = out.contact[1].puncture = true;
  pushEvent(out, {state.step, EventKind::kNeedleEntered, -1, h.bite, 0.0});
  return true;
}

void pushEvent(StepOutput& out, const Event& e) {
  if (out.eventCount < StepOutput::kMaxEvents) out.events[out.eventCount++] = e;
  else ++out.droppedEvents;
}

}  // namespace halsted
