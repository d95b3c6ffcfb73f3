#include "haptics/falcon/falcon_kinematics.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace halsted::haptics {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;        // [rad]

// An encoder wheel of 320 slots, read four times a slot, on a 14.25 mm shaft that drives a 110 mm drum; 35 degrees at count zero.
constexpr double kStepDegrees = (kPi * 0.01425 / (320.0 * 4.0)) / (kPi * 0.110 / 360.0);
constexpr double kZeroDegrees = 35.0;

/// Legs at 90, -30 and -150 degrees, all turned by 15.
constexpr std::array<double, 3> kAzimuth{kPi / 2 + kPi / 12, -kPi / 6 + kPi / 12, -5 * kPi / 6 + kPi / 12};  // [rad]

/// One leg's view of the grip: u away from the plate's centre, v along the leg's axis, w out of the plate.
struct LegView { double u, v, w; };            // [m]

LegView viewOf(int leg, const Vec3& position, const FalconLinks& links) noexcept {
  const double c = std::cos(kAzimuth[leg]), s = std::sin(kAzimuth[leg]);
  return {c * position.x() + s * position.y() - links.baseU, -s * position.x() + c * position.y() - links.baseV,
          position.z() + links.middle};
}

/// How one leg stands: its angle, and the vector from knee to grip in its own plane.
struct LegPose {
  double angle;                                // [rad] theta 1
  double kneeU, kneeW;                         // [m] knee to grip joint: (d + e + b sin theta3) (cos theta2, sin theta2)
  double reach;                                // [m] d + e + b sin theta3
  double slope;                                // [1] cos theta3 / sin theta3
};

std::optional<LegPose> poseOf(const LegView& view, const FalconLinks& links) noexcept {
  const double cosine = (view.v + links.gripV) / links.shin;     // of theta 3: the parallelogram leans along v
  if (!(cosine > -0.999 && cosine < 0.999)) return std::nullopt;
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double reach = links.knee + links.shin * sine;           // [m]

  // Circle of the knee about the axis meets the circle of `reach` about the grip joint: in T = tan(theta1 / 2) a quadratic.
  const double u = view.u + links.gripU, w = view.w;             // [m]
  const double k = u * u + w * w + links.arm * links.arm - reach * reach;   // [m^2]
  const double inner = k - 2.0 * links.arm * u, outer = k + 2.0 * links.arm * u, half = 2.0 * links.arm * w;
  const double root = half * half - inner * outer;
  if (!(root >= 0.0) || !(std::abs(outer) > 1e-12)) return std::nullopt;
  const double angle = 2.0 * std::atan((half - std::sqrt(root)) / outer);   // [rad] the knee points outward
  return LegPose{angle, u - links.arm * std::cos(angle), w - links.arm * std::sin(angle), reach, cosine / sine};
}

/// d theta1 / d (u, v, w), from the closed loop (u + c - a cos)^2 + (w - a sin)^2 = (d + e + b sin theta3)^2.
std::optional<Vec3> rateOf(const LegPose& leg, const FalconLinks& links) noexcept {
  const double lever = links.arm * (leg.kneeU * std::sin(leg.angle) - leg.kneeW * std::cos(leg.angle));   // [m^2]
  if (!(std::abs(lever) > 1e-6)) return std::nullopt;            // arm and shin in line: the grip cannot be driven
  return Vec3(-leg.kneeU / lever, -leg.reach * leg.slope / lever, -leg.kneeW / lever);
}

struct Stand { FalconLegs legs; Mat3 rates; };

std::optional<Stand> standAt(const Vec3& position, const FalconLinks& links) noexcept {
  Stand stand;
  for (int i = 0; i < 3; ++i) {
    const auto leg = poseOf(viewOf(i, position, links), links);
    if (!leg) return std::nullopt;
    const auto rate = rateOf(*leg, links);
    if (!rate) return std::nullopt;
    const double c = std::cos(kAzimuth[i]), s = std::sin(kAzimuth[i]);
    stand.legs[i] = leg->angle;
    stand.rates.row(i) << rate->x() * c - rate->y() * s, rate->x() * s + rate->y() * c, rate->z();
  }
  return stand;
}

}  // namespace

double falconLegAngle(int counts) noexcept { return (counts * kStepDegrees + kZeroDegrees) * kDegree; }

int falconLegCounts(double angle) noexcept {   // [rad]
  return static_cast<int>(std::lround((angle / kDegree - kZeroDegrees) / kStepDegrees));
}

std::optional<FalconLegs> falconLegs(const Vec3& position, const FalconLinks& links) noexcept {
  FalconLegs legs;
  for (int i = 0; i < 3; ++i) {
    const auto leg = poseOf(viewOf(i, position, links), links);
    if (!leg) return std::nullopt;
    legs[i] = leg->angle;
  }
  return legs;
}

std::optional<Mat3> falconLegRates(const Vec3& position, const FalconLinks& links) noexcept {
  const auto stand = standAt(position, links);
  if (!stand) return std::nullopt;
  return stand->rates;
}

std::optional<Vec3> falconPosition(const FalconLegs& legs, const Vec3& near, const FalconLinks& links) noexcept {
  constexpr int kTurns = 24;
  constexpr double kLongest = 0.02;            // [m] a step, so that a wild start does not leave the reach at once
  if (!legs.allFinite() || !near.allFinite()) return std::nullopt;
  Vec3 position = near;
  for (int turn = 0; turn < kTurns; ++turn) {
    const auto stand = standAt(position, links);
    if (!stand) {
      position *= 0.5;                         // toward the middle, where every leg reaches
      continue;
    }
    const Vec3 missing = legs - stand->legs;   // [rad]
    if (missing.cwiseAbs().maxCoeff() < 1e-9) return position;
    const Vec3 move = stand->rates.inverse() * missing;          // [m]
    if (!move.allFinite()) return std::nullopt;
    const double length = move.norm();         // [m]
    position += length > kLongest ? Vec3(move * (kLongest / length)) : move;
  }
  return std::nullopt;
}

std::optional<Vec3> falconTorque(const Vec3& position, const Vec3& force, const FalconLinks& links) noexcept {
  const auto stand = standAt(position, links);
  if (!stand) return std::nullopt;
  const Vec3 torque = stand->rates.inverse().transpose() * force;
  if (!torque.allFinite()) return std::nullopt;
  return torque;
}

}  // namespace halsted::haptics
