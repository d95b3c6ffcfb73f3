#include "sim/needling/needling_layers.h"

#include <algorithm>

#include "sim/needling/springback.h"

namespace halsted {
namespace {

constexpr double kOutOfReach = 1e3;            // [m]

}  // namespace

void layNet(const NeedlingModel& m, int layer, const SurfaceFrame& f, NeedlingState& s) {
  LayerState& l = s.layers[layer];
  placeNet(m.net[layer], f, bendAt(m.surface[layer], f), l.rest);
  std::copy(l.rest.begin(), l.rest.end(), l.now.begin());
  l.normal = f.normal;
  l.phase = LayerPhase::kDimpled;
  l.since = 0.0;
}

double pressNet(const NeedlingModel& m, int layer, double depth, NeedlingState& s) {
  const ForceNet& net = m.net[layer];
  LayerState& l = s.layers[layer];
  double sum = 0.0;                            // [m] Z_j: how far each virtual spring is pressed
  for (std::size_t i = 0; i < l.rest.size(); ++i) {
    const bool support = net.ring[i] > net.rings;
    const double z = support ? 0.0 : net.profile == NetProfile::kCone ? ringDepth(net, net.ring[i], depth) : depth * net.share[i];   // [m]
    l.now[i] = l.rest[i] + z * s.axis - pressedDepth(m, s, l.rest[i]) * s.outward;
    sum += z;
  }
  return net.springStiffness * sum;
}

void releaseNet(const NeedlingModel& m, int layer, double held, NeedlingState& s) {
  const ForceNet& net = m.net[layer];
  LayerState& l = s.layers[layer];
  const double before = springbackRemaining(l.since, m.params.springbackTime);   // [1]
  l.since += m.params.dt;
  const double after = springbackRemaining(l.since, m.params.springbackTime);    // [1]
  const double factor = before > 0.0 ? after / before : 0.0;                     // [1]
  // The supporting ring follows the pressing finger; its rigid motion is what the dimple returns to.
  const std::size_t inner = static_cast<std::size_t>(netPoints(net.rings)), count = l.rest.size() - inner;
  for (std::size_t i = inner; i < l.rest.size(); ++i) l.now[i] = l.rest[i] - pressedDepth(m, s, l.rest[i]) * s.outward;
  const Match match = matchRing({&l.rest[inner], count}, {&l.now[inner], count});
  const double kept = held / netStiffness(net, 0.0);   // [m] k z = friction
  for (std::size_t i = 0; i < inner; ++i) {
    const double z = net.profile == NetProfile::kCone ? (net.ring[i] == 1 ? kept : 0.0) : kept * net.share[i];   // [m]
    const Vec3 goal = match.goal(l.rest[i]) + z * s.axis;
    l.now[i] = springBack(goal, factor, l.now[i]);
  }
}

std::array<double, kLayers> shaftInside(const NeedlingState& s) {
  std::array<double, kLayers> inside{};
  double bottom = s.depth;                     // [m] along the axis
  for (int k = kLayers - 1; k >= 0; --k) {
    if (s.layers[k].phase != LayerPhase::kPunctured) continue;
    const double top = s.layers[k].crossing + dimple(s, k);   // [m]
    inside[k] = std::max(0.0, bottom - top);
    bottom = std::min(bottom, top);
  }
  return inside;
}

void findCrossings(const NeedlingModel& m, NeedlingState& s) {
  double above = 0.0;                          // [m]
  for (int k = 1; k < kLayers; ++k) {
    const LineHit hit = meetLine(m.surface[k], {s.entry, s.axis}, s.skinUnit);
    const bool reached = hit.found && hit.distance > above && hit.frame.normal.dot(s.axis) < 0.0;
    s.layers[k].crossing = reached ? hit.distance : kOutOfReach;
    if (reached) layNet(m, k, hit.frame, s);
    s.layers[k].phase = LayerPhase::kFree;
    above = s.layers[k].crossing;
  }
}

}  // namespace halsted
