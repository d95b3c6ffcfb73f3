#include "sim/needling/shaft.h"

#include <algorithm>

namespace halsted {
namespace {

double size(double x) { return x < 0.0 ? -x : x; }   // [any]

double windTorque(const NeedlingParams& p, double scale, double angle) {   // [N m], scale [1], angle [rad]
  return scale * (p.windLinear + p.windCubic * angle * angle) * angle;
}

/// The angle at which the winding holds just `bound`, from a larger one, by Newton: the torque rises with the angle, convexly.
double angleAt(const NeedlingParams& p, double scale, double bound, double angle) {   // [rad]
  constexpr int kSteps = 6;
  double x = size(angle);                      // [rad]
  for (int k = 0; k < kSteps; ++k) {
    const double slope = scale * (p.windLinear + 3.0 * p.windCubic * x * x);   // [N m/rad]
    x -= (windTorque(p, scale, x) - bound) / slope;
  }
  return angle < 0.0 ? -x : x;
}

}  // namespace

void slideShaft(const NeedlingParams& p, double travel, const ShaftBound& bound, ShaftFriction& f) {
  if (size(travel) < p.stillSpeed * p.dt) f.slid = 0.0;
  const double weak = std::max(0.0, 1.0 - f.slid / p.weakening);                      // [1]
  const double limit = bound.sliding * (1.0 + (p.staticRatio - 1.0) * weak) / p.shaftStiffness;   // [m]
  f.held += travel;
  f.drag = 0.0;
  const double beyond = size(f.held) - limit;  // [m]
  if (beyond > 0.0) {
    // Implicit: k (beyond - slip) = viscous slip / dt.
    const double spring = p.shaftStiffness * p.dt, slip = beyond * spring / (spring + bound.viscous);   // [N s/m], [m]
    const double side = f.held < 0.0 ? -1.0 : 1.0;       // [1]
    f.held -= side * slip;
    f.drag = side * p.shaftStiffness * (beyond - slip);
    f.slid += std::min(slip, size(travel));    // not what the weaker bound lets go: that would feed itself
  }
  f.force = p.shaftStiffness * f.held;
}

void advanceTip(const NeedlingParams& p, double depth, double bound, TipCut& t) {
  t.reached = std::max(t.reached, depth - bound / p.tipStiffness);
  t.force = p.tipStiffness * std::max(0.0, depth - t.reached);
}

void windShaft(const NeedlingParams& p, double turn, double length, Winding& w) {
  const double before = size(w.turned);        // [rad]
  w.turned += turn;
  const double more = size(w.turned) - before; // [rad] negative while it unwinds
  const double gain = more > 0.0 ? p.graspWind * more : p.graspUnwind * more;   // [1]
  w.grasp = std::clamp(w.grasp + (length > 0.0 ? gain : 0.0) - (w.grasp - 1.0) * p.dt / p.graspTime, 1.0, p.graspMost);
  if (length > w.length && length > 0.0) w.angle *= w.length / length;          // new length goes in unwound
  w.length = length;
  const double scale = length / p.windLength;  // [1]
  if (!(scale > 0.0)) { w.angle = w.torque = 0.0; return; }
  w.angle += turn;
  const double bound = w.grasp * p.windLimit * scale;   // [N m]
  if (size(windTorque(p, scale, w.angle)) > bound) w.angle = angleAt(p, scale, bound, w.angle);
  w.torque = -windTorque(p, scale, w.angle) - p.windDamping * scale * turn / p.dt;
}

}  // namespace halsted
