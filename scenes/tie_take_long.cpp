/// The long end of an instrument tie comes into the hand that winds it.
#include <cmath>

#include "scenes/tie_phases.h"
#include "scenes/tie_places.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"

namespace halsted::scenes {
namespace {

constexpr double kLoose = 0.8;                 // [1] of the way that its thread allows: so high is it lifted
constexpr double kStraight = 0.93, kEnough = 1e-3;   // [1] of its length: wound with a curl in it, thread hitches itself; [m] of tail drawn in for that at most
constexpr double kMostPull = 1.5;              // [N] with which thread is drawn through the walls
constexpr double kReach = 0.09, kPatience = 10.0;   // [m] as far as an arm draws; [s]

/// The winding hand turns upright first, or its shaft would sweep through the tissue on its way to the far side.
void beginWinding(const Scene& s) { goTo(s, standsUpright(s, kLeft) ? kLiftLong : kTurn); }

/// The winding hand has the long end.
void hasLongEnd(const Scene& s) {
  if (s.action.tail > 0.0) goTo(s, kShorten); else beginWinding(s);
}

/// Is the long end straight from its hole to the winding hand, as far as the tail lets it be drawn?
bool isStraight(const Scene& s) {
  const Vec3 hole = holePoint(s.model, longHole(s), s.state.tissue.position);   // [m]
  const double length = s.state.tools[kLeft].threadCoordinate - longHole(s).coordinate;   // [m]
  return (s.state.tools[kLeft].proxy.position - hole).norm() > kStraight * length || tailHole(s).coordinate < s.action.tail - kEnough;
}

bool hasLong(const Scene& s) { return s.state.tools[kLeft].threadCoordinate > longHole(s).coordinate; }

/// Has the winding hand taken two turns of it at once? Its grip does not feel the one that lies farther back between the jaws, and the hand would draw a tail
/// through the walls by it.
bool pinchesTwo(const Scene& s) {
  constexpr double kCurl = 8e-3;               // [m] of thread: no shorter curl goes back between the jaws
  return hasLong(s) && s.memory.knot.misses < kAttempts && pinchesAnother(s, kLeft, kCurl);
}

/// The driver is to take the long end first: the winding hand has it too far out, or twice, or opens to be free of the needle.
bool wantsNearer(const Scene& s) {
  return hasLong(s) && (holdsTooFar(s) || needleClings(s) || pinchesTwo(s)) && s.memory.knot.misses < kAttempts;
}

/// Where it takes it.  [m]
double nearerPlace(const Scene& s) {           // [m]
  const double place = hasLong(s) ? std::fmin(s.state.tools[kLeft].threadCoordinate, longPlace(s)) : longPlace(s);   // [m]
  return place - kHanging;
}

}  // namespace

/// Let fall, the long end would lie across the tail, and a throw come about that nobody meant.
void takeNearer(const Scene& s) {
  ExpertState& e = s.memory;
  if (!pickUp(s, kRight, threadGrip(s, kRight, nearerPlace(s)), kNearer)) return;
  if (!driverHoldsLong(s)) ++e.knot.misses;
  e.goal[kRight] = above(e.hand[kRight].command, 0.02);
  goTo(s, driverHoldsLong(s) ? kLiftIt : kFreeDriver);
}

/// Nothing is let fall: the driver lifts the long end that it holds, and the other hand takes what hangs from it.
void handOver(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase == kLiftIt) {
    e.hand[kLeft].jaw = 1.0;                   // or what is between the two hands would be drawn taut
    if (s.inPhase < 1.5 * s.dt) {
      const double length = s.state.tools[kRight].threadCoordinate - longHole(s).coordinate;   // [m]
      e.goal[kRight] = keepTurn(s, kRight, stitch(s) + kLoose * length * e.knot.up);
    }
    if (moveHand(s, kRight, e.goal[kRight], kMove)) goTo(s, kHang);
  } else if (takeHanging(s, kHang)) {
    e.goal[kLeft] = e.hand[kLeft].command;
    e.goal[kRight] = above(e.hand[kRight].command, 0.02);
    goTo(s, kFreeDriver);
  }
}

/// The driver and the other hand come free; the other takes the long end and lifts it.
void takeLongEnd(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase == kFreeDriver) {
    HandMotion& driver = e.hand[kRight];
    driver.jaw = s.inPhase < 0.2 ? 0.0 : 1.0;  // a squeeze unlocks a loaded driver
    if (s.inPhase > 0.5 && moveHand(s, kRight, e.goal[kRight], kMove)) goTo(s, kFreeLong);
  } else if (e.phase == kFreeLong) {
    if (s.inPhase < 1.5 * s.dt && holdsLong(s) && !needleClings(s) && !pinchesTwo(s)) { hasLongEnd(s); return; }   // that would be wound, too
    if (s.inPhase < 1.5 * s.dt && wantsNearer(s)) { s.memory.knot.misses += pinchesTwo(s); goTo(s, kNearer); return; }
    e.hand[kLeft].jaw = 1.0;
    if (s.inPhase > 0.4 && moveHand(s, kLeft, e.goal[kLeft], kMove)) goTo(s, kTakeLong);
  } else if (pickUp(s, kLeft, threadGrip(s, kLeft, longPlace(s)), kTakeLong)) {
    if (holdsLong(s) && !pinchesTwo(s)) { hasLongEnd(s); return; }
    if (++e.knot.misses > kAttempts) { failure = "the long end was not taken"; return; }
    e.goal[kLeft] = above(e.hand[kLeft].command, 0.02);
    goTo(s, kFreeLong);
  }
}

void shortenTail(const Scene& s) {
  ExpertState& e = s.memory;
  KnotPlan& k = e.knot;
  if (s.inPhase < 1.5 * s.dt) {
    e.goal[kLeft] = e.hand[kLeft].command;
    k.drawn[kLeft] = k.felt[kLeft] = 0.0;
  }
  feel(k.felt[kLeft], s.state.tools[kLeft].threadForce.norm(), s.dt, kFeelTime);
  const Vec3 way = (e.goal[kLeft].position - holePoint(s.model, longHole(s), s.state.tissue.position)).normalized();   // [1]
  k.drawn[kLeft] += std::fmax(0.0, 1.0 - k.felt[kLeft] / kMostPull) * kCareful * s.dt;
  moveHand(s, kLeft, keepTurn(s, kLeft, e.goal[kLeft].position + k.drawn[kLeft] * way), 0.1);
  const bool ready = tailHole(s).coordinate <= s.action.tail && isStraight(s);
  if (!ready && k.drawn[kLeft] < kReach && s.inPhase < kPatience) return;
  if (wantsNearer(s)) goTo(s, kNearer); else beginWinding(s);
}

}  // namespace halsted::scenes
