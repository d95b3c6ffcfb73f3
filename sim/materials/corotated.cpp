#include "sim/materials/corotated.h"

#include <Eigen/SVD>

#include "sim/materials/matrix_calculus.h"

namespace halsted {
namespace {

struct Polar { Mat3 rotation, stretch; };      // [1] F = rotation * stretch, det rotation = +1

/// The smallest singular value takes the sign of det F, so that an inverted F is the rotation of a reflected stretch.
Polar polar(const Mat3& F) {                   // F [1]
  const Eigen::JacobiSVD<Mat3> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Mat3 u = svd.matrixU();
  Vec3 sigma = svd.singularValues();           // [1] descending
  if (u.determinant() * svd.matrixV().determinant() < 0.0) {
    u.col(2) = -u.col(2);
    sigma.z() = -sigma.z();
  }
  return {u * svd.matrixV().transpose(), svd.matrixV() * sigma.asDiagonal() * svd.matrixV().transpose()};
}

/// dR for a change dF: R [w] with (tr(S) I - S) w = axial vector of R^T dF - dF^T R (McAdams et al. 2011, eq. 3).
Mat3 rotationDifferential(const Polar& p, const Mat3& dF) {             // dF [1]
  const Mat3 b = p.rotation.transpose() * dF;
  const Vec3 axial(b(2, 1) - b(1, 2), b(0, 2) - b(2, 0), b(1, 0) - b(0, 1));
  const Mat3 lhs = p.stretch.trace() * Mat3::Identity() - p.stretch;
  const double det = lhs.determinant();        // [1] zero where the rotation jumps: then it has no derivative, and none is added
  if (!(det * det > 1e-24)) return Mat3::Zero();
  const Vec3 w = lhs.inverse() * axial;
  Mat3 spin;
  spin << 0.0, -w.z(), w.y(), w.z(), 0.0, -w.x(), -w.y(), w.x(), 0.0;
  return p.rotation * spin;
}

}  // namespace

double energyDensity(const Corotated& m, const Mat3& F) {
  const Polar p = polar(F);
  const double dilation = p.stretch.trace() - 3.0;                      // [1]
  const double e = (F - p.rotation).norm(), k = m.stiffening;           // [1]
  const double distortion = e <= m.toe ? e * e : k * e * e - (k - 1.0) * m.toe * (2.0 * e - m.toe);
  return m.mu * distortion + 0.5 * m.lambda * dilation * dilation;
}

Mat3 stress(const Corotated& m, const Mat3& F) {
  const Polar p = polar(F);
  const Mat3 distortion = F - p.rotation;
  return 2.0 * m.mu * secantFactor(m, distortion.norm()) * distortion + m.lambda * (p.stretch.trace() - 3.0) * p.rotation;
}

Mat3 stressDifferential(const Corotated& m, const Mat3& F, const Mat3& dF) {
  const Polar p = polar(F);
  const Mat3 turned = rotationDifferential(p, dF);
  const Mat3 distortion = F - p.rotation, change = dF - turned;
  const double e = distortion.norm();                                   // [1]
  Mat3 stiffer = secantFactor(m, e) * change;
  if (e > m.toe) stiffer += (m.stiffening - 1.0) * m.toe / (e * e * e) * contract(distortion, change) * distortion;
  return 2.0 * m.mu * stiffer + m.lambda * (contract(p.rotation, dF) * p.rotation + (p.stretch.trace() - 3.0) * turned);
}

}  // namespace halsted
