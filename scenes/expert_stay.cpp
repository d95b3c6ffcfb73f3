/// After the knot: the needle is cut off with the driver's blades, and the tails are held as a stay.
#include <cmath>

#include "scenes/expert_state.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"
#include "sim/tools/cutter.h"

namespace halsted::scenes {
namespace {

constexpr double kBlades = 9.5e-3;             // [m] from the driver's tips
const Vec3 kLift(0.0, 25e-3, 15e-3);           // [m] so high that its end hangs free
constexpr double kLoose = 0.9;                 // [1] of the way that its thread allows: lifted, it does not pull on the stitch
constexpr double kByTheNeedle = 3e-3;          // [m] no nearer to it
constexpr double kSamePlace = 10e-3;           // [m] of thread: farther off it is another turn of it
constexpr double kStub = 50e-3;                // [m] of thread left at the stitch where no hand holds it
constexpr double kSlackSpeed = 0.015, kTautSpeed = 1.5e-3;   // [m/s] of slack thread; of thread that it feels: faster, two hands on one stitch see-saw
constexpr double kOff = 0.1, kTractionReach = 0.08;   // [N] felt of thread that comes by itself; [m]
constexpr double kMostGiven = 0.02;            // [m] a tail that was taken too tight is let back
constexpr double kFeelTime = 0.1, kFeel = 0.3; // [s] [N]
constexpr double kPulled = 0.85, kHeld = 2.0;  // [1] of the tension that counts as it; [s]
constexpr double kRing = 10e-3, kBelow = 8e-3, kAbove = 30e-3;   // [m] of a needle's middle from the driver's shaft; from its tips
constexpr double kLetGo = 0.3, kShakeTime = 4.0, kBeat = 0.1;   // [s] of one way of a shake
constexpr double kSwing = 15e-3, kShakeSpeed = 0.3;   // [m] [m/s]
constexpr double kAway = 30e-3, kRiseSpeed = 0.08;   // [m] up as the driver turns its tips down, [m/s]
constexpr int kAttempts = 4;

enum CutPhase { kHang, kFree = kHang + kHangingPhases, kOver, kDown, kClose, kUp, kShake };

double lastHole(const Scene& s) { return s.state.strand.holes[s.state.strand.holeCount - 1].coordinate; }   // [m]

/// Where the thread is to be cut: between the hand that holds it and the needle, where the two tails come out even.  [m]
double cutPlace(const Scene& s) {
  const double held = s.state.tools[kLeft].threadCoordinate, last = lastHole(s);   // [m]
  const double least = held > last ? held + s.action.beyondHand : last + kStub, even = last + s.state.strand.holes[0].coordinate;   // [m]
  return std::fmin(std::fmax(least + 2e-3 * s.memory.attempt, even - 4e-3 * s.memory.attempt), s.model.strand.length - kByTheNeedle);
}

/// Another turn of the thread lies between the blades: it would be cut instead.
bool wouldCutAnother(const Scene& s) {
  const int i = threadBetweenBlades(s.model, kRight, s.state);
  return i >= 0 && std::fabs(s.model.strand.place[i] - s.memory.place) > kSamePlace;
}

/// A needle may hang on the driver's jaws like a ring: there it is in the way of the next cut, and the next thing to be taken would be it.
bool needleHangsOnDriver(const Scene& s) {
  const Vec3 p = s.state.tools[kRight].proxy.inverseApply(s.state.strand.needle.apply(s.model.strand.needleCentre));   // [m]
  return p.head<2>().norm() < kRing && p.z() > -kBelow && p.z() < kAbove;
}

/// The driver turns its tips to the ground, open, so that what hangs on them slides off.
void beginShake(const Scene& s) {
  const Pose& now = s.memory.hand[kRight].command;
  const Vec3 up = -s.model.params.gravity.normalized();
  s.memory.goal[kRight] = {now.position + kAway * up, (Quat::FromTwoVectors(now.orientation * Vec3::UnitZ(), up) * now.orientation).normalized()};
  goTo(s, kShake);
}

/// Up and down, so that the needle jumps from where friction would let it creep.
bool shake(const Scene& s) {
  Pose to = s.memory.goal[kRight];
  const bool back = static_cast<int>(s.inPhase / kBeat) % 2 != 0;
  if (back) to.position += kSwing * s.model.params.gravity.normalized();
  moveHand(s, kRight, to, kShakeSpeed);
  return !needleHangsOnDriver(s) || s.inPhase > kShakeTime;
}

/// The driver opens and rises, and is shaken where the needle hangs on it; true once it is away.
bool leavesThread(const Scene& s) {
  ExpertState& e = s.memory;
  e.hand[kRight].jaw = 1.0;
  if (s.inPhase < kLetGo) return false;
  if (e.phase == kShake) return shake(s);
  const bool there = moveHand(s, kRight, e.goal[kRight], kRiseSpeed), hangs = needleHangsOnDriver(s);
  if (there && hangs) beginShake(s);
  return there && !hangs;
}

/// Where the hand that holds the long end lifts it to.  [m]
Vec3 lifted(const Scene& s) {
  const Hole& h = s.state.strand.holes[s.state.strand.holeCount - 1];
  const Vec3 from = holePoint(s.model, h, s.state.tissue.position), goal = s.memory.hand[kLeft].command.position + kLift;   // [m]
  const double most = kLoose * (s.state.tools[kLeft].threadCoordinate - h.coordinate);   // [m]
  return from + std::fmin(1.0, most / (goal - from).norm()) * (goal - from);
}

}  // namespace

/// Phase by phase: the thread that hangs from the driver is taken, so that what is cut hangs free of the walls; the driver comes free;
/// it goes over the thread, the thread between the blades, closes; up again.
bool runCut(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  HandMotion& driver = e.hand[kRight];
  if (s.state.strand.holeCount < 1) { failure = "there is no stitch in the tissue"; return false; }
  if (e.phase < kFree) {
    const bool nothing = e.phase == kHang && s.state.tools[kRight].threadCoordinate < lastHole(s);
    if (nothing || takeHanging(s, kHang)) goTo(s, kFree);
  } else if (e.phase == kFree) {
    if (s.inPhase < 1.5 * s.dt) {
      e.goal[kRight] = above(driver.command, 0.03);
      e.goal[kLeft] = e.hand[kLeft].command;
      if (s.state.tools[kLeft].threadCoordinate > lastHole(s)) e.goal[kLeft].position = lifted(s);
    }
    driver.jaw = s.inPhase < 0.2 ? 0.0 : 1.0;
    if (s.inPhase < 0.5) return false;
    const bool up = moveHand(s, kLeft, e.goal[kLeft], 0.04);
    if (!moveHand(s, kRight, e.goal[kRight], 0.08) || !up) return false;
    e.cutsBefore = s.state.knot.cuts;
    e.place = cutPlace(s);
    nextPhase(s);
  } else if (e.phase <= kClose) {
    Pose grip = threadGrip(s, kRight, e.place);
    grip.position -= kBlades * (grip.orientation * Vec3::UnitZ());
    const bool another = e.phase == kClose && s.inPhase < 1.5 * s.dt && wouldCutAnother(s);
    if (!another && !pickUp(s, kRight, grip, kOver)) return false;
    e.goal[kRight] = above(driver.command, 0.03);
    goTo(s, kUp);
  } else if (leavesThread(s)) {
    if (s.state.knot.cuts > e.cutsBefore) return true;
    if (++e.attempt >= kAttempts) { failure = "the thread was not between the blades"; return false; }
    goTo(s, kOver);
    e.place = cutPlace(s);
  }
  return false;
}

/// Both tails up and away from the wound until each hand feels its pull, and held.
bool runTraction(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase == 0) {
    for (int h = 0; h < kHands; ++h) {
      if (s.state.tools[h].threadCoordinate < 0.0) { failure = "a hand holds no tail"; return false; }
      e.goal[h] = e.hand[h].command;
    }
    e.drawn = e.felt = {};
    e.settled = 0.0;
    nextPhase(s);
  }
  bool pulled = true;
  for (int h = 0; h < kHands; ++h) {
    if (s.state.tools[h].threadCoordinate < 0.0) { failure = "a tail has slipped out of the jaws"; return false; }
    feel(e.felt[h], s.state.tools[h].threadForce.norm(), s.dt, kFeelTime);
    const double pace = std::fmax(-1.0, std::fmin(1.0, (s.action.tension - e.felt[h]) / kFeel));   // [1]
    e.drawn[h] = std::fmin(kTractionReach, std::fmax(-kMostGiven, e.drawn[h] + pace * (e.felt[h] > kOff ? kTautSpeed : kSlackSpeed) * s.dt));
    pulled = pulled && e.felt[h] > kPulled * s.action.tension;
    const Vec3 way = Vec3(h == kLeft ? -0.3 : 0.3, 0.6, 0.7).normalized();
    moveHand(s, h, {e.goal[h].position + e.drawn[h] * way, e.goal[h].orientation}, 0.1);
  }
  e.settled = pulled ? e.settled + s.dt : 0.0;
  return e.settled > kHeld;
}

}  // namespace halsted::scenes
