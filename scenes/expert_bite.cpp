#include <cmath>

#include "scenes/expert_state.h"
#include "scenes/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr double kDriverHold = 0.35;           // [1] of the arc from the swage: where the driver grips
constexpr double kForcepsFromTip = 2.5e-3;     // [m] of arc behind the tip: where the forceps take the needle over
constexpr double kLeadIn = 0.6, kLeadOut = 0.9, kLeadOutMost = 1.35;   // [rad] tip before the entry; past the exit
constexpr double kClear = 0.02;                // [m] needle held off the wall
constexpr double kSweepSpeed = 0.012;          // [m/s] along the arc
constexpr double kDrawSpeed = 0.02;            // [m/s] needle out along the arc
constexpr double kPullSpeed = 0.06;            // [m/s] thread through

double driverCoordinate(const Model& m) { return m.strand.length + kDriverHold * (tipCoordinate(m.strand) - m.strand.length); }

/// Tool pose for a wanted needle pose, as the hand holds it now.
Pose toolFor(const Scene& s, int hand, const Pose& needle) { return compose(needle, inverse(s.state.tools[hand].needleInTool)); }

Pose onCircle(const Scene& s, const Vec3& offset) { return needleOnCircle(s.model, s.memory.plan, s.memory.tipAngle, offset); }

/// The last bite's exit hole, once the tip has come out; nullptr before.
const Hole* exitHole(const State& s) {
  for (int i = s.strand.holeCount - 1; i >= 0; --i) {
    const Hole& h = s.strand.holes[i];
    if (h.bite == s.strand.bitesBegun - 1 && (h.role == static_cast<int>(HoleRole::kExit) || h.role == static_cast<int>(HoleRole::kPassed))) return &h;
  }
  return nullptr;
}

/// Phases 0 to 4: the needle, if the left hand has it, is shown to the driver and changes hands.
void exchange(const Scene& s) {
  ExpertState& e = s.memory;
  e.tipAngle = e.plan.entryAngle - kLeadIn;
  if (e.phase == 0) {
    planCircle(s.model, s.state, s.action.width, e.plan);
    e.tipAngle = e.plan.entryAngle - kLeadIn;
    if (s.state.tools[kRight].holdsNeedle) { e.phase = 5; e.phaseStart = s.state.step; return; }
    if (moveHand(s, kLeft, toolFor(s, kLeft, onCircle(s, kClear * e.plan.out + 5e-3 * Vec3::UnitZ())), 0.10) && s.inPhase > 0.3) nextPhase(s);
  } else if (e.phase <= 3) {
    if (!pickUp(s, kRight, gripPose(s.model, s.state.strand.needle, driverCoordinate(s.model)), 1)) return;
    if (s.state.tools[kRight].holdsNeedle) nextPhase(s);
    else { e.phase = 1; e.phaseStart = s.state.step; }           // missed: try again
  } else {
    e.hand[kLeft].jaw = 1.0;
    if (moveHand(s, kLeft, above(e.hand[kLeft].command, 0.2 * kSweepSpeed), 0.05) && s.inPhase > 0.4) nextPhase(s);
  }
}

/// Phases 5 to 7: to the wall, and round along the arc until the tip has come out far enough to be taken.
void drive(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase == 5) {
    moveHand(s, kLeft, parked(kLeft), 0.15);
    e.tipAngle = e.plan.entryAngle - kLeadIn;
    if (moveHand(s, kRight, toolFor(s, kRight, onCircle(s, kClear * e.plan.out)), 0.10) && s.inPhase > 0.3) nextPhase(s);
  } else if (e.phase == 6) {
    moveHand(s, kLeft, parked(kLeft), 0.15);
    planCircle(s.model, s.state, s.action.width, e.plan);
    e.tipAngle = e.plan.entryAngle - kLeadIn;
    if (moveHand(s, kRight, toolFor(s, kRight, onCircle(s, Vec3::Zero())), 0.03) && s.inPhase > 0.5) nextPhase(s);
  } else {
    const bool out = exitHole(s.state) != nullptr;
    const double most = e.plan.exitAngle + (out ? kLeadOut : kLeadOutMost);
    if (e.tipAngle < most) e.tipAngle += kSweepSpeed / s.model.strand.needle.radius * s.dt;
    moveHand(s, kRight, toolFor(s, kRight, onCircle(s, Vec3::Zero())), 0.05);
    if (out && e.tipAngle >= most) nextPhase(s);
    else if (!out && e.tipAngle >= most && s.inPhase > 4.0) failure = "the needle did not come out of the wall";
  }
}

/// Phases 8 to 11: the forceps take the needle near its tip, the driver lets go and leaves.
void handOver(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase <= 10) {
    if (!pickUp(s, kLeft, gripPose(s.model, s.state.strand.needle, tipCoordinate(s.model.strand) - kForcepsFromTip), 8)) return;
    if (s.state.tools[kLeft].holdsNeedle) {
      e.goal[kRight] = above(e.hand[kRight].command, 0.03);
      nextPhase(s);
    } else {
      e.phase = 8;
      e.phaseStart = s.state.step;
    }
    return;
  }
  e.hand[kRight].jaw = 1.0;
  if (s.inPhase < 0.3) return;
  if (moveHand(s, kRight, e.goal[kRight], 0.05)) nextPhase(s);
}

/// Phase 12: out along the arc. Phase 13: the thread after it.
bool drawThrough(const Scene& s) {
  ExpertState& e = s.memory;
  moveHand(s, kRight, parked(kRight), 0.15);
  if (e.phase == 12) {
    const double whole = e.plan.exitAngle + s.model.strand.needle.angle + 0.25;
    if (e.tipAngle < whole) e.tipAngle += kDrawSpeed / s.model.strand.needle.radius * s.dt;
    const bool there = moveHand(s, kLeft, toolFor(s, kLeft, onCircle(s, Vec3::Zero())), 0.05) && e.tipAngle >= whole;
    if (!there) return false;
    e.pullFrom = e.hand[kLeft].command.position;
    e.pullAlong = (e.plan.out + 0.6 * Vec3::UnitZ()).normalized();
    e.pulled = 0.0;
    nextPhase(s);
    return false;
  }
  const Hole* exit = exitHole(s.state);
  const double through = exit ? s.model.strand.length - exit->coordinate : 0.0;   // [m] of thread drawn past the exit
  constexpr double kReach = 0.065;             // [m] an arm's move inside the device's workspace
  if (through >= s.action.pull || e.pulled >= kReach) return true;
  e.pulled += kPullSpeed * s.dt;
  moveHand(s, kLeft, {e.pullFrom + e.pulled * e.pullAlong, e.hand[kLeft].command.orientation}, 0.2);
  return false;
}

}  // namespace

bool runBite(const Scene& s, std::string& failure) {
  if (s.memory.phase == 0 && s.inPhase == 0.0 && !planPlaces(s.model, s.action, s.memory.plan)) {
    failure = "the wall has no such place";
    return false;
  }
  if (s.memory.phase <= 4) exchange(s);
  else if (s.memory.phase <= 7) drive(s, failure);
  else if (s.memory.phase <= 11) handOver(s);
  else return drawThrough(s);
  return false;
}

}  // namespace halsted::scenes
