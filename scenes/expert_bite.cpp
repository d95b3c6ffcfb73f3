#include <cmath>

#include "scenes/bite_watch.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr double kDriverHold = 0.35;           // [1] of the arc from the swage: where the driver grips
constexpr double kForcepsFromTip = 2.5e-3;     // [m] of arc behind the tip: where the forceps take the needle over
constexpr double kLeadIn = 0.6, kLeadOut = 0.9, kLeadOutMost = 1.35;   // [rad] tip before the entry; past the exit
constexpr double kClear = 0.02;                // [m] needle held off the wall
constexpr double kSweepSpeed = 0.012;          // [m/s] along the arc
constexpr double kDip = 0.6e-3;                // [m] below the places
constexpr double kDeeper = 0.8e-3, kShallower = 0.5e-3;        // [m] after a needle that slid along the wall; that came out on its inside
constexpr int kAttempts = 4;
constexpr double kPressAngle = 0.2;            // [rad] past the planned entry: still not through, the surgeon presses instead of turning
constexpr double kPressSpeed = 0.012, kPressMost = 0.010;      // [m/s] [m] along the needle's point
constexpr double kFelt = 0.1, kSlant = -0.5;   // [N] the wall, by a needle that has slid along it before; [rad] at which it is pressed then: steeper, it goes right through
constexpr double kPatience = 5.0;              // [s] a place on a wall that trembles is never reached to the last bit
constexpr double kDrawSpeed = 0.02;            // [m/s] needle out along the arc
constexpr double kPullSpeed = 0.06;            // [m/s] thread through
constexpr double kStill = 1.5, kGently = 0.5;  // [s] over two cut edges, until the thread hangs still; [1] of the speeds there, it lies across them
constexpr double kMostPull = 1.5, kFeelTime = 0.03;   // [N] at which it pulls no farther; [s]
constexpr double kReach = 0.065;               // [m] an arm's move inside the device's workspace
constexpr double kCounterDepth = 2.5e-3;       // [m] from the rim: where the forceps hold the wall against the needle
constexpr double kHalfWall = 1e-3;             // [m]
constexpr int kBesides = 6;                    // places for the forceps beside the thread
constexpr double kBeside = 8.0;                // [deg] from one to the next
constexpr double kRoom = 6e-3, kRoomGained = 0.5e-3;             // [m] from the thread: no better with more; worth going farther
constexpr double kReachable = 0.5;             // [1] an opening that faces less toward the surgeon lets no forceps in: the needle goes in without

enum Phase {
  kShow, kTakeOver, kTakeOverDown, kTakeOverClose, kLeave,       // needle from forceps to driver
  kHold, kHoldDown, kHoldClose,                                  // forceps hold the rim
  kNear, kTouch, kDrive,                                         // driver brings the needle through
  kWithdraw,                                                     // through the wall: back the way it came
  kBackOff,                                                      // a miss: needle away from the wall, then near again
  kLetRim, kTakeTip, kTakeTipDown, kTakeTipClose, kDriverLeaves, // forceps take the tip
  kDraw, kPull                                                   // needle out, thread after it
};

double driverCoordinate(const Model& m) { return m.strand.length + kDriverHold * (tipCoordinate(m.strand) - m.strand.length); }

/// Tool pose for a wanted needle pose, as the hand holds it now.
Pose toolFor(const Scene& s, int hand, const Pose& needle) { return compose(needle, inverse(s.state.tools[hand].needleInTool)); }

Pose onCircle(const Scene& s, const Vec3& offset) { return needleOnCircle(s.model, s.memory.plan, s.memory.tipAngle, offset); }

double gently(const Scene& s, double speed) { return s.action.across ? kGently * speed : speed; }   // [m/s]

/// The circle as far as pressing has carried it along.
Pose onPressedCircle(const Scene& s) { return onCircle(s, s.memory.pressed * s.memory.pressAlong); }

