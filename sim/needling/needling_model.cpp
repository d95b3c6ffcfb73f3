#include <stdexcept>
#include <string>

#include "sim/needling/needling.h"

namespace halsted {
namespace {

void requirePositive(double value, const char* name) {   // value [any]
  if (!(value > 0.0)) throw std::invalid_argument(std::string("needling: ") + name + " must be positive");
}

void checkLayer(const LayerParams& layer) {
  requirePositive(layer.thickness, "a layer's thickness");
  if (!(layer.damping >= 0.0) || !(layer.friction >= 0.0) || !(layer.cutForce >= 0.0) || !(layer.punctureForce >= 0.0))
    throw std::invalid_argument("needling: a layer's damping, friction and forces must not be negative");
}

}  // namespace

NeedlingModel needlingModel(const NeedlingParams& p, const std::array<HarmonicSurface, kLayers>& surfaces) {
  requirePositive(p.dt, "dt");
  requirePositive(p.needleRadius, "the needle's radius");
  requirePositive(p.springbackTime, "the springback time");
  requirePositive(p.shaftStiffness, "the shaft stiffness");
  requirePositive(p.tipStiffness, "the tip stiffness");
  requirePositive(p.windLinear, "the winding stiffness");
  requirePositive(p.windLength, "the winding length");
  requirePositive(p.weakening, "the weakening distance");
  requirePositive(p.graspTime, "the grasp time");
  requirePositive(p.fingerRadius, "the finger's radius");
  if (!(p.staticRatio >= 1.0)) throw std::invalid_argument("needling: static friction must not be below sliding friction");
  if (!(p.graspMost >= 1.0)) throw std::invalid_argument("needling: the largest grasp must be at least 1");
  NeedlingModel m{p, surfaces, {}};
  for (int k = 0; k < kLayers; ++k) {
    checkLayer(p.layers[k]);
    m.net[k] = forceNet(p.layers[k], p);
  }
  return m;
}

NeedlingState needlingState(const NeedlingModel& m) {
  NeedlingState s;
  for (int k = 0; k < kLayers; ++k) {
    s.layers[k].rest.assign(m.net[k].place.size(), Vec3::Zero());
    s.layers[k].now = s.layers[k].rest;
  }
  return s;
}

double pressedDepth(const NeedlingModel& m, const NeedlingState& s, const Vec3& place) {
  if (!(s.fingerDepth > 0.0)) return 0.0;
  const double distance = (place - s.fingerPlace).norm();   // [m]
  return distance <= m.params.fingerRadius ? s.fingerDepth : s.fingerDepth * m.params.fingerRadius / distance;
}

double dimple(const NeedlingState& s, int layer) {
  const LayerState& l = s.layers[layer];
  const double slant = s.axis.dot(l.normal);   // [1] negative: the axis points inward
  return l.phase == LayerPhase::kFree || !(slant < 0.0) ? 0.0 : (l.now[0] - l.rest[0]).dot(l.normal) / slant;
}

}  // namespace halsted
