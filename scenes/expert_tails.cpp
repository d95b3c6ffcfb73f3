#include <cmath>

#include "scenes/expert_state.h"
#include "sim/strand/strand.h"

namespace halsted::scenes {
namespace {

constexpr double kTailReach = 0.02;            // [m] of thread between the wall and the jaws
constexpr double kTailStep = 0.012;             // [m] farther out when it was missed
constexpr double kTightenSpeed = 0.015;        // [m/s]
constexpr double kTightenReach = 0.09;         // [m] as far as the arms go apart

/// Grip on the thread at a coordinate: from the surgeon's side, jaws opening across the thread.
Pose threadGrip(const Scene& s, double coordinate) {
  const Vec3 p = strandPoint(s.model.strand, s.state.strand, coordinate);
  Vec3 t = strandTangent(s.model.strand, s.state.strand, coordinate);
  t.z() = 0.0;
  const Vec3 along = t.norm() > 0.1 ? Vec3(t.normalized()) : Vec3(Vec3::UnitY());
  Mat3 axes;
  axes << along.cross(Vec3::UnitZ()), along, Vec3::UnitZ();
  return {p, Quat(axes).normalized()};
}

/// Where to take the tail: farther out at every new attempt, for it may lie where the jaws cannot go.
double tailCoordinate(const State& s, int attempt) {
  return std::fmax(0.0, s.strand.holes[0].coordinate - kTailReach - kTailStep * (attempt % 5));
}
double needleCoordinate(const Model& m, const State& s) {
  return std::fmin(m.strand.length - 2e-3, s.strand.holes[s.strand.holeCount - 1].coordinate + kTailReach);
}

}  // namespace

/// Phases 0 to 2: the right hand takes the thread at the last exit. 3: the left lets the needle go. 4 to 6: the left takes the tail.
bool runTakeTails(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (s.state.strand.holeCount < 2) { failure = "there is no stitch in the tissue"; return false; }
  if (e.phase <= 2) {
    if (!pickUp(s, kRight, threadGrip(s, needleCoordinate(s.model, s.state)), 0)) return false;
    if (s.state.tools[kRight].threadCoordinate >= 0.0) { e.goal[kLeft] = above(e.hand[kLeft].command, 0.02); nextPhase(s); }
    else { e.hand[kRight].jaw = 1.0; e.phase = 0; e.phaseStart = s.state.step; }
  } else if (e.phase == 3) {
    e.hand[kLeft].jaw = 1.0;
    if (s.inPhase > 0.3 && moveHand(s, kLeft, e.goal[kLeft], 0.08)) nextPhase(s);
  } else {
    if (!pickUp(s, kLeft, threadGrip(s, tailCoordinate(s.state, e.attempt)), 4)) return false;
    if (s.state.tools[kLeft].threadCoordinate >= 0.0) return true;
    e.hand[kLeft].jaw = 1.0;
    ++e.attempt;
    e.phase = 4;
    e.phaseStart = s.state.step;
  }
  return false;
}

/// Both tails are drawn apart, crossed as for a knot: each hand pulls over the other's hole, so the gap between them closes too.
bool runTighten(const Scene& s, std::string&) {
  ExpertState& e = s.memory;
  const auto& strand = s.state.strand;
  if (e.phase == 0) {
    for (int h = 0; h < kHands; ++h) e.goal[h] = e.hand[h].command;
    e.pulled = 0.0;
    nextPhase(s);
  }
  const double first = strandTension(s.model.strand, strand, strand.holes[0].coordinate, -1);
  const double last = strandTension(s.model.strand, strand, strand.holes[strand.holeCount - 1].coordinate, 1);
  const bool tight = std::fmin(first, last) >= s.action.tension;
  if (!tight && e.pulled < kTightenReach) e.pulled += kTightenSpeed * s.dt;
  const Vec3 toLeft = Vec3(-1.0, -0.35, 0.25).normalized(), toRight = Vec3(1.0, -0.35, 0.25).normalized();
  moveHand(s, kLeft, {e.goal[kLeft].position + e.pulled * toLeft, e.goal[kLeft].orientation}, 0.1);
  moveHand(s, kRight, {e.goal[kRight].position + e.pulled * toRight, e.goal[kRight].orientation}, 0.1);
  return (tight || e.pulled >= kTightenReach) && s.inPhase > 1.5;
}

}  // namespace halsted::scenes
