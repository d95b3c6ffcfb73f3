#pragma once
/// The mass-spring force net of acupuncture-force-net 2021, section 3.2: hexagonal rings of points round the contact point, each on a
/// virtual spring across the surface. Ring 1 is the contact point, ring j has 6 (j - 1) points at a spacing of L.
#include <vector>

#include "sim/harmonics/surface.h"
#include "sim/needling/needling_params.h"

namespace halsted {

constexpr int ringPoints(int ring) { return ring == 1 ? 1 : 6 * (ring - 1); }
constexpr int netPoints(int rings) { return 1 + 3 * rings * (rings - 1); }

/// What never changes of one layer's net.
struct ForceNet {
  int rings = 0;
  double springStiffness = 0.0;                // [N/m] K
  double punctureDepth = 0.0;                  // [m] of the contact point when the deformation reaches the outermost ring
  double slope = 0.0;                          // [1] of the cone's side
  std::vector<Eigen::Vector2d> place;          // [m] of each point in the tangent plane, one ring more than `rings`: the support
  std::vector<int> ring;                       // of each point, from 1
  std::vector<double> share;                   // [1] 1/r profile: depth of a point over that of the contact point
  NetProfile profile = NetProfile::kInverseDistance;
  double spacing = 0.0;                        // [m] L
};

/// Throws std::invalid_argument naming what makes no sense: fewer than two rings, a stiffness or spacing not above zero.
ForceNet forceNet(const LayerParams&, const NeedlingParams&);

/// Depth of a ring when the contact point is at `depth`.  [m]
double ringDepth(const ForceNet&, int ring, double depth);   // depth [m]
/// Eq. 6: F = K Z_1 + K sum 6 (j - 1) Z_j over the rings, and its slope.
double netForce(const ForceNet&, double depth);              // [N], depth [m]
double netStiffness(const ForceNet&, double depth);          // [N/m], depth [m]

/// The points on the surface round a frame, to second order: tangent plane and bend. points [m], sized like ForceNet::place.
void placeNet(const ForceNet&, const SurfaceFrame&, const SurfaceBend&, std::vector<Vec3>& points);

}  // namespace halsted