/// A needle that slid along the wall had turned flat before the wall withstood it: the next time it is pressed in at a slant.
bool pressesAtOnce(const Scene& s) {
  const ExpertState& e = s.memory;
  return e.slid && e.tipAngle >= kSlant && (e.pressed > 0.0 || s.state.tools[kRight].needleForce.norm() > kFelt);
}

/// Turns the needle a step further, or presses while the wall only gives way. Once the wall lets it in, it springs back: what was pressed is eased off.
void turnOrPress(const Scene& s, double most) {
  ExpertState& e = s.memory;
  const double press = e.plan.entryAngle + kPressAngle;
  const bool in = entered(s.state, e.bite);
  if (in && e.slid) e.pressed = std::fmax(0.0, e.pressed - kPressSpeed * s.dt);
  if ((e.tipAngle >= press || pressesAtOnce(s)) && !in && e.pressed < kPressMost) {
    const double at = std::fmin(e.tipAngle, press);   // [rad]
    e.pressAlong = sine(at) * e.plan.out + cosine(at) * e.plan.along;
    e.pressed += kPressSpeed * s.dt;
  } else if (e.tipAngle < most) {
    e.tipAngle += kSweepSpeed / s.model.strand.needle.radius * s.dt;
  }
}

/// The needle is off the wall again: once more, lower or higher, or this surgeon cannot do it.
void again(const Scene& s, double lower, std::string& failure) {   // [m]
  ExpertState& e = s.memory;
  if (entered(s.state, e.bite) || ++e.attempt >= kAttempts) {
    failure = entered(s.state, e.bite) ? "the needle did not come out of the wall" : "the needle did not go into the wall";
    return;
  }
  e.dip += lower;
  e.pressed = 0.0;
  goTo(s, kBackOff);
}

/// Back along the arc until the wall is free of the needle, then a new bite, shallower; deeper, if it was to go through.
void withdraw(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  e.tipAngle = std::fmax(e.tipAngle - kSweepSpeed / s.model.strand.needle.radius * s.dt, e.plan.entryAngle - kLeadIn);
  const bool back = moveHand(s, kRight, toolFor(s, kRight, onPressedCircle(s)), 0.05) && e.tipAngle <= e.plan.entryAngle - kLeadIn;
  if (!back) return;
  if (!entered(s.state, e.bite)) e.bite = s.state.strand.bitesBegun;
  again(s, s.action.through ? kDeeper : -kShallower, failure);
}

/// The needle, if the left hand has it, is shown to the driver and changes hands.
void exchange(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase == kShow) {
    planCircle(s.model, s.state, s.action, e.dip, e.plan);
    e.tipAngle = e.plan.entryAngle - kLeadIn;
    if (s.state.tools[kRight].holdsNeedle) return goTo(s, kHold);
    const double away = 1.0 + 0.5 * (e.misses % 4);              // [1] missed where something is in the way: shown farther out
    const Pose shown = toolFor(s, kLeft, onCircle(s, away * (kClear * e.plan.out + 5e-3 * Vec3::UnitZ())));
    if ((moveHand(s, kLeft, shown, 0.10) && s.inPhase > 0.3) || s.inPhase > kPatience) nextPhase(s);
  } else if (e.phase <= kTakeOverClose) {
    if (!pickUp(s, kRight, gripPose(s.model, s.state.strand.needle, driverCoordinate(s.model)), kTakeOver)) return;
    const bool taken = s.state.tools[kRight].holdsNeedle;
    if (!taken) { ++e.misses; e.hand[kRight].jaw = 1.0; }
    goTo(s, taken ? kLeave : kShow);
    e.goal[kLeft] = above(e.hand[kLeft].command, 0.02);
  } else {
    e.hand[kLeft].jaw = 1.0;
    if (s.inPhase > 0.3 && moveHand(s, kLeft, e.goal[kLeft], 0.05)) nextPhase(s);
  }
}

