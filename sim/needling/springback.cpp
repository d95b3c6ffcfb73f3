#include "sim/needling/springback.h"

#include <cmath>

#include "sim/materials/matrix_calculus.h"

namespace halsted {

Mat3 rotationOf(const Mat3& a) {
  constexpr int kSteps = 12;
  const double size = std::sqrt(a.col(0).squaredNorm() + a.col(1).squaredNorm() + a.col(2).squaredNorm());   // [m^2 kg]
  if (!(size > 0.0)) return Mat3::Identity();
  Mat3 x = a / size;
  for (int k = 0; k < kSteps; ++k) {
    const Mat3 c = cofactor(x);
    const double det = x.col(0).dot(c.col(0));   // [1]
    if (!(det > 1e-9)) return Mat3::Identity();
    x = 0.5 * (x + c / det);
  }
  return x;
}

Match matchRing(std::span<const Vec3> rest, std::span<const Vec3> now) {
  const std::size_t n = rest.size();
  Vec3 restCentre = Vec3::Zero(), centre = Vec3::Zero();   // [m]
  for (std::size_t i = 0; i < n; ++i) { restCentre += rest[i]; centre += now[i]; }
  restCentre /= static_cast<double>(n);
  centre /= static_cast<double>(n);
  Mat3 a = Mat3::Zero();                       // [m^2] eq. 7, equal masses
  Vec3 restNormal = Vec3::Zero(), normal = Vec3::Zero();   // [m^2]
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = i + 1 < n ? i + 1 : 0;
    const Vec3 p = now[i] - centre, p0 = rest[i] - restCentre;
    a += p * p0.transpose();
    normal += p.cross(now[j] - centre);
    restNormal += p0.cross(rest[j] - restCentre);
  }
  // A ring is flat: across it the points say nothing, its normals do.
  const double spread = 0.5 * a.trace();       // [m^2]
  const double lengths = std::sqrt(normal.squaredNorm() * restNormal.squaredNorm());   // [m^4]
  if (lengths > 0.0 && spread > 0.0) a += spread / lengths * normal * restNormal.transpose();
  Match match;
  match.rotation = rotationOf(a);
  match.shift = centre - match.rotation * restCentre;
  return match;
}

double springbackRemaining(double time, double whole) {
  const double eta = time >= whole ? 0.0 : 1.0 - time / whole;   // [1]
  return eta * eta;
}

}  // namespace halsted
