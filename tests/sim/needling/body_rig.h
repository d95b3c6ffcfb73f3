#pragma once
/// The ball with three layers as a whole model: step, procedure, metrics, snapshot. Its top is the acupoint; y is up, as in a scene.
#include "sim/step.h"
#include "tests/sim/needling/needling_rig.h"

namespace halsted::testing {

inline Body ballBody(int order = 1) {
  const SimParams p;
  Body body;
  body.order = order;
  double radius = kBall;                       // [m]
  constexpr double kRootFourPi = 3.5449077018110321;   // [1]
  for (int k = 0; k < kLayers; ++k) {
    body.surface[k] = coefficients(ball(radius, order));
    body.surface[k][0] = Vec3(0, -kBall * kRootFourPi, 0);   // the top at the origin
    body.thickness[k] = p.needling.layers[k].thickness;
    radius -= body.thickness[k];
  }
  body.points.push_back({"P1", "top", Vec3(0, 1, 0), 20e-3, 1.5707963267948966, Vec3(1, 0, 0)});
  body.points.push_back({"P2", "side", Vec3(0.1, 1, 0).normalized(), 20e-3, 0.78539816339744831, Vec3(1, 0, 0)});
  return body;
}

inline SimParams needlingParams() {
  SimParams p;
  p.model = ModelKind::kNeedling;
  p.tools[kLeft].kind = ToolKind::kFinger;
  p.tools[kRight].kind = ToolKind::kAcupunctureNeedle;
  return p;
}

/// Needle upright over the top; the finger aside.
struct BodyRig {
  Model model;
  State state;
  StepInput input;
  StepOutput out;
  std::vector<Event> events;

  explicit BodyRig(const SimParams& p = needlingParams(), int order = 1) : model(buildModel(p, Anatomy{{}, ballBody(order)}, {})) {
    const Quat up = turnOnto(Vec3::UnitZ(), Vec3::UnitY());
    input.tools[kRight].pose = {Vec3(0, 5e-3, 0), up};
    input.tools[kLeft].pose = {Vec3(-0.03, 0.03, 0), up};
    state = initialState(model, {input.tools[kLeft].pose, input.tools[kRight].pose});
  }
  void step() {
    for (ToolSample& sample : input.tools) ++sample.tick;
    halsted::step(model, input, state, out);
    events.insert(events.end(), out.events.begin(), out.events.begin() + out.eventCount);
  }
  void to(int hand, const Vec3& place) {       // [m] one step
    input.tools[hand].velocity = (place - input.tools[hand].pose.position) / model.params.dt;
    input.tools[hand].pose.position = place;
    step();
  }
  /// Straight down or up to a depth at a speed.
  void go(double depth, double speed) {        // [m], [m/s]
    const double stride = speed * model.params.dt;   // [m]
    double now = -input.tools[kRight].pose.position.y();   // [m]
    while (now != depth) {
      now = std::abs(depth - now) <= stride ? depth : now + (depth > now ? stride : -stride);
      to(kRight, Vec3(0, -now, 0));
    }
  }
  void twirl(double angle, int steps) {        // [rad] there and back
    const Quat rest = input.tools[kRight].pose.orientation;
    for (int k = 1; k <= steps; ++k) {
      const double half = 0.25 * angle * (1.0 - std::cos(6.28318530717958648 * k / steps));   // [rad]
      input.tools[kRight].pose.orientation = rest * Quat(std::cos(half), 0, 0, std::sin(half));
      to(kRight, input.tools[kRight].pose.position);
    }
  }
  double seen(Quantity q) const { return out.seen[static_cast<int>(q)]; }
  int count(EventKind kind) const {
    int n = 0;
    for (const Event& e : events) n += e.kind == kind;
    return n;
  }
};

}  // namespace halsted::testing
