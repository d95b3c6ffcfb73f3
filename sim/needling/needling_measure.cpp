/// What a step of needling is judged by: strokes, metrics (physics.md C3) and the quantities of the procedure table.
#include <algorithm>
#include <cmath>

#include "sim/needling/needling_angle.h"
#include "sim/needling/needling_scene.h"

namespace halsted {
namespace {

constexpr double kTurnBackLift = 0.5e-3;       // [m] lifting and thrusting: less is trembling
constexpr double kTurnBackTwirl = 0.3;         // [rad]
constexpr double kAtDepth = 1e-3;              // [m]

bool inSkin(const State& s) { return s.needling->layers[0].phase == LayerPhase::kPunctured; }

/// Outward speed of the hand along the needle; 0 outside.  [m/s]
double withdrawal(const BodyModel& m, const StepInput& input, const State& s) {
  return inSkin(s) ? std::max(0.0, -input.tools[m.needleHand].velocity.dot(s.needling->axis)) : 0.0;
}

void enter(const Model& m, const State& s, NeedlingMetrics& metrics) {
  metrics.entered = true;
  metrics.enteredAt = s.step * m.params.dt;
  metrics.entryOffset = (s.needling->contact - m.body->targetPlace().position).norm();
  metrics.angle = needleAngle(*m.body, s);
}

void follow(const Model& m, const StepInput& input, State& s, NeedlingMetrics& metrics) {
  const NeedlingState& n = *s.needling;
  const NeedlingParams& p = m.body->needling.params;
  const double time = s.step * m.params.dt, textbook = m.body->targetPoint().depth;   // [s], [m]
  metrics.deepest = std::max(metrics.deepest, n.depth);
  metrics.depthError = metrics.deepest - textbook;
  const bool at = n.depth > textbook - kAtDepth && n.depth < textbook + kAtDepth;
  if (at && metrics.reachedAt == 0.0) metrics.reachedAt = time;
  metrics.peakGrasp = std::max(metrics.peakGrasp, n.winding.grasp);
  metrics.peakTorque = std::max(metrics.peakTorque, std::fabs(n.winding.torque));
  metrics.peakWithdrawal = std::max(metrics.peakWithdrawal, withdrawal(*m.body, input, s));
  metrics.turned += std::fabs(n.winding.turned - metrics.lastTurned);
  metrics.lastTurned = n.winding.turned;
  followStroke({kTurnBackLift, p.liftLeast, p.liftMost}, n.depth, metrics.lifts);
  followStroke({kTurnBackTwirl, p.twirlLeast, p.twirlMost}, n.winding.turned, metrics.twirls);
}

void fillObservation(const Model& m, const StepInput& input, const State& s, StepOutput& out) {
  const BodyModel& body = *m.body;
  const NeedlingState& n = *s.needling;
  const NeedlingMetrics& metrics = *s.metrics.needling;
  const Vec3 point = body.targetPlace().position;
  const auto set = [&](Quantity q, double value) { out.seen[static_cast<int>(q)] = value; };
  int punctured = 0;
  for (const LayerState& l : n.layers) punctured += l.phase == LayerPhase::kPunctured;
  const double depth = inSkin(s) ? n.depth : 0.0;                   // [m]
  const double angle = metrics.entered ? metrics.angle : needleAngle(body, s);   // [rad]
  set(Quantity::kTipToPoint, (s.tools[body.needleHand].device.position - point).norm());
  set(Quantity::kFingerToPoint, (s.tools[body.fingerHand].device.position - point).norm());
  set(Quantity::kSkinPressed, n.fingerDepth);
  set(Quantity::kEntryOffset, metrics.entryOffset);
  set(Quantity::kNeedleDepth, depth);
  set(Quantity::kDepthError, depth - body.targetPoint().depth);
  set(Quantity::kAngleError, std::fabs(angle - body.targetPoint().angle));
  set(Quantity::kLayersPunctured, punctured);
  set(Quantity::kTwirls, metrics.twirls.counted / 2);
  set(Quantity::kLifts, metrics.lifts.counted / 2);
  set(Quantity::kNeedleGrasp, n.winding.grasp);
  set(Quantity::kWithdrawalSpeed, withdrawal(body, input, s));
  set(Quantity::kNeedleOut, metrics.left);
}

}  // namespace

void measureNeedling(const Model& m, const StepInput& input, State& s, StepOutput& out) {
  NeedlingMetrics& metrics = *s.metrics.needling;
  const bool inside = inSkin(s);
  if (inside && !metrics.entered) enter(m, s, metrics);
  if (inside && !metrics.left) follow(m, input, s, metrics);
  if (!inside && metrics.entered && !metrics.left) {
    metrics.left = true;
    metrics.leftAt = s.step * m.params.dt;
  }
  fillObservation(m, input, s, out);
}

}  // namespace halsted