/// Forceps on the rim just over the bite, shaft along the bowel, one jaw in the lumen.
Pose counterGrip(const Scene& s) {
  const ExpertState& e = s.memory;
  const Vec3 wall = positionOf(s.model, s.state, e.counter), out = normalOf(s.model, s.state, e.counter);
  Vec3 radial = out - out.z() * Vec3::UnitZ();
  radial.normalize();
  Mat3 axes;
  axes << radial, Vec3::UnitZ().cross(radial), Vec3::UnitZ();
  return {wall - kHalfWall * out, Quat(axes).normalized()};
}

double nearestThread(const Scene& s, const TissuePlace& place) {   // [m]
  const Vec3 p = positionOf(s.model, s.state, place);
  double least = 1e300;                        // [m]
  for (const Vec3& node : s.state.strand.position) least = std::fmin(least, (node - p).norm());
  return least;
}

/// Between two ends the thread hangs where the forceps go: they take the wall beside it.
void besideThread(const Scene& s) {
  ExpertState& e = s.memory;
  double best = -1.0;                          // [m]
  for (int i = 0; i <= kBesides; ++i) {
    const double off = (i % 2 ? 1.0 : -1.0) * ((i + 1) / 2) * kBeside;           // [deg]
    const TissuePlace place = placeOnWall(s.model, {s.action.bowel, e.plan.middleDegrees + off, kCounterDepth});
    if (place.triangle < 0) continue;
    const double room = std::fmin(kRoom, nearestThread(s, place));               // [m]
    if (room > best + kRoomGained) { best = room; e.counter = place; }
  }
}

/// The driver keeps the needle clear while the other hand takes hold of the rim.
void hold(const Scene& s) {
  ExpertState& e = s.memory;
  moveHand(s, kRight, toolFor(s, kRight, onCircle(s, kClear * e.plan.out)), 0.10);
  if (s.action.across || s.model.bowels.opening[s.action.bowel].axis.z() < kReachable) return goTo(s, kNear);
  if (s.inPhase < 1.5 * s.dt && e.phase == kHold && s.state.metrics.seam) besideThread(s);
  if (pickUp(s, kLeft, counterGrip(s), kHold)) nextPhase(s);
}

/// To the wall, and round along the arc until the tip has come out far enough to be taken.
void drive(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase == kNear) {
    planCircle(s.model, s.state, s.action, e.dip, e.plan);
    e.tipAngle = e.plan.entryAngle - kLeadIn;
    const bool near = moveHand(s, kRight, toolFor(s, kRight, onCircle(s, kClear * e.plan.out)), 0.10) && s.inPhase > (s.action.across ? kStill : 0.3);
    if (near || s.inPhase > kPatience) nextPhase(s);
  } else if (e.phase == kWithdraw) {
    withdraw(s, failure);
  } else if (e.phase == kBackOff) {
    if (moveHand(s, kRight, toolFor(s, kRight, onCircle(s, kClear * e.plan.out)), 0.06)) goTo(s, kNear);
  } else if (e.phase == kTouch) {
    if (moveHand(s, kRight, toolFor(s, kRight, onCircle(s, Vec3::Zero())), gently(s, 0.03)) && s.inPhase > 0.5) nextPhase(s);
  } else {
    const bool out = exits(s) >= (s.action.through || s.action.across ? 2 : 1) && !tipInWall(s.state);
    const double most = e.plan.exitAngle + (out ? kLeadOut : kLeadOutMost);
    turnOrPress(s, most);
    moveHand(s, kRight, toolFor(s, kRight, onPressedCircle(s)), 0.05);
    if (slidAway(s)) { e.slid = true; again(s, kDeeper, failure); }
    else if (astray(s)) goTo(s, kWithdraw);
    else if (out && e.tipAngle >= most) { e.goal[kLeft] = above(e.hand[kLeft].command, 0.02); goTo(s, kLetRim); }
    else if (!out && e.tipAngle >= most && s.inPhase > 3.0) {
      if (s.action.through) goTo(s, kWithdraw);
      else again(s, kDeeper, failure);
    }
  }
}

