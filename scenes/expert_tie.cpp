/// The instrument tie. The driver lies over the stitch, along the wound. The left hand holds the long end and winds it round the driver's
/// closed jaws, on the side of their tips: there it passes between driver and tissue, through the loop that the thread itself makes with
/// the tissue. (Wound about a driver that stands upright, thread only twists like a rubber band, and comes undone.) The driver opens,
/// takes the short tail, closes and draws it back through the loop; both ends are drawn apart, the long end toward the tail's side. The
/// next throw is wound from there, the other way round for a square knot, so that the hands change sides with every throw.
#include <cmath>

#include "scenes/stitch_frame.h"
#include "scenes/tie_places.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"

namespace halsted::scenes {
namespace {

constexpr double kLoose = 0.8;                 // [1] of the way that its thread allows: so high is it lifted
constexpr double kBack = 30e-3;                // [m] along its shaft: where the driver waits
constexpr double kWindSpeed = 3.0;             // [rad/s]
constexpr double kMove = 0.08, kCareful = 0.03;   // [m/s]
constexpr double kSnug = 0.03, kGive = 0.06;   // [N] more would draw the tail into the tissue: the winding hand gives way; [m/s]
constexpr double kWider = 6e-3, kOpening = 0.4;   // [m] of thread that the opening jaws take up in a turn; [s]
constexpr double kTaut = 0.5;                  // [N] at which a tail on its way up is drawn no farther
constexpr double kTailShare = 0.85;            // [1] of its length: how far from the tissue the tail is drawn up through the loop
constexpr double kAside = 10e-3, kLow = 6e-3;  // [m] from the stitch as the ends begin to be drawn; above it
constexpr double kOff = 0.1, kFirm = 0.6;      // [N] felt when there is nothing more to come; with which a loop that clings is drawn off
constexpr double kLost = 0.6;                  // [1] of a turn less than planned: the loop has slid off
constexpr double kClings = 3.0;                // [s] after which it is wound again: it has come to lie between the jaws
constexpr double kOver = 18e-3, kBeyond = 12e-3;   // [m] of the other hand above the stitch and past the tips meanwhile
constexpr double kDraw = 0.03, kDrawTaut = 5e-3;   // [m/s] of slack thread; of thread that it feels
constexpr double kHoldTail = 0.15;             // [1] of that for the tail: it is to stay short
constexpr double kReach = 0.09;                // [m] as far as an arm draws
constexpr double kFeel = 0.5, kFeelTime = 0.05;   // [N], [s]
constexpr double kLaySide = 0.5, kLayUp = 0.2; // [1] of the way toward the surgeon
constexpr double kHoldTight = 0.3;             // [s]
constexpr double kPatience = 12.0;             // [s] then it is as tight as it gets: over tissue that gives, two hands that feel each other see-saw
constexpr int kAttempts = 4;

enum Phase {
  kLook, kLiftIt, kHang, kFreeDriver = kHang + kHangingPhases, kFreeLong, kTakeLong, kTakeLongDown, kTakeLongClose,
  kTurn, kLiftLong, kStand, kWind, kFollow, kOpen, kToTail, kClose, kThrough, kUnwind, kCross, kDrawTight, kLayTail, kLetTail
};

void goTo(const Scene& s, int phase) {
  s.memory.phase = phase;
  s.memory.phaseStart = s.state.step;
}

const StrandState& strand(const Scene& s) { return s.state.strand; }

bool begin(const Scene& s, std::string& failure) {
  KnotPlan& k = s.memory.knot;
  if (strand(s).holeCount < 2) { failure = "there is no stitch in the tissue"; return false; }
  k = KnotPlan{};
  k.throws = parseThrows(s.action.tie);
  const StitchFrame f = stitchFrame(s);
  k.side = f.side;
  k.up = f.up;
  k.handle = f.front;
  for (int h = 0; h < kHands; ++h) s.memory.goal[h] = above(s.memory.hand[h].command, 0.02);
  goTo(s, driverHoldsLong(s) ? kLiftIt : s.state.tools[kRight].closed ? kFreeDriver : kFreeLong);
  return true;
}

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

/// The winding hand turns upright first, or its shaft would sweep through the tissue on its way to the far side.
void beginWinding(const Scene& s) { goTo(s, standsUpright(s, kLeft) ? kLiftLong : kTurn); }

/// The driver and the other hand come free; the other takes the long end and lifts it.
void takeLongEnd(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase == kFreeDriver) {
    HandMotion& driver = e.hand[kRight];
    driver.jaw = s.inPhase < 0.2 ? 0.0 : 1.0;  // a squeeze unlocks a loaded driver
    if (s.inPhase > 0.5 && moveHand(s, kRight, e.goal[kRight], kMove)) goTo(s, kFreeLong);
  } else if (e.phase == kFreeLong) {
    if (holdsLong(s)) { beginWinding(s); return; }
    e.hand[kLeft].jaw = 1.0;
    if (s.inPhase > 0.4 && moveHand(s, kLeft, e.goal[kLeft], kMove)) goTo(s, kTakeLong);
  } else if (pickUp(s, kLeft, threadGrip(s, kLeft, longPlace(s)), kTakeLong)) {
    if (holdsLong(s)) { beginWinding(s); return; }
    if (++e.knot.misses > kAttempts) { failure = "the long end was not taken"; return; }
    e.goal[kLeft] = above(e.hand[kLeft].command, 0.02);
    goTo(s, kFreeLong);
  }
}

/// A winding hand that feels its thread gives way.
void giveWay(const Scene& s) {
  KnotPlan& k = s.memory.knot;
  feel(k.felt[kLeft], s.state.tools[kLeft].threadForce.norm(), s.dt, kFeelTime);
  if (k.felt[kLeft] > kSnug) k.given += kGive * s.dt;
}

/// The winding hand stands on its side, then the driver comes over the stitch with closed jaws, then the thread goes round.
void wind(const Scene& s) {
  ExpertState& e = s.memory;
  KnotPlan& k = e.knot;
  if (e.phase == kTurn) {
    if (moveHand(s, kLeft, upright(s, kLeft), kMove)) goTo(s, kLiftLong);
  } else if (e.phase == kLiftLong) {
    k.swept = k.given = 0.0;
    k.felt = {};
    e.hand[kRight].jaw = 1.0;
    const bool up = moveHand(s, kLeft, windingPose(s, driverPlace(s), 0.0), kMove);
    const bool ready = moveHand(s, kRight, driverPose(s, kBack), kMove);
    if (up && ready) goTo(s, kStand);
  } else if (e.phase == kStand) {
    e.hand[kRight].jaw = 0.0;
    if (s.inPhase > 0.2 && s.state.tools[kRight].threadCoordinate >= 0.0 && ++k.misses <= kAttempts) { goTo(s, kUnwind); return; }
    if (s.inPhase > 0.2 && moveHand(s, kRight, driverPose(s, 0.0), kMove)) goTo(s, kWind);
  } else if (e.phase == kWind) {
    giveWay(s);
    k.swept = std::fmin(wholeTurns(s), k.swept + kWindSpeed * s.dt);
    const Pose hand = windingPose(s, e.hand[kRight].command.position, k.swept);
    if (moveHand(s, kLeft, hand, 0.25) && k.swept >= wholeTurns(s)) goTo(s, kFollow);
  }
}

/// The winding hand stays beside the driver and keeps the loop on its jaws.
void follow(const Scene& s) {
  giveWay(s);
  moveHand(s, kLeft, windingPose(s, s.memory.hand[kRight].command.position, wholeTurns(s)), 0.15);
}

/// Is the loop still on the driver? A turn lacks up to a quarter, as it is begun and ended beside the jaws.
bool loopLost(const Scene& s) { return woundRoundDriver(s) < s.memory.knot.throws[s.memory.knot.current].turns - kLost; }

/// Winds again, while there is patience; true when it does.
bool windAgain(const Scene& s) {
  if (!loopLost(s) || ++s.memory.knot.misses > kAttempts) return false;
  goTo(s, kUnwind);                            // back along its shaft, so that what lies between the jaws stays behind
  return true;
}

/// The driver, loop round its jaws, goes to the tail, opens, takes it. A loop that has slid off on the way is wound again.
void fetchTail(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  const Pose grip = tailGrip(s);
  if (e.phase == kFollow) {
    const bool there = moveHand(s, kRight, above(grip, 8e-3), kCareful);
    follow(s);
    if ((there || s.inPhase > 3.0) && !windAgain(s)) goTo(s, kOpen);
  } else if (e.phase == kOpen) {
    double& jaw = e.hand[kRight].jaw;
    if (jaw < 1.0) e.knot.given += e.knot.throws[e.knot.current].turns * kWider / kOpening * s.dt;
    jaw = std::fmin(1.0, jaw + s.dt / kOpening);
    follow(s);
    if (s.inPhase > 0.5) goTo(s, kToTail);
  } else if (e.phase == kToTail) {
    if (s.inPhase < 1.5 * s.dt) e.goal[kRight] = {grip.position - 1e-3 * (grip.orientation * Vec3::UnitZ()), grip.orientation};   // not after thread that gives way into soft tissue
    const bool there = moveHand(s, kRight, e.goal[kRight], kCareful);
    follow(s);
    if ((there || s.inPhase > 2.0) && !windAgain(s)) goTo(s, kClose);
  } else {
    e.hand[kRight].jaw = std::fmax(0.0, 1.0 - s.inPhase / 0.2);
    follow(s);
    if (s.inPhase < 0.3) return;
    e.knot.drawn = e.knot.felt = {};
    e.knot.settled = 0.0;
    if (holdsTail(s)) { goTo(s, kThrough); return; }
    if (++e.knot.misses > kAttempts) failure = "the tail was not taken";
    e.hand[kRight].jaw = 1.0;                  // whatever it has taken instead
    goTo(s, kFollow);
  }
}

/// The other hand draws the loop off the driver's tips, on to the tail: until it is off and there is nothing more to come.
void drawOffTips(const Scene& s) {
  KnotPlan& k = s.memory.knot;
  const double pull = s.state.tools[kLeft].threadForce.norm();   // [N]
  feel(k.felt[kLeft], pull, s.dt, kFeelTime);
  k.settled = k.felt[kLeft] > kOff ? k.settled + s.dt : 0.0;
  if (pull < kFirm) {
    k.drawn[kLeft] += kCareful * s.dt;
    const Vec3 from = stitch(s) + kOver * k.up - kBeyond * k.handle, offTips = (k.up - k.handle).normalized();   // [m], [1]
    moveHand(s, kLeft, keepTurn(s, kLeft, from + k.drawn[kLeft] * offTips), 2.0 * kCareful);
  }
  const bool on = loopOnJaws(s);
  if (on && k.settled > kClings && ++k.misses <= kAttempts) goTo(s, kUnwind);
  else if ((k.felt[kLeft] > kOff && (!on || k.settled > kClings)) || k.drawn[kLeft] > kReach) goTo(s, kCross);
}

/// The tail comes through the loop, then the hands go to their sides.
void drawThrough(const Scene& s) {
  ExpertState& e = s.memory;
  const KnotPlan& k = e.knot;
  const Vec3 p = stitch(s);
  if (e.phase == kThrough) {
    const Vec3 from = holePoint(s.model, tailHole(s), s.state.tissue.position);
    const ToolState& driver = s.state.tools[kRight];
    const double reach = kTailShare * (tailHole(s).coordinate - driver.threadCoordinate - kPerThrow * k.current);   // [m]
    const Vec3 back = from + reach * (k.handle + k.up).normalized();
    const bool taut = driver.threadForce.norm() > kTaut || s.state.tools[kLeft].threadForce.norm() > kFirm;
    const bool drawn = taut || moveHand(s, kRight, keepTurn(s, kRight, back), kCareful);
    if (!drawn) { moveHand(s, kLeft, keepTurn(s, kLeft, p + kOver * k.up - kBeyond * k.handle), kCareful); return; }
    drawOffTips(s);
  } else {
    const bool right = moveHand(s, kRight, keepTurn(s, kRight, p + kAside * k.side + kLow * k.up), kCareful);
    const bool left = moveHand(s, kLeft, keepTurn(s, kLeft, p - 2.0 * kAside * k.side + kLow * k.up), kMove);
    if (!right || !left) return;
    for (int h = 0; h < kHands; ++h) e.goal[h] = e.hand[h].command;
    e.knot.drawn = e.knot.felt = {};
    e.knot.settled = 0.0;
    goTo(s, kDrawTight);
  }
}

/// Each hand draws its end until it feels the tension; true once both have held it for a moment.
bool drawTight(const Scene& s) {
  ExpertState& e = s.memory;
  KnotPlan& k = e.knot;
  bool tight = true;
  for (int h = 0; h < kHands; ++h) {
    feel(k.felt[h], s.state.tools[h].threadForce.norm(), s.dt, kFeelTime);
    const double lack = (s.action.tension - k.felt[h]) / kFeel;   // [1]
    const double pace = std::fmax(-1.0, std::fmin(h == kRight ? kHoldTail : 1.0, lack));   // [1]
    k.drawn[h] = std::fmin(kReach, std::fmax(0.0, k.drawn[h] + pace * (k.felt[h] > kOff ? kDrawTaut : kDraw) * s.dt));
    tight = tight && (lack < 0.2 || k.drawn[h] >= kReach);
    const Vec3 way = (h == kLeft ? -1.0 : 1.0) * k.side;
    moveHand(s, h, {e.goal[h].position + k.drawn[h] * way, e.goal[h].orientation}, 0.1);
  }
  k.settled = tight ? k.settled + s.dt : 0.0;
  return k.settled > kHoldTight || s.inPhase > kPatience;
}

/// The tail is laid toward the surgeon, away from the thread between the knot and the holes, or the jaws would take that for it.
bool layTail(const Scene& s) {
  ExpertState& e = s.memory;
  const Vec3 from = stitch(s);
  if (s.inPhase < 1.5 * s.dt) {
    const double far = (e.hand[kRight].command.position - from).norm();   // [m]
    e.goal[kRight] = keepTurn(s, kRight, from + far * (kLaySide * e.knot.side + e.knot.handle + kLayUp * e.knot.up).normalized());
  }
  return moveHand(s, kRight, e.goal[kRight], kCareful);
}

/// The driver lets the tail go and rises.
bool letTailGo(const Scene& s) {
  ExpertState& e = s.memory;
  if (s.inPhase < 1.5 * s.dt) e.goal[kRight] = above(e.hand[kRight].command, 0.02);
  e.hand[kRight].jaw = 1.0;
  return s.inPhase > 0.3 && moveHand(s, kRight, e.goal[kRight], kMove);
}

/// The long end is now on the other side of the stitch.
void nextThrow(const Scene& s) {
  if (!letTailGo(s)) return;
  ++s.memory.knot.current;
  s.memory.knot.misses = 0;
  s.memory.knot.side = -s.memory.knot.side;
  goTo(s, kLiftLong);
}

}  // namespace

