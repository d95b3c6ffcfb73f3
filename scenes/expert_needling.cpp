/// The scripted acupuncturist: finds the point, presses beside it, inserts, twirls, lifts and thrusts, withdraws.
#include <cmath>

#include "scenes/expert_state.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr double kOver = 25e-3, kNear = 1.5e-3;      // [m] above the point while approaching; where it is shown as found
constexpr double kApproachSpeed = 0.05, kNearSpeed = 0.01;   // [m/s]
constexpr double kFingerSpeed = 0.02;                // [m/s]
constexpr double kPressDepth = 2e-3;                 // [m] unless the script says
constexpr double kSettle = 0.4;                      // [s] the eye settles
constexpr double kClose = 0.25e-3;                   // [m] near enough to the wanted depth: three steps of the encoder

const BodyModel& body(const Scene& s) { return *s.model.body; }
int needleHand(const Scene& s) { return body(s).needleHand; }

int pointOf(const Scene& s) {
  const BodyModel& b = body(s);
  for (std::size_t i = 0; i < b.points.size(); ++i)
    if (b.points[i].id == s.action.point) return static_cast<int>(i);
  return b.target;
}

/// The tool's frame with +z against the axis, as near as may be to how the hand stood.
Quat toolAlong(const Vec3& axis) {
  const Vec3 z = -axis, x = (std::fabs(z.x()) < 0.9 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY())).cross(z).normalized().cross(z);
  Mat3 axes;
  axes << -x, z.cross(-x), z;
  return Quat(axes).normalized();
}

void planNeedle(const Scene& s) {
  NeedlePlan& plan = s.memory.needle;
  plan.point = pointOf(s);
  Acupoint point = body(s).points[plan.point];
  if (s.action.angleDegrees > 0.0) point.angle = s.action.angleDegrees * kPi / 180.0;
  const SurfaceFrame& place = body(s).places[plan.point];
  const Vec3 along = (point.lean - point.lean.dot(place.normal) * place.normal).normalized();
  plan.entry = place.position;
  plan.axis = -sine(point.angle) * place.normal + cosine(point.angle) * along;
  plan.orientation = toolAlong(plan.axis);
}

Quat turned(const Quat& q, double angle) { return (q * Quat(cosine(0.5 * angle), 0.0, 0.0, sine(0.5 * angle))).normalized(); }   // [rad]

Pose needleAt(const Scene& s, double depth) {        // [m]
  const NeedlePlan& plan = s.memory.needle;
  return {plan.entry + depth * plan.axis, turned(plan.orientation, plan.twist)};
}

bool moveNeedle(const Scene& s, double depth, double speed) { return moveHand(s, needleHand(s), needleAt(s, depth), speed); }   // [m] [m/s]

bool find(const Scene& s) {
  if (s.memory.phase == 0) {
    planNeedle(s);
    nextPhase(s);
  } else if (s.memory.phase == 1) {
    if (moveNeedle(s, -kOver, kApproachSpeed)) nextPhase(s);
  } else if (s.memory.phase == 2) {
    if (moveNeedle(s, -kNear, kNearSpeed)) nextPhase(s);
  }
  return s.memory.phase == 3 && s.inPhase > kSettle;
}

/// The finger comes down on the skin beside the point, on its own side, and stays.
bool press(const Scene& s) {
  ExpertState& e = s.memory;
  const int hand = body(s).fingerHand;
  if (e.phase == 0) {
    const SurfaceFrame& place = body(s).places[pointOf(s)];
    const Vec3 aside = hand == kLeft ? Vec3(-Vec3::UnitX()) : Vec3(Vec3::UnitX());
    const Vec3 along = (aside - aside.dot(place.normal) * place.normal).normalized();
    const SurfaceFrame foot = nearestPoint(body(s).needling.surface[0], place.position + s.action.distance * along, place.unit, 20);
    const double depth = s.action.depth > 0.0 ? s.action.depth : kPressDepth;   // [m]
    e.goal[hand] = {foot.position - depth * foot.normal, toolAlong(-foot.normal)};
    nextPhase(s);
  } else if (e.phase == 1) {
    if (moveHand(s, hand, above(e.goal[hand], 0.01), kApproachSpeed)) nextPhase(s);
  } else if (e.phase == 2) {
    if (moveHand(s, hand, e.goal[hand], kFingerSpeed)) nextPhase(s);
  }
  return e.phase == 3 && s.inPhase > kSettle;
}

