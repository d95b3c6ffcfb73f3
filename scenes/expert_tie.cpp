/// The instrument tie. The left hand holds the long end and winds it round the driver's closed jaws; the driver opens, takes the short
/// tail, closes and draws it back through the loop; both ends are drawn apart, the long end toward the tail's side. The next throw is
/// wound from there, the other way round for a square knot, so that the hands change sides with every throw.
#include <cmath>

#include "scenes/expert_state.h"
#include "scenes/portable_math.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"

namespace halsted::scenes {
namespace {

constexpr double kPi = 3.14159265358979312;    // [rad]
// The driver stands beside the stitch, on the tail's side, so that the thread comes to it level and does not run off the tips.
constexpr double kBeside = 15e-3, kAcross = 8e-3, kTipsUp = 4e-3;   // [m] from the stitch; out of the tail's way; above it
constexpr double kUpJaws = 9e-3;               // [m] above the tips: where the thread goes round; what the jaws grip lies lower
constexpr double kRise = 0.5;                  // [1] of the winding hand over its distance from the driver: it pulls up as the stitch pulls down
constexpr double kWindSpeed = 3.0;             // [rad/s]
constexpr double kMove = 0.08, kCareful = 0.03;   // [m/s]
constexpr double kSlack = 6e-3;                // [m] kept in the long end so that the jaws can open inside the loop
constexpr double kSnug = 0.03, kGive = 0.06;   // [N] more would draw the tail into the tissue: the winding hand gives way; [m/s]
constexpr double kPerThrow = 6e-3;             // [m] of each end that a throw takes up
constexpr double kTaut = 0.5;                  // [N] at which a tail on its way up is drawn no farther
constexpr double kLoop = 2.3e-3;               // [m] radius of a turn about the jaws
constexpr double kNearest = 6e-3;              // [m] of the winding hand from the driver
constexpr double kFromEnd = 5e-3;              // [m] of tail beyond the jaws
constexpr double kTailShare = 0.85;            // [1] of its length: how far from the tissue the tail is drawn up through the loop
constexpr double kAside = 10e-3, kLow = 6e-3;  // [m] from the stitch as the ends begin to be drawn; above it
constexpr double kDraw = 0.03;                 // [m/s]
constexpr double kReach = 0.09;                // [m] as far as an arm draws
constexpr double kFeel = 0.5, kFeelTime = 0.05;   // [N], [s]
constexpr double kHoldTight = 0.3;             // [s]
constexpr int kAttempts = 4;

enum Phase {
  kLook, kFreeDriver, kFreeLong, kTakeLong, kTakeLongDown, kTakeLongClose, kLiftLong, kStand, kWind, kFollow, kOpen, kToTail, kClose,
  kThrough, kCross, kDrawTight, kLetTail
};

void goTo(const Scene& s, int phase) {
  s.memory.phase = phase;
  s.memory.phaseStart = s.state.step;
}

const StrandState& strand(const Scene& s) { return s.state.strand; }
const Hole& tailHole(const Scene& s) { return strand(s).holes[0]; }
const Hole& longHole(const Scene& s) { return strand(s).holes[strand(s).holeCount - 1]; }

/// Middle between the two places where the ends leave the tissue.  [m]
Vec3 stitch(const Scene& s) {
  const auto& x = s.state.tissue.position;
  return 0.5 * (holePoint(s.model, tailHole(s), x) + holePoint(s.model, longHole(s), x));
}

/// Level direction from the tail's hole to the long end's.  [1]
Vec3 strandSide(const Scene& s) {
  const auto& x = s.state.tissue.position;
  Vec3 d = holePoint(s.model, longHole(s), x) - holePoint(s.model, tailHole(s), x);
  d.z() = 0.0;
  return d.norm() > 1e-4 ? Vec3(d.normalized()) : Vec3(Vec3::UnitX());
}

Vec3 turned(const Vec3& v, double angle) {     // about the surgeon's line of sight  [rad]
  const double c = cosine(angle), n = sine(angle);   // [1]
  return {c * v.x() - n * v.y(), n * v.x() + c * v.y(), v.z()};
}

/// Upright tool whose jaws open across `along`.
Pose upright(const Vec3& position, const Vec3& along) {
  const Vec3 y = along.norm() > 1e-9 ? Vec3(along.normalized()) : Vec3(Vec3::UnitY());
  Mat3 axes;
  axes << y.cross(Vec3::UnitZ()), y, Vec3::UnitZ();
  return {position, Quat(axes).normalized()};
}

Pose keepTurn(const Scene& s, int hand, const Vec3& position) { return {position, s.memory.hand[hand].command.orientation}; }

Vec3 driverPlace(const Scene& s) {
  const KnotPlan& k = s.memory.knot;
  const Vec3 across = turned(k.side, 0.5 * kPi * k.throws[k.current].sense);
  return stitch(s) - kBeside * k.side + kAcross * across + kTipsUp * Vec3::UnitZ();
}

double tailPlace(const Scene& s) { return std::fmin(kFromEnd, 0.5 * tailHole(s).coordinate); }   // [m]
double longPlace(const Scene& s) {             // [m]
  return std::fmin(longHole(s).coordinate + s.action.longEnd, s.model.strand.length - kFromEnd);
}
bool holdsLong(const Scene& s) {
  const double c = s.state.tools[kLeft].threadCoordinate;   // [m]
  return c > longHole(s).coordinate + 0.6 * s.action.longEnd && c < longHole(s).coordinate + 1.5 * s.action.longEnd;
}
bool holdsTail(const Scene& s) {
  const double c = s.state.tools[kRight].threadCoordinate;   // [m]
  return c >= 0.0 && c < tailHole(s).coordinate;
}

/// Where the winding hand is, having gone so far round the driver, with its thread all but straight. `driver`: the tips.
Vec3 windingPlace(const Scene& s, const Vec3& driver, double swept) {   // [m], [rad]
  const KnotPlan& k = s.memory.knot;
  const Vec3 out = turned(k.side, swept * k.throws[k.current].sense) + kRise * Vec3::UnitZ();
  const Vec3 loop = driver + kUpJaws * Vec3::UnitZ(), from = loop - holePoint(s.model, longHole(s), s.state.tissue.position);
  const double length = s.state.tools[kLeft].threadCoordinate - longHole(s).coordinate - kSlack - kPerThrow * k.current - k.given;   // [m]
  double distance = (length - from.norm() - kLoop * (swept - kPi)) / out.norm();                   // [m] round the driver
  if (swept < kPi) {                           // the thread does not touch it yet: |from + distance out| = length
    const double b = from.dot(out), rest = b * b - out.squaredNorm() * (from.squaredNorm() - length * length);   // [m], [m^2]
    distance = rest > 0.0 ? (std::sqrt(rest) - b) / out.squaredNorm() : kNearest;
  }
  return loop + std::fmax(kNearest, distance) * out;
}

double wholeTurns(const Scene& s) { return 2.0 * kPi * s.memory.knot.throws[s.memory.knot.current].turns; }   // [rad]

bool begin(const Scene& s, std::string& failure) {
  KnotPlan& k = s.memory.knot;
  if (strand(s).holeCount < 2) { failure = "there is no stitch in the tissue"; return false; }
  k = KnotPlan{};
  k.throws = parseThrows(s.action.tie);
  k.side = strandSide(s);
  const bool free = s.state.tools[kRight].closed;
  for (int h = 0; h < kHands; ++h) s.memory.goal[h] = above(s.memory.hand[h].command, 0.02);
  goTo(s, free ? kFreeDriver : kFreeLong);
  return true;
}

/// The driver and the other hand come free; the other takes the long end and lifts it.
void takeLongEnd(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase == kFreeDriver) {
    HandMotion& driver = e.hand[kRight];
    driver.jaw = s.inPhase < 0.2 ? 0.0 : 1.0;  // a squeeze unlocks a loaded driver
    if (s.inPhase > 0.5 && moveHand(s, kRight, e.goal[kRight], kMove)) goTo(s, kFreeLong);
  } else if (e.phase == kFreeLong) {
    if (holdsLong(s)) { goTo(s, kLiftLong); return; }
    e.hand[kLeft].jaw = 1.0;
    if (s.inPhase > 0.4 && moveHand(s, kLeft, e.goal[kLeft], kMove)) goTo(s, kTakeLong);
  } else if (pickUp(s, kLeft, threadGrip(s, kLeft, longPlace(s)), kTakeLong)) {
    if (holdsLong(s)) { goTo(s, kLiftLong); return; }
    if (++e.knot.misses > kAttempts) { failure = "the long end was not taken"; return; }
    e.goal[kLeft] = above(e.hand[kLeft].command, 0.02);
    goTo(s, kFreeLong);
  }
}

/// A winding hand that feels its thread gives way.
void giveWay(const Scene& s) {
  if (s.state.tools[kLeft].threadForce.norm() > kSnug) s.memory.knot.given += kGive * s.dt;
}

/// The winding hand stands on its side, then the driver comes beside the stitch with closed jaws, then the thread goes round.
void wind(const Scene& s) {
  ExpertState& e = s.memory;
  KnotPlan& k = e.knot;
  if (e.phase == kLiftLong) {
    k.swept = k.given = 0.0;
    e.hand[kRight].jaw = 0.0;
    const bool up = moveHand(s, kLeft, keepTurn(s, kLeft, windingPlace(s, driverPlace(s), 0.0)), kMove);
    const bool ready = moveHand(s, kRight, upright(driverPlace(s) + 0.025 * Vec3::UnitZ(), k.side), kMove);
    if (up && ready) goTo(s, kStand);
  } else if (e.phase == kStand) {
    if (moveHand(s, kRight, upright(driverPlace(s), k.side), kMove) && s.inPhase > 0.2) goTo(s, kWind);
  } else if (e.phase == kWind) {
    giveWay(s);
    k.swept = std::fmin(wholeTurns(s), k.swept + kWindSpeed * s.dt);
    const Vec3 hand = windingPlace(s, e.hand[kRight].command.position, k.swept);
    if (moveHand(s, kLeft, keepTurn(s, kLeft, hand), 0.25) && k.swept >= wholeTurns(s)) goTo(s, kFollow);
  }
}

/// The winding hand stays beside the driver and keeps the loop on its jaws.
void follow(const Scene& s) {
  giveWay(s);
  moveHand(s, kLeft, keepTurn(s, kLeft, windingPlace(s, s.memory.hand[kRight].command.position, wholeTurns(s))), 0.15);
}

/// The driver, loop round its jaws, goes to the tail, opens, takes it.
void fetchTail(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  const Pose grip = threadGrip(s, kRight, tailPlace(s));
  if (e.phase == kFollow) {
    const bool there = moveHand(s, kRight, above(grip, 8e-3), kCareful);
    follow(s);
    if (there || s.inPhase > 3.0) goTo(s, kOpen);
  } else if (e.phase == kOpen) {
    e.hand[kRight].jaw = std::fmin(1.0, s.inPhase / 0.4);
    follow(s);
    if (s.inPhase > 0.5) goTo(s, kToTail);
  } else if (e.phase == kToTail) {
    const bool there = moveHand(s, kRight, {grip.position - 1e-3 * Vec3::UnitZ(), grip.orientation}, kCareful);
    follow(s);
    if (there || s.inPhase > 2.0) goTo(s, kClose);
  } else {
    e.hand[kRight].jaw = std::fmax(0.0, 1.0 - s.inPhase / 0.2);
    follow(s);
    if (s.inPhase < 0.3) return;
    if (holdsTail(s)) { goTo(s, kThrough); return; }
    if (++e.knot.misses > kAttempts) failure = "the tail was not taken";
    goTo(s, kFollow);
  }
}

/// The tail comes up through the loop, then the hands go to their sides.
void drawThrough(const Scene& s) {
  ExpertState& e = s.memory;
  const KnotPlan& k = e.knot;
  const Vec3 p = stitch(s);
  if (e.phase == kThrough) {
    const Vec3 from = holePoint(s.model, tailHole(s), s.state.tissue.position);
    const ToolState& driver = s.state.tools[kRight];
    const double reach = kTailShare * (tailHole(s).coordinate - driver.threadCoordinate - kPerThrow * k.current);   // [m]
    const Vec3 up = from + reach * (Vec3::UnitZ() - 0.3 * k.side).normalized();
    const bool drawn = driver.threadForce.norm() > kTaut || moveHand(s, kRight, keepTurn(s, kRight, up), kCareful);
    // The long end goes on round the tail the way that it was wound: straight across it could as well unwind half a turn.
    const Vec3 on = turned(k.side, 0.5 * kPi * k.throws[k.current].sense);
    const Vec3 away = p + 1.2 * kAside * on + kLow * Vec3::UnitZ();
    moveHand(s, kLeft, keepTurn(s, kLeft, away), kCareful);
    if (drawn && s.inPhase > 0.4) goTo(s, kCross);
  } else {
    const bool right = moveHand(s, kRight, keepTurn(s, kRight, p + kAside * k.side + kLow * Vec3::UnitZ()), kCareful);
    const bool left = moveHand(s, kLeft, keepTurn(s, kLeft, p - 2.0 * kAside * k.side + kLow * Vec3::UnitZ()), kMove);
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
    k.felt[h] += s.dt / kFeelTime * (s.state.tools[h].threadForce.norm() - k.felt[h]);
    const double lack = (s.action.tension - k.felt[h]) / kFeel;   // [1]
    const double pace = std::fmax(-1.0, std::fmin(1.0, lack));    // [1]
    k.drawn[h] = std::fmin(kReach, std::fmax(0.0, k.drawn[h] + pace * kDraw * s.dt));
    tight = tight && (lack < 0.2 || k.drawn[h] >= kReach);
    const Vec3 way = (h == kLeft ? -1.0 : 1.0) * k.side;
    moveHand(s, h, {e.goal[h].position + k.drawn[h] * way, e.goal[h].orientation}, 0.1);
  }
  k.settled = tight ? k.settled + s.dt : 0.0;
  return k.settled > kHoldTight;
}

/// The driver lets the tail go and rises; the long end is now on the other side of the stitch.
void nextThrow(const Scene& s) {
  ExpertState& e = s.memory;
  if (s.inPhase < 1.5 * s.dt) e.goal[kRight] = above(e.hand[kRight].command, 0.02);
  e.hand[kRight].jaw = 1.0;
  if (s.inPhase < 0.3 || !moveHand(s, kRight, e.goal[kRight], kMove)) return;
  ++e.knot.current;
  e.knot.side = -e.knot.side;
  goTo(s, kLiftLong);
}

}  // namespace

bool runTie(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase != kLook && strand(s).holeCount < 2) { failure = "the thread has left the tissue"; return false; }
  if (e.phase == kLook) begin(s, failure);
  else if (e.phase <= kTakeLongClose) takeLongEnd(s, failure);
  else if (e.phase <= kWind) wind(s);
  else if (e.phase <= kClose) fetchTail(s, failure);
  else if (e.phase <= kCross) drawThrough(s);
  else if (e.phase == kLetTail) nextThrow(s);
  else if (drawTight(s)) {
    if (e.knot.current + 1 == e.knot.throws.size()) return true;
    goTo(s, kLetTail);
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
