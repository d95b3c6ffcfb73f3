#include "sim/needling/needling_scene.h"

#include <algorithm>

#include "sim/needling/needling_angle.h"
#include "sim/suture/holes.h"

namespace halsted {
namespace {

/// A hand that is pushed harder than it can push gives way, and feels no more than that.
void giveWay(double strength, LocalContact& contact) {           // [N]
  const double pushed = contact.force.norm();  // [N]
  if (pushed <= strength) return;
  const Vec3 way = contact.force / pushed;     // [1]
  const Mat3 across = Mat3::Identity() - way * way.transpose();
  contact.force = strength * way;
  contact.stiffness = across * contact.stiffness * across;
}

void takeTool(const ToolSample& sample, const LocalContact& contact, ToolState& t) {
  t.device = t.proxy = sample.pose;            // the tissue moves the hand, not the needle in it
  t.jaw = sample.jaw;
  t.force = contact.force;
}

void pushEvents(const State& s, int hand, const NeedlingOutput& result, StepOutput& out) {
  if (result.punctured == 0) pushEvent(out, {s.step, EventKind::kNeedleEntered, hand, 0, result.lostSurfaceForce});
  if (result.punctured > 0) pushEvent(out, {s.step, EventKind::kLayerPunctured, hand, result.punctured, result.lostSurfaceForce});
  if (result.leftSkin) pushEvent(out, {s.step, EventKind::kNeedleExited, hand, 0, 0.0});
}

/// The needle as it is drawn: inside, on its own line, turned as the hand turns it.
Pose needlePose(const BodyModel& m, const State& s) {
  const Pose& hand = s.tools[m.needleHand].device;
  const NeedlingState& n = *s.needling;
  if (n.layers[0].phase != LayerPhase::kPunctured) return hand;
  const Quat onto = turnOnto(hand.orientation * Vec3::UnitZ(), Vec3(-n.axis));
  return {n.entry + n.depth * n.axis, (onto * hand.orientation).normalized()};
}

}  // namespace

void beginNeedling(const Model& m, State& s) {
  s.needling = needlingState(m.body->needling);
  s.needling->skinUnit = s.needling->fingerUnit = m.body->targetPlace().unit;
  s.metrics.needling = NeedlingMetrics{};
}

void stepNeedling(const Model& m, const StepInput& input, State& s, StepOutput& out) {
  const BodyModel& body = *m.body;
  NeedlingOutput result;
  stepNeedling(body.needling, {input.tools[body.needleHand], input.tools[body.fingerHand]}, *s.needling, result);
  out.contact[body.needleHand] = result.needle;
  out.contact[body.fingerHand] = result.finger;
  for (int hand = 0; hand < kHands; ++hand) giveWay(m.params.tools[hand].handForce, out.contact[hand]);
  for (int hand = 0; hand < kHands; ++hand) takeTool(input.tools[hand], out.contact[hand], s.tools[hand]);
  pushEvents(s, body.needleHand, result, out);
  NeedlingMetrics& metrics = *s.metrics.needling;
  const double up = -result.needle.force.dot(s.needling->axis);   // [N] against the way in
  (up > 0.0 ? metrics.peakForce : metrics.peakPull) = std::max(up > 0.0 ? metrics.peakForce : metrics.peakPull, up > 0.0 ? up : -up);
}

void prepareNeedlingSnapshot(const Model& m, RenderSnapshot& r) { r.tissue.resize(m.body->picture.rest.size()); }

void fillNeedlingSnapshot(const Model& m, const State& s, RenderSnapshot& r) {
  const BodyModel& body = *m.body;
  const NeedlingState& n = *s.needling;
  fillPicture(body.needling, body.picture, n, r.tissue);
  r.tools[body.needleHand].pose = needlePose(body, s);
  NeedlingView& view = r.needling;
  const bool inside = n.layers[0].phase == LayerPhase::kPunctured;
  view.punctured = 0;
  for (int k = 0; k < kLayers; ++k) {
    view.punctured += n.layers[k].phase == LayerPhase::kPunctured;
    view.dimple[k] = dimple(n, k);
  }
  view.inside = n.inside;
  view.depth = n.depth;
  view.contact = inside ? n.entry : n.contact;
  view.angle = needleAngle(body, s);
  view.turned = n.winding.turned;
  view.torque = n.winding.torque;
  view.grasp = n.winding.grasp;
  view.pressed = n.fingerDepth;
}

void describeBody(const Model& m, RenderScene& scene) {
  if (!m.body) return;
  const BodyModel& body = *m.body;
  const NeedlingParams& p = body.needling.params;
  scene.tissueRest = body.picture.rest;
  scene.surface = body.picture.triangles;
  scene.triangleLayer = body.picture.look;
  scene.surfaceUv.assign(scene.tissueRest.size(), Eigen::Vector2d::Zero());
  scene.body.layers = kLayers;
  scene.body.shown = body.picture.shown;
  scene.body.cutNormal = body.picture.cutNormal;
  scene.body.target = body.target;
  for (std::size_t i = 0; i < body.points.size(); ++i)
    scene.body.points.push_back({body.points[i].id, body.points[i].name, body.places[i].position, body.places[i].normal, body.points[i].depth,
                                 body.points[i].angle});
  scene.needle = {};                           // a suture's
  scene.rods.clear();
  scene.straightNeedle = {p.needleLength, p.needleRadius, p.handleLength, p.handleRadius};
  scene.fingerRadius = p.fingerRadius;
}

}  // namespace halsted