double wantedDepth(const Scene& s) { return s.action.depth > 0.0 ? s.action.depth : body(s).points[s.memory.needle.point].depth; }   // [m]

bool insert(const Scene& s, std::string& failure) {
  NeedlePlan& plan = s.memory.needle;
  if (s.memory.phase == 0) {
    planNeedle(s);
    plan.depth = wantedDepth(s);
    nextPhase(s);
  } else if (s.memory.phase == 1) {                  // held at the angle, on the point
    if (moveNeedle(s, -kNear, kNearSpeed) && s.inPhase > kSettle) nextPhase(s);
  } else if (s.memory.phase == 2) {
    const bool there = moveNeedle(s, plan.depth, s.action.speed);
    if (there && std::fabs(s.state.needling->depth - plan.depth) < kClose) nextPhase(s);
  } else if (s.inPhase > kSettle) {
    if (s.state.needling->layers[0].phase == LayerPhase::kPunctured) return true;
    failure = "the skin did not give way";
  }
  return false;
}

/// To and fro about the needle's axis, from and to where it stood.
bool twirl(const Scene& s) {
  NeedlePlan& plan = s.memory.needle;
  const double turns = s.inPhase / s.action.period;  // [1]
  const bool over = turns >= s.action.cycles;
  plan.twist = over ? 0.0 : 0.5 * s.action.twirlDegrees * kPi / 180.0 * sine(2.0 * kPi * (turns - std::floor(turns)));
  s.memory.hand[needleHand(s)].command = needleAt(s, plan.depth);
  return over;
}

bool liftThrust(const Scene& s) {
  NeedlePlan& plan = s.memory.needle;
  if (s.memory.phase == 0) {
    plan.depth = wantedDepth(s);
    if (moveNeedle(s, plan.depth, s.action.speed)) nextPhase(s);
    return false;
  }
  const double turns = s.inPhase / s.action.period;  // [1]
  const bool over = turns >= s.action.cycles;
  const double up = over ? 0.0 : 0.5 * (1.0 - cosine(2.0 * kPi * (turns - std::floor(turns))));   // [1]
  s.memory.hand[needleHand(s)].command = needleAt(s, plan.depth - up * s.action.lift);
  return over && s.inPhase > s.action.period * s.action.cycles + kSettle;
}

bool withdraw(const Scene& s) {
  ExpertState& e = s.memory;
  const int finger = body(s).fingerHand;
  if (e.phase == 0) {
    e.goal[finger] = above(e.hand[finger].command, 0.02);
    nextPhase(s);
  } else if (e.phase == 1) {
    if (moveNeedle(s, -kOver, s.action.speed)) nextPhase(s);
  } else if (e.phase == 2) {
    if (moveHand(s, finger, e.goal[finger], kFingerSpeed)) nextPhase(s);
  }
  return e.phase == 3 && s.inPhase > kSettle;
}

}  // namespace

bool runNeedling(const Scene& s, std::string& failure) {
  const std::string& kind = s.action.kind;
  if (kind == "find") return find(s);
  if (kind == "press") return press(s);
  if (kind == "insert") return insert(s, failure);
  if (s.memory.needle.point < 0) { failure = "the needle is not at a point yet"; return false; }
  if (kind == "twirl") return twirl(s);
  if (kind == "lift_thrust") return liftThrust(s);
  return withdraw(s);
}

std::array<Pose, kHands> needlingStart(const BodyModel& m) {
  const Quat upright = toolAlong(-m.targetPlace().normal);
  std::array<Pose, kHands> start;
  for (int hand = 0; hand < kHands; ++hand) start[hand] = {Vec3(hand == kLeft ? -0.05 : 0.04, 0.05, 0.03), upright};
  return start;
}

}  // namespace halsted::scenes