bool runTie(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase != kLook && strand(s).holeCount < 2) { failure = "the thread has left the tissue"; return false; }
  if (e.phase == kLook) begin(s, failure);
  else if (e.phase < kFreeDriver) handOver(s);
  else if (e.phase <= kTakeLongClose) takeLongEnd(s, failure);
  else if (e.phase <= kWind) wind(s);
  else if (e.phase <= kClose) fetchTail(s, failure);
  else if (e.phase == kUnwind) { if (letTailGo(s)) goTo(s, kLiftLong); }
  else if (e.phase <= kCross) drawThrough(s);
  else if (e.phase == kLayTail) { if (layTail(s)) goTo(s, kLetTail); }
  else if (e.phase == kLetTail) nextThrow(s);
  else if (drawTight(s)) {
    if (e.knot.current + 1 == e.knot.throws.size()) return true;
    goTo(s, kLayTail);
  }
  return false;
}

bool runLetGo(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase == 0) {
    for (int h = 0; h < kHands; ++h) e.goal[h] = above(e.hand[h].command, 0.02);
    nextPhase(s);
  }
  bool up = s.inPhase > 0.3;
  for (int h = 0; h < kHands; ++h) {
    e.hand[h].jaw = 1.0;
    if (s.inPhase > 0.3) up = moveHand(s, h, e.goal[h], kMove) && up;
  }
  return up;
}

}  // namespace halsted::scenes
