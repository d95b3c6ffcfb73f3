#include "sim/needling/force_net.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace halsted {
namespace {

/// Points of a hexagon of side `side`, walked once round from its first corner.
void addRing(int ring, double spacing, ForceNet& net) {   // spacing [m]
  const double half = std::sqrt(3.0) / 2.0;    // [1]
  const Eigen::Vector2d corner[6] = {{1, 0}, {0.5, half}, {-0.5, half}, {-1, 0}, {-0.5, -half}, {0.5, -half}};
  const int side = ring - 1;
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < side; ++i) {
      net.place.push_back(spacing * ((side - i) * corner[k] + i * corner[(k + 1) % 6]));
      net.ring.push_back(ring);
    }
}

}  // namespace

ForceNet forceNet(const LayerParams& layer, const NeedlingParams& p) {
  if (layer.rings < 2 || layer.rings > 40) throw std::invalid_argument("force net: rings must be between 2 and 40");
  if (!(layer.springStiffness > 0.0)) throw std::invalid_argument("force net: the spring stiffness must be positive");
  if (!(layer.springLength > 0.0)) throw std::invalid_argument("force net: the spring length must be positive");
  ForceNet net;
  net.rings = layer.rings;
  net.springStiffness = layer.springStiffness;
  net.profile = p.profile;
  net.spacing = layer.springLength;
  net.place.push_back(Eigen::Vector2d::Zero());
  net.ring.push_back(1);
  for (int ring = 2; ring <= layer.rings + 1; ++ring) addRing(ring, layer.springLength, net);
  for (int ring : net.ring) net.share.push_back(ring == 1 ? 1.0 : p.needleRadius / ((ring - 1) * layer.springLength));
  const double w = layer.rings;                // [1]
  if (p.profile == NetProfile::kCone) {
    // At the critical point the cone's foot is at w L, and eq. 6 sums to exactly K w^2 Z_1.
    const double asked = layer.punctureForce / (layer.springStiffness * w * w);   // [m]
    net.punctureDepth = layer.punctureForce > 0.0 ? asked : p.coneSlope * w * layer.springLength;
    net.slope = net.punctureDepth / (w * layer.springLength);
  } else {
    if (!(layer.punctureForce > 0.0)) throw std::invalid_argument("force net: the 1/r profile needs a puncture force");
    net.punctureDepth = layer.punctureForce / netStiffness(net, 0.0);
  }
  if (!(net.punctureDepth > 0.0)) throw std::invalid_argument("force net: the cone's slope must be positive");
  return net;
}

double ringDepth(const ForceNet& net, int ring, double depth) {
  if (ring > net.rings) return 0.0;            // the support
  if (net.profile == NetProfile::kCone) return std::max(0.0, depth - net.slope * net.spacing * (ring - 1));
  return ring == 1 ? depth : depth * net.share[netPoints(ring) - 1];
}

double netForce(const ForceNet& net, double depth) {
  double sum = 0.0;                            // [m]
  for (int ring = 1; ring <= net.rings; ++ring) sum += ringPoints(ring) * ringDepth(net, ring, depth);
  return net.springStiffness * sum;
}

double netStiffness(const ForceNet& net, double depth) {
  double sum = 0.0;                            // [1]
  for (int ring = 1; ring <= net.rings; ++ring) {
    const bool cone = net.profile == NetProfile::kCone;
    const double share = cone ? (depth >= net.slope * net.spacing * (ring - 1) ? 1.0 : 0.0) : ringDepth(net, ring, 1.0);   // [1]
    sum += ringPoints(ring) * share;
  }
  return net.springStiffness * sum;
}

void placeNet(const ForceNet& net, const SurfaceFrame& f, const SurfaceBend& bend, std::vector<Vec3>& points) {
  const Vec3 e1 = f.tangent1.normalized(), e2 = f.normal.cross(e1);
  // (a, b) of the parameter plane for one metre along e1 and e2.
  const double t1 = f.tangent1.dot(e1), t2x = f.tangent2.dot(e1), t2y = f.tangent2.dot(e2);          // [m]
  const double l = bend.along11.dot(f.normal), m = bend.along12.dot(f.normal), n = bend.along22.dot(f.normal);   // [m]
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = net.place[i].x(), y = net.place[i].y();    // [m]
    const double b = y / t2y, a = (x - b * t2x) / t1;           // [rad]
    const double height = 0.5 * (l * a * a + 2.0 * m * a * b + n * b * b);   // [m]
    points[i] = f.position + x * e1 + y * e2 + height * f.normal;
  }
}

}  // namespace halsted
