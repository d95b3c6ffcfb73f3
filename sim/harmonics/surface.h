#pragma once
/// A closed surface as a sum of harmonics, r(u) = sum c_lm Y_lm(u) (acupuncture-force-net 2021, eqs. 3 and 5): constant in a step.
/// Evaluation uses + - * / sqrt only, no heap, and costs a few microseconds at order 15.
#include <array>
#include <vector>

#include "sim/harmonics/basis.h"

namespace halsted {

struct HarmonicSurface {
  HarmonicTables tables;
  std::vector<std::array<double, 6>> coefficient;   // [m] in columns: x, y, z of m, then x, y, z of -m (zero when m = 0)
};

/// Coefficients in the order of harmonicIndex.  [m]; throws std::invalid_argument when there are not (order + 1)^2 of them.
HarmonicSurface harmonicSurface(int order, const std::vector<Vec3>& coefficients);
std::vector<Vec3> coefficients(const HarmonicSurface&);   // [m] in the order of harmonicIndex

Vec3 positionAt(const HarmonicSurface&, const Vec3& unit);   // [m]

/// The surface round one point, in two directions e1, e2 of the sphere with e1 x e2 = u.
struct SurfaceFrame {
  Vec3 unit = Vec3::UnitZ();                   // where on the sphere
  Vec3 direction1 = Vec3::UnitX(), direction2 = Vec3::UnitY();   // e1, e2
  Vec3 position = Vec3::Zero();                // [m]
  Vec3 tangent1 = Vec3::UnitX(), tangent2 = Vec3::UnitY();       // [m] per radian along e1, e2
  Vec3 normal = Vec3::UnitZ();                 // [1] outward, when the coefficients keep the sphere's orientation
};
SurfaceFrame frameAt(const HarmonicSurface&, const Vec3& unit);

/// Bending of the surface: second derivatives along e1, e2 [m].
struct SurfaceBend { Vec3 along11 = Vec3::Zero(), along12 = Vec3::Zero(), along22 = Vec3::Zero(); };
SurfaceBend bendAt(const HarmonicSurface&, const SurfaceFrame&);

/// Two directions of the tangent plane of the sphere at u, with e1 x e2 = u; continuous except at one point.
std::array<Vec3, 2> directionsAt(const Vec3& unit);

/// The point of the surface nearest to `point`, searched from `start` by Gauss-Newton: right when start is near. steps: 2 follows a
/// hand from step to step, 20 converges from afar. Returns the frame there; point - position is then along the normal.
SurfaceFrame nearestPoint(const HarmonicSurface&, const Vec3& point, const Vec3& start, int steps);

struct Line { Vec3 origin = Vec3::Zero(); Vec3 direction = Vec3::UnitZ(); };   // [m], [1]
struct LineHit { bool found = false; SurfaceFrame frame; double distance = 0.0; };   // distance [m] from the origin along the direction

/// Where a line meets the surface, searched from `start` by Newton: the crossing near there, if any.
LineHit meetLine(const HarmonicSurface&, const Line&, const Vec3& start);

}  // namespace halsted
