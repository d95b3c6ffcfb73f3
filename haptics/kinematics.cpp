#include "haptics/kinematics.h"

#include <algorithm>
#include <cmath>

namespace halsted::haptics {

namespace {

constexpr double kHalfPi = 1.5707963267948966;  // [rad]

/// Cosine of the angle between sides `a` and `b` of a triangle with third side `c`.
double cosineRule(double a, double b, double c) noexcept { return (a * a + b * b - c * c) / (2.0 * a * b); }  // [m]

Mat3 carrier(const TouchJoints& joints) noexcept {
  return (Eigen::AngleAxisd(-joints[0], Vec3::UnitY()) * Eigen::AngleAxisd(-joints[2], Vec3::UnitX())).toRotationMatrix();
}

}  // namespace

Vec3 touchPosition(const TouchJoints& joints, const TouchLinks& links) noexcept {
  const double reach = links.upperArm * std::cos(joints[1]) + links.forearm * std::sin(joints[2]);  // [m] from the turret's axis
  return {-std::sin(joints[0]) * reach,
          links.upperArm * std::sin(joints[1]) - links.forearm * std::cos(joints[2]) + links.height,
          std::cos(joints[0]) * reach - links.depth};
}

Mat3 touchJacobian(const TouchJoints& joints, const TouchLinks& links) noexcept {
  const double s1 = std::sin(joints[0]), c1 = std::cos(joints[0]);  // [1]
  const double s2 = std::sin(joints[1]), c2 = std::cos(joints[1]);  // [1]
  const double s3 = std::sin(joints[2]), c3 = std::cos(joints[2]);  // [1]
  const double l1 = links.upperArm, l2 = links.forearm;             // [m]
  const double reach = l1 * c2 + l2 * s3;                           // [m]
  Mat3 jacobian;
  jacobian << -c1 * reach, s1 * l1 * s2, -s1 * l2 * c3,
              0.0, l1 * c2, l2 * s3,
              -s1 * reach, -c1 * l1 * s2, c1 * l2 * c3;
  return jacobian;
}

Vec3 touchTorque(const TouchJoints& joints, const Vec3& force, const TouchLinks& links) noexcept {
  return touchJacobian(joints, links).transpose() * force;
}

Quat touchOrientation(const TouchJoints& joints, const TouchGimbal& gimbal) noexcept {
  const Mat3 stylus = (Eigen::AngleAxisd(gimbal[0], Vec3::UnitY()) * Eigen::AngleAxisd(-gimbal[1], Vec3::UnitX()) *
                       Eigen::AngleAxisd(-gimbal[2], Vec3::UnitZ())).toRotationMatrix();
  return Quat(Mat3(carrier(joints) * stylus)).normalized();
}

std::optional<TouchJoints> touchJoints(const Vec3& position, const TouchLinks& links) noexcept {
  const double forward = position.z() + links.depth;                                // [m]
  const double out = std::hypot(position.x(), forward);                             // [m]
  const double up = position.y() - links.height;                                    // [m]
  const double span = std::hypot(out, up);                                          // [m] shoulder to gimbal centre
  const double cosUpper = cosineRule(links.upperArm, span, links.forearm);          // [1]
  const double cosFore = cosineRule(links.forearm, span, links.upperArm);           // [1]
  if (!(std::abs(cosUpper) <= 1.0 && std::abs(cosFore) <= 1.0)) return std::nullopt;  // also NaN
  const double elevation = std::atan2(up, out);                                     // [rad]
  return TouchJoints(std::atan2(-position.x(), forward), elevation + std::acos(cosUpper),
                     elevation - std::acos(cosFore) + kHalfPi);
}

TouchGimbal touchGimbal(const TouchJoints& joints, const Quat& orientation) noexcept {
  const Mat3 stylus = carrier(joints).transpose() * orientation.toRotationMatrix();
  return {std::atan2(stylus(0, 2), stylus(2, 2)), std::asin(std::clamp(stylus(1, 2), -1.0, 1.0)),
          -std::atan2(stylus(1, 0), stylus(1, 1))};
}

}  // namespace halsted::haptics
