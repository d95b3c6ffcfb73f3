#include "render/acupuncture_tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/body_look.h"
#include "render/color.h"
#include "render/noise.h"

namespace halsted::render {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;         // [rad]

/// A straight tube from (z, radius) pairs.
Tube straightTube(const std::vector<std::array<double, 2>>& profile) {   // [m]
  Tube tube;
  makeIndices(static_cast<int>(profile.size()), tube);
  for (std::size_t i = 0; i < profile.size(); ++i)
    writeRing({Vec3(0.0, 0.0, profile[i][0]), Vec3::UnitX(), Vec3::UnitY(), profile[i][1], profile[i][0], 0.0}, static_cast<int>(i), tube);
  return tube;
}

/// Half width over the distance from the tip, both in radii: round end, slight waist before the joint, knuckle.
double fingerWidth(double s) {                           // [1]
  if (s < 1.0) return std::sqrt(std::max(0.0, 1.0 - (1.0 - s) * (1.0 - s)));
  return 1.0 - 0.05 * smoothStep(1.0, 2.2, s) + 0.10 * smoothStep(2.2, 3.4, s) - 0.06 * smoothStep(3.6, 5.5, s) + 0.10 * smoothStep(5.5, 9.0, s);
}

struct Nail { double inside = 0.0, moon = 0.0, edge = 0.0; };   // [1]

Nail nailAt(double s, double angle) {                    // [1] radii from the tip, [rad] from the middle of the back
  const double along = (s - 1.15) / 1.0, across = angle / 0.95;   // [1] of its half length, half width
  const double d = std::pow(std::abs(along), 3.0) + std::pow(std::abs(across), 3.0);   // [1]
  return {smoothStep(1.08, 0.92, d), smoothStep(1.62, 1.80, s + 0.25 * across * across), smoothStep(0.42, 0.30, s)};
}

std::array<double, 3> fingerColor(double s, double angle, const Vec3& p) {   // [1], [rad], [m]
  const double blush = smoothStep(0.3, 0.7, fractalNoise(90.0 * p.x() + 5.0, 90.0 * p.y(), 90.0 * p.z(), 3));   // [1]
  Vec3 color = mixed(kSkinPale, kSkinRosy, 0.5 * blush);
  color = color.cwiseProduct(Vec3::Ones() - 0.5 * smoothStep(2.2, 0.3, s) * Vec3(0.02, 0.20, 0.22));        // the tip is better supplied with blood
  const double crease = std::exp(-std::pow((s - 3.35) / 0.10, 2.0)) + 0.8 * std::exp(-std::pow((s - 3.05) / 0.07, 2.0)) + 0.6 * std::exp(-std::pow((s - 3.65) / 0.08, 2.0));
  color *= 1.0 - 0.22 * crease * std::abs(std::cos(0.5 * angle));                                            // [1] over the joint
  const Nail nail = nailAt(s, angle);
  const Vec3 plate = mixed(Vec3(0.66, 0.36, 0.30), Vec3(0.74, 0.56, 0.50), nail.moon);
  color = mixed(color, mixed(plate, Vec3(0.80, 0.74, 0.66), nail.edge), nail.inside);
  return {color.x(), color.y(), color.z()};
}

}  // namespace

Tube makeShaft(const StraightNeedle& needle) {
  const double tip = std::min(1.1e-3, 0.1 * needle.length);   // [m] of the tapered point
  return straightTube({{0.0, 0.03 * needle.radius}, {0.3 * tip, 0.45 * needle.radius}, {0.65 * tip, 0.82 * needle.radius}, {tip, needle.radius},
                       {0.35 * needle.length, needle.radius}, {0.7 * needle.length, needle.radius}, {needle.length + 0.5e-3, needle.radius}});
}

Tube makeHandle(const StraightNeedle& needle) {
  const double r = needle.handleRadius, from = needle.length;   // [m]
  std::vector<std::array<double, 2>> profile{{from - 0.2e-3, 0.6 * r}, {from, r}};
  constexpr int kPieces = 12;
  for (int i = 1; i < kPieces; ++i) profile.push_back({from + i * needle.handleLength / kPieces, r});
  profile.insert(profile.end(), {{from + needle.handleLength, r}, {from + needle.handleLength + 0.2e-3, 0.5 * r}});
  return straightTube(profile);
}

Shape makeHandleLoop(const StraightNeedle& needle) {
  Shape shape;
  const double ring = 2.1 * needle.handleRadius;         // [m]
  addRing(shape, ring, 0.42 * needle.handleRadius, {Vec3(0.0, 0.0, needle.length + needle.handleLength + ring), Quat::Identity()}, {0.78, 0.79, 0.80});
  return shape;
}

Shape makeFinger(double radius) {
  constexpr int kRings = 64, kSides = 40;
  const auto along = [](int ring) {                      // [1] radii from the tip, denser there
    const double t = static_cast<double>(ring) / (kRings - 1);   // [1]
    return 0.004 + (kFingerLength - 0.004) * t * t * (0.65 + 0.35 * t);
  };
  const auto angleOf = [](int side) {                    // [rad] from the middle of the back, in (-pi, pi]
    const double a = kTurn * side / kSides;              // [rad]
    return a > std::numbers::pi ? a - kTurn : a;
  };
  Shape shape;
  Loft loft{kRings, kSides, {}, {}};
  loft.point = [&](int i, int k) {
    const double s = along(i), a = angleOf(k), w = fingerWidth(s);                                           // [1] [rad] [1]
    const double flat = 1.0 - 0.16 * nailAt(s, a).inside * smoothStep(0.25, 0.8, s);                          // [1] the nail lies flat
    const double deep = 0.90 + 0.06 * smoothStep(0.0, -1.0, std::cos(a)) * smoothStep(4.0, 1.0, s);            // [1] the pad is full
    return Vec3(-radius * w * std::sin(a), radius * (w * deep * flat * std::cos(a)), radius * (s - 1.0));
  };
  loft.color = [&](int i, int k) { return fingerColor(along(i), angleOf(k), loft.point(i, k)); };
  addLoft(shape, loft);
  for (ShapeVertex& v : shape.vertices) {
    const float tile = static_cast<float>(kBodyTile);    // [m]
    v.uv[0] = std::atan2(v.position[0], v.position[1]) * static_cast<float>(radius) / tile;
    v.uv[1] = v.position[2] / tile;
  }
  return shape;
}

Pose fingerPose(const FingerTouch& touch, double radius) {
  const Vec3& normal = touch.normal;
  const Vec3 flat = (touch.from - touch.from.dot(normal) * normal).normalized();
  const Vec3 along = (0.80 * flat + 0.60 * normal).normalized();          // a pad presses at about 37 degrees
  const Vec3 back = (normal - normal.dot(along) * along).normalized();
  Mat3 turn;                                             // [1]
  turn << back.cross(along), back, along;
  return {touch.place + 0.93 * radius * normal, Quat(turn)};
}

}  // namespace halsted::render
