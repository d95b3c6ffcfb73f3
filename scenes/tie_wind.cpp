/// Throws of an instrument tie: the long end is wound round the driver, which fetches the tail with the loop on its jaws.
#include <cmath>

#include "scenes/tie_phases.h"
#include "scenes/tie_places.h"
#include "sim/tools/cutter.h"

namespace halsted::scenes {
namespace {

constexpr double kBack = 30e-3;                // [m] along its shaft: where the driver waits
constexpr double kWindSpeed = 3.0;             // [rad/s]
constexpr double kSnug = 0.03, kGive = 0.06, kMostGive = 0.3;   // [N] more would draw the tail into the tissue: the winding hand gives way; [m/s]
constexpr double kWider = 6e-3, kOpening = 0.4;   // [m] of thread that the opening jaws take up in a turn; [s]
constexpr double kTight = 0.15;                // [N] at the winding hand: a loop drawn tighter holds the jaws like a capstan
constexpr double kDrawsOn = 0.5, kCaught = 6.0; // [N] of thread on the driver: it goes no farther; [s] then the loop is caught on something
constexpr double kHard = 3.0, kYield = 5e-3, kYieldSpeed = 0.15;   // [N] at the winding hand, though it has given way: its thread lies otherwise than planned; [m] [m/s]
constexpr double kShortOf = 1e-3;             // [m] along the shaft: jaws take thread that lies so far before their tips, and past it the lower one digs into the wall
constexpr double kArrived = 1e-3, kSettle = 0.6;   // [m] of the jaws from the tail: the device is behind its hand; [s] pressed on tissue, it comes no nearer
constexpr double kShort = 4e-3;                // [m] that the driver, which nothing holds, is short of its place where its device stops
constexpr int kLoopTaken = 2;                  // misses of the tail: a loop that comes between the jaws again lies badly and is wound anew
constexpr double kLost = 0.6;                  // [1] of a turn less than planned: the loop has slid off

/// A winding hand that feels its thread gives way, the sooner the more it feels: a first throw bears less than a tenth of a newton.
void giveWay(const Scene& s, double snug) {    // [N]
  KnotPlan& k = s.memory.knot;
  feel(k.felt[kLeft], s.state.tools[kLeft].threadForce.norm(), s.dt, kFeelTime);
  if (k.felt[kLeft] > snug) k.given += std::fmin(kMostGive, kGive * k.felt[kLeft] / snug) * s.dt;
}

/// Has the winding hand given way as far as it has to, and does nothing draw on the jaws?
bool isLoose(const Scene& s) { return s.memory.knot.felt[kLeft] < kTight && s.memory.knot.felt[kRight] < kDrawsOn; }

/// The winding hand goes where its thread draws it.
void yieldToThread(const Scene& s) {
  Pose to = s.memory.hand[kLeft].command;
  const Vec3& pull = s.state.tools[kLeft].threadForce;   // [N]
  to.position += kYield * pull / std::fmax(kTight, pull.norm());
  moveHand(s, kLeft, to, kYieldSpeed);
}

/// The winding hand stays beside the driver and keeps the loop on its jaws.
void follow(const Scene& s) {
  giveWay(s, kSnug);
  feel(s.memory.knot.felt[kRight], s.state.tools[kRight].strandForce.norm(), s.dt, kFeelTime);
  if (s.memory.knot.felt[kLeft] > kHard) yieldToThread(s);
  else moveHand(s, kLeft, windingPose(s, s.memory.hand[kRight].command.position, wholeTurns(s)), 0.15);
}

/// Is the loop still on the driver? A turn lacks up to a quarter, as it is begun and ended beside the jaws.
bool loopLost(const Scene& s) { return woundRoundDriver(s) < s.memory.knot.throws[s.memory.knot.current].turns - kLost; }

/// Would the blades behind the open jaws cut the loop or the tail as these close? What hangs beyond the winding hand may be cut.
bool wouldBeCut(const Scene& s) {
  const int i = s.memory.hand[kRight].jaw > 0.5 ? threadBetweenBlades(s.model, kRight, s.state) : -1;
  return i >= 0 && s.model.strand.place[i] < s.state.tools[kLeft].threadCoordinate;
}

/// Has the driver closed on the loop that is wound round it?
bool tookLoop(const Scene& s) {
  const double c = s.state.tools[kRight].threadCoordinate;   // [m]
  return c > longHole(s).coordinate && c < s.state.tools[kLeft].threadCoordinate;
}

/// Winds again, while there is patience; true when it does.
bool windAgain(const Scene& s) {
  if (!(loopLost(s) || wouldBeCut(s)) || ++s.memory.knot.misses > kAttempts) return false;
  goTo(s, kUnwind);                            // back along its shaft, so that what lies between the jaws stays behind
  return true;
}

/// The driver is to stand nearer to the stitch, but not on it.
void standLower(const Scene& s) {
  if (mayStandLower(s)) s.memory.knot.lower += kCareful * s.dt;
}

/// Has the driver come to where it was sent? Where its device stops short of that, it is sent nearer to the stitch.
bool withinReach(const Scene& s) {
  const bool behind = (s.memory.hand[kRight].command.position - s.state.tools[kRight].proxy.position).norm() > kShort;
  if (behind) standLower(s);
  return !behind;
}

}  // namespace

/// The driver leaves the loop; opened inside one that is tight, its jaws would draw on the stitch, and the winding hand that stays where it is would stretch
/// what the driver draws along.
bool unwind(const Scene& s) {
  if (!jawsEmpty(s.state.tools[kRight])) s.memory.hand[kRight].jaw = 1.0;
  if (s.state.tools[kLeft].threadForce.norm() > kHard) yieldToThread(s);
  return rise(s);
}

/// The winding hand stands on its side, then the driver comes over the stitch with closed jaws, then the thread goes round.
void wind(const Scene& s) {
  ExpertState& e = s.memory;
  KnotPlan& k = e.knot;
  if (e.phase == kTurn) {
    if (moveHand(s, kLeft, upright(s, kLeft), kMove)) goTo(s, kLiftLong);
  } else if (e.phase == kLiftLong) {
    if (s.inPhase < 1.5 * s.dt) {
      k.hole = longHole(s).coordinate;
      k.swept = k.given = k.lower = k.detour = 0.0;
      k.loose = k.current > 0 && locks(s.state.knot) == 0;
      k.throwsBefore = s.state.knot.throws;
      k.turnsBefore = turns(s.state.knot);
      k.stepsMore = k.stepsSame = 0;
      k.felt = {};
    }
    giveWay(s, kTight);
    e.hand[kRight].jaw = 1.0;
    const bool caught = k.felt[kLeft] > kFirm;   // on the driver, which has left a loop and goes back: raised, the long end would draw the tail in
    if (caught) yieldToThread(s);
    const bool up = !caught && moveHand(s, kLeft, windingPose(s, driverPlace(s), 0.0), kMove);
    const bool ready = moveHand(s, kRight, driverPose(s, kBack), kMove);
    if (!up || !ready) return;
    k.detour = detour(s);
    goTo(s, kStand);
  } else if (e.phase == kStand) {
    e.hand[kRight].jaw = 0.0;
    giveWay(s, kTight);
    moveHand(s, kLeft, windingPose(s, driverPlace(s), 0.0), kMove);
    if (s.inPhase > 0.2 && !jawsEmpty(s.state.tools[kRight]) && ++k.misses <= kAttempts) { goTo(s, kUnwind); return; }
    if (s.inPhase > 0.2 && moveHand(s, kRight, driverPose(s, 0.0), kMove) && withinReach(s)) goTo(s, kWind);
  } else if (e.phase == kWind) {
    giveWay(s, kSnug);
    if (isLoose(s)) k.swept = std::fmin(wholeTurns(s), k.swept + kWindSpeed * s.dt);
    else standLower(s);                        // thread is shorter than was thought, and the hand that gives way as near to the jaws as it gets
    moveHand(s, kRight, driverPose(s, 0.0), kCareful);
    const Pose hand = windingPose(s, e.hand[kRight].command.position, k.swept);
    if (moveHand(s, kLeft, hand, 0.25) && k.swept >= wholeTurns(s)) goTo(s, kFollow);
    else if (s.inPhase > kCaught + wholeTurns(s) / kWindSpeed && ++k.misses <= kAttempts) goTo(s, kUnwind);
  }
}

/// The driver, loop round its jaws, goes to the tail, opens, takes it. A loop that has slid off on the way is wound again.
void fetchTail(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  const Pose grip = tailGrip(s);
  if (e.phase == kFollow) {
    const bool there = isLoose(s) && moveHand(s, kRight, above(grip, 8e-3), kCareful);
    follow(s);
    if (!there && s.inPhase < kCaught) return;
    if (windAgain(s)) return;
    if (there || ++e.knot.misses > kAttempts) { goTo(s, kOpen); return; }
    ++e.knot.beside;                           // drawn on, or opened in, a tight loop would draw the tail out of its stitch
    goTo(s, kUnwind);
  } else if (e.phase == kOpen) {
    double& jaw = e.hand[kRight].jaw;
    if (jaw < 1.0) e.knot.given += e.knot.throws[e.knot.current].turns * kWider / kOpening * s.dt;
    jaw = std::fmin(1.0, jaw + s.dt / kOpening);
    follow(s);
    if (s.inPhase > 0.5) goTo(s, kToTail);
  } else if (e.phase == kToTail) {
    if (s.inPhase < 1.5 * s.dt) e.goal[kRight] = above(grip, kShortOf);
    const bool sent = isLoose(s) && moveHand(s, kRight, e.goal[kRight], kCareful);
    const bool there = sent && (s.inPhase > kSettle || (s.state.tools[kRight].proxy.position - e.goal[kRight].position).norm() < kArrived);
    follow(s);
    if (((there && isLoose(s)) || s.inPhase > 2.0) && !windAgain(s)) goTo(s, kClose);
  } else {
    e.hand[kRight].jaw = std::fmax(0.0, 1.0 - s.inPhase / 0.2);
    follow(s);
    if (!wouldBeCut(s) && s.inPhase < 0.3) return;   // the tail's own end may come between the blades meanwhile
    e.knot.drawn = e.knot.felt = {};
    e.knot.settled = 0.0;
    const bool pinched = s.state.tools[kLeft].threadForce.norm() > kFirm;   // the loop has come between the jaws, too: drawn, it would pull on the stitch
    if (holdsTail(s) && !pinched) { goTo(s, kThrough); return; }
    if (++e.knot.misses > kAttempts) failure = "the tail was not taken";
    if (pinched) { goTo(s, kOpen); return; }   // where it is: raised, it would take the loop along
    e.knot.missed = tailPlace(s);
    ++e.knot.beside;
    e.hand[kRight].jaw = 1.0;                  // whatever it has taken instead
    goTo(s, tookLoop(s) && e.knot.beside % kLoopTaken == 0 ? kUnwind : kFollow);
  }
}

}  // namespace halsted::scenes
