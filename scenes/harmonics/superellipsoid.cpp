#include <cmath>
#include <stdexcept>

#include "scenes/harmonics/region.h"
#include "scenes/mesh_readers/surface_builder.h"

namespace halsted::scenes {
namespace {

/// x^n for a positive x and a whole or half n, by products and square roots.
double power(double x, double n) {             // [1]
  double result = 1.0;                         // [1]
  for (int k = 0; k < static_cast<int>(n); ++k) result *= x;
  return n - std::floor(n) >= 0.5 ? result * std::sqrt(x) : result;
}

/// r with sum |r d_i / a_i|^n = 1, by bisection: no library power function, which differs between processors.
double radiusAlong(const Vec3& d, const Superellipsoid& e) {   // [m]
  double low = 0.0, high = 2.0 * e.halfSize.norm();            // [m]
  for (int k = 0; k < 60; ++k) {
    const double r = 0.5 * (low + high);       // [m]
    double sum = 0.0;                          // [1]
    for (int i = 0; i < 3; ++i) sum += power(std::abs(r * d[i]) / e.halfSize[i], e.power);
    (sum < 1.0 ? low : high) = r;
  }
  return 0.5 * (low + high);
}

}  // namespace

Surface superellipsoid(const Superellipsoid& e) {
  if (!(e.halfSize.minCoeff() > 0.0)) throw std::invalid_argument("superellipsoid: every half size must be positive");
  if (!(e.power >= 2.0 && e.power <= 20.0)) throw std::invalid_argument("superellipsoid: the power must be between 2 and 20");
  if (e.divisions < 2 || e.divisions > 200) throw std::invalid_argument("superellipsoid: divisions must be between 2 and 200");
  Surface s;
  // The eight faces of an octahedron, each divided evenly; shared edges are welded afterwards.
  for (int face = 0; face < 8; ++face) {
    const Vec3 x(face & 1 ? -1 : 1, 0, 0), y(0, face & 2 ? -1 : 1, 0), z(0, 0, face & 4 ? -1 : 1);
    const bool turned = (face & 1) ^ ((face >> 1) & 1) ^ ((face >> 2) & 1);
    const int first = static_cast<int>(s.vertices.size()), n = e.divisions;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n - i; ++j) {
        // Stretched to the slab's proportions before projection, so that flat slabs are sampled evenly too.
        const Vec3 place = (x * i + y * j + z * (n - i - j)).cwiseProduct(e.halfSize).normalized();
        s.vertices.push_back(radiusAlong(place, e) * place);
      }
    const auto at = [&](int i, int j) { return first + i * (n + 1) - i * (i - 1) / 2 + j; };
    const auto add = [&](int a, int b, int c) { s.triangles.push_back(turned ? std::array{a, c, b} : std::array{a, b, c}); };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n - i; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j < n - 1) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  s.groups.assign(1, "slab");
  s.triangleGroup.assign(s.triangles.size(), 0);
  weld(s);
  return s;
}

}  // namespace halsted::scenes
