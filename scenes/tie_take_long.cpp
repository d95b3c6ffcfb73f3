/// The long end of an instrument tie comes into the hand that winds it.
#include "scenes/tie_phases.h"
#include "scenes/tie_places.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"

namespace halsted::scenes {
namespace {

constexpr double kLoose = 0.8;                 // [1] of the way that its thread allows: so high is it lifted

/// The winding hand turns upright first, or its shaft would sweep through the tissue on its way to the far side.
void beginWinding(const Scene& s) { goTo(s, standsUpright(s, kLeft) ? kLiftLong : kTurn); }

}  // namespace

/// Nothing is let fall: the driver lifts the long end that it holds, and the other hand takes what hangs from it.
void handOver(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase == kLiftIt) {
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
    if (s.inPhase < 1.5 * s.dt && holdsLong(s) && !needleClings(s)) { beginWinding(s); return; }   // that would be wound, too
    e.hand[kLeft].jaw = 1.0;
    if (s.inPhase > 0.4 && moveHand(s, kLeft, e.goal[kLeft], kMove)) goTo(s, kTakeLong);
  } else if (pickUp(s, kLeft, threadGrip(s, kLeft, longPlace(s)), kTakeLong)) {
    if (holdsLong(s)) { beginWinding(s); return; }
    if (++e.knot.misses > kAttempts) { failure = "the long end was not taken"; return; }
    e.goal[kLeft] = above(e.hand[kLeft].command, 0.02);
    goTo(s, kFreeLong);
  }
}

}  // namespace halsted::scenes