/// The forceps let the rim go and take the needle near its tip, the driver lets go and leaves.
void handOver(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase == kLetRim) {
    e.hand[kLeft].jaw = 1.0;
    if (s.inPhase > 0.25 && moveHand(s, kLeft, e.goal[kLeft], 0.08)) nextPhase(s);
  } else if (e.phase <= kTakeTipClose) {
    const Pose grip = gripPose(s.model, s.state.strand.needle, tipCoordinate(s.model.strand) - kForcepsFromTip);
    if (!pickUp(s, kLeft, grip, kTakeTip)) return;
    goTo(s, s.state.tools[kLeft].holdsNeedle ? kDriverLeaves : kTakeTip);
    e.goal[kRight] = above(e.hand[kRight].command, 0.03);
  } else {
    e.hand[kRight].jaw = 1.0;
    if (s.inPhase > 0.3 && moveHand(s, kRight, e.goal[kRight], 0.05)) nextPhase(s);
  }
}

/// Over two cut edges thread catches: there the hand gives it time where it feels it.  [1] of the speed
double feltPace(const Scene& s) {
  double& felt = s.memory.felt[kLeft];         // [N]
  feel(felt, s.state.tools[kLeft].needleForce.norm(), s.dt, kFeelTime);
  return s.action.across ? kGently * std::fmax(0.0, 1.0 - felt / kMostPull) : 1.0;
}

/// Out along the arc, then the thread after it.
bool drawThrough(const Scene& s) {
  ExpertState& e = s.memory;
  moveHand(s, kRight, parked(kRight), 0.15);
  if (e.phase == kDraw) {
    const double whole = e.plan.exitAngle + s.model.strand.needle.angle + 0.25;
    if (e.tipAngle < whole) e.tipAngle += kDrawSpeed / s.model.strand.needle.radius * s.dt;
    const bool there = moveHand(s, kLeft, toolFor(s, kLeft, onPressedCircle(s)), 0.05) && e.tipAngle >= whole;
    if (!there) return false;
    e.pullFrom = e.hand[kLeft].command.position;
    e.pullAlong = (e.plan.out + 0.6 * Vec3::UnitZ()).normalized();
    e.pulled = e.felt[kLeft] = 0.0;
    nextPhase(s);
    return false;
  }
  const Hole* exit = exitHole(s.state, e.bite);
  const double through = exit ? s.model.strand.length - exit->coordinate : 0.0;   // [m] of thread drawn past the exit
  if (through >= s.action.pull || e.pulled >= kReach) return true;
  e.pulled += kPullSpeed * feltPace(s) * s.dt;
  moveHand(s, kLeft, {e.pullFrom + e.pulled * e.pullAlong, e.hand[kLeft].command.orientation}, 0.2);
  return false;
}

/// Looks for the places of this bite in the anatomy; false when there are none.
bool choosePlaces(const Scene& s) {
  if (!planPlaces(s.model, s.action, s.memory.plan, &s.state)) return false;
  s.memory.counter = placeOnWall(s.model, {s.action.bowel, s.memory.plan.middleDegrees, kCounterDepth});
  return s.memory.counter.triangle >= 0;
}

}  // namespace

bool runBite(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (!e.planned) {
    if (!choosePlaces(s)) {
      failure = "the wall has no such place";
      return false;
    }
    e.bite = s.state.strand.bitesBegun;
    e.pressed = 0.0;
    e.slid = false;
    e.attempt = e.misses = 0;
    e.dip = kDip;
    e.planned = true;
  }
  const int phase = e.phase;
  if (phase <= kLeave) exchange(s);
  else if (phase <= kHoldClose) hold(s);
  else if (phase <= kBackOff) drive(s, failure);
  else if (phase <= kDriverLeaves) handOver(s);
  else return drawThrough(s);
  return false;
}

}  // namespace halsted::scenes
