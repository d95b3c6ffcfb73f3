#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/light.h"

namespace halsted::render {
namespace {

double halfTangent(const CameraView& view) {
  return std::tan(0.5 * std::clamp(view.fovDegrees, 1.0, 150.0) * std::numbers::pi / 180.0);
}

/// Rotation and translation that put `eye` at the origin looking along -z.
Eigen::Matrix4d lookAt(const Vec3& eye, const Vec3& forward, const Vec3& up) {          // [m], [1], [1]
  const Vec3 f = forward.squaredNorm() > 0.0 ? Vec3(forward.normalized()) : Vec3(-Vec3::UnitZ());
  Vec3 side = f.cross(up);
  if (side.squaredNorm() < 1e-12) side = f.cross(std::abs(f.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ());
  side.normalize();
  const Vec3 above = side.cross(f);
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<1, 3>(0, 0) = side.transpose();
  m.block<1, 3>(1, 0) = above.transpose();
  m.block<1, 3>(2, 0) = -f.transpose();
  m.block<3, 1>(0, 3) = -(m.block<3, 3>(0, 0) * eye);
  return m;
}

}  // namespace

Matrix4 viewProjection(const CameraView& view, double aspect) {
  constexpr double kNear = 8e-3, kFar = 1.2;                                            // [m]
  const double t = halfTangent(view);                                                   // [1]
  Eigen::Matrix4d p = Eigen::Matrix4d::Zero();
  p(0, 0) = 1.0 / (t * aspect);
  p(1, 1) = 1.0 / t;
  p(2, 2) = (kFar + kNear) / (kNear - kFar);
  p(2, 3) = 2.0 * kFar * kNear / (kNear - kFar);
  p(3, 2) = -1.0;
  return (p * lookAt(view.eye, view.target - view.eye, view.up)).cast<float>();
}

Matrix4 lampProjection(const Vec3& centre, double radius) {
  const double depth = 2.0 * radius;                                                    // [m] reach before and behind the centre
  Eigen::Matrix4d p = Eigen::Matrix4d::Identity();
  p(0, 0) = p(1, 1) = 1.0 / radius;
  p(2, 2) = -1.0 / depth;
  return (p * lookAt(centre, -lightDirection(), Vec3::UnitY())).cast<float>();
}

Matrix4 toTexture(const Matrix4& clip) {
  Matrix4 half = 0.5f * Matrix4::Identity();
  half(0, 3) = half(1, 3) = half(2, 3) = 0.5f;
  half(3, 3) = 1.0f;
  return half * clip;
}

Matrix4 matrixOf(const Pose& pose) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<3, 3>(0, 0) = pose.orientation.toRotationMatrix();
  m.block<3, 1>(0, 3) = pose.position;
  return m.cast<float>();
}

double pixelSize(const CameraView& view, int height) { return 2.0 * halfTangent(view) / height; }

}  // namespace halsted::render
