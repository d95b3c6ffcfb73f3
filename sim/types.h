#pragma once
/// Linear algebra names used everywhere. All positions are metres in the world frame unless a header says otherwise:
/// x right, y up, z toward the surgeon; origin at the centre of the bowel opening.
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>

namespace halsted {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

/// Eigen's default constructor leaves a vector as it finds it, also in `std::array<Vec3, N> a{}`: arrays in a state begin with this.
template <std::size_t N> std::array<Vec3, N> zeroVectors() {
  std::array<Vec3, N> vectors;
  vectors.fill(Vec3::Zero());
  return vectors;
}

/// A rigid pose: world = orientation * local + position.
struct Pose {
  Vec3 position = Vec3::Zero();              // [m]
  Quat orientation = Quat::Identity();       // unit quaternion

  Vec3 apply(const Vec3& local) const { return orientation * local + position; }
  Vec3 inverseApply(const Vec3& world) const { return orientation.conjugate() * (world - position); }
};

// The pose b, given in the frame of a, in the frame that a is given in.
inline Pose compose(const Pose& a, const Pose& b) { return {a.apply(b.position), (a.orientation * b.orientation).normalized()}; }
inline Pose inverse(const Pose& a) { return {-(a.orientation.conjugate() * a.position), a.orientation.conjugate()}; }

/// The least turn that brings one direction onto another; about any axis square to them where they are opposite. To the bit what Eigen's
/// FromTwoVectors gives elsewhere, whose decomposition for opposite ones takes each file that calls it seven seconds to compile.
inline Quat turnOnto(const Vec3& from, const Vec3& to) {
  const Vec3 a = from.normalized(), b = to.normalized();
  const double both = 1.0 + b.dot(a);        // [1] 0 for opposite ones
  if (both < 1e-12) {
    const Vec3 axis = a.unitOrthogonal();
    return Quat(0.0, axis.x(), axis.y(), axis.z());
  }
  const double twice = std::sqrt(2.0 * both);   // [1] 2 cos of half the angle
  const Vec3 axis = a.cross(b) * (1.0 / twice);
  return Quat(0.5 * twice, axis.x(), axis.y(), axis.z());
}

inline constexpr int kHands = 2;             // hand 0 is the left, hand 1 the right
inline constexpr int kLeft = 0, kRight = 1;

}  // namespace halsted
