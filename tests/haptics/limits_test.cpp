#include "haptics/limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace halsted::haptics {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTick = 1e-3;  // [s]

/// A limiter that has been engaged long enough to let everything through.
LimitState engaged() {
  LimitState state;
  state.ramp = 1.0;
  return state;
}

TEST(Limits, ClampLengthKeepsDirectionForEveryFiniteVector) {
  for (const double size : {1e-308, 1e-200, 1e-3, 1.0, 1e150, 1e300}) {
    const Vec3 v = Vec3(1.0, -2.0, 0.5) * size;
    const Vec3 kept = clampLength(v, 3.3);
    EXPECT_TRUE(allFinite(kept));
    if (size > 10.0) {
      EXPECT_NEAR(kept.norm(), 3.3, 1e-12) << size;
    } else {
      EXPECT_EQ(kept, v) << size;
    }
    EXPECT_NEAR((kept / kept.cwiseAbs().maxCoeff()).cross(v / v.cwiseAbs().maxCoeff()).norm(), 0.0, 1e-12) << size;
  }
}

TEST(Limits, NonFiniteForceIsZeroAtOnceWhateverTheRateLimitSays) {
  for (const double bad : {std::nan(""), kInfinity, -kInfinity}) {
    LimitState state = engaged();
    state.lastForce = Vec3(3.0, 0.0, 0.0);
    std::uint32_t faults = 0;
    EXPECT_EQ(limitForce(Vec3(1.0, bad, 0.0), {}, {}, kTick, state, faults), Vec3(Vec3::Zero()));
    EXPECT_TRUE(faults & kFaultNonFinite);
  }
}

TEST(Limits, ForceChangesByAtMostTheRate) {
  LimitState state = engaged();
  Vec3 last = Vec3::Zero();
  for (int i = 0; i < 20; ++i) {
    std::uint32_t faults = 0;
    const Vec3 force = limitForce(i < 10 ? Vec3(3.0, 1.0, 0.0) : Vec3(-3.0, 0.0, 1.0), {}, {}, kTick, state, faults);
    EXPECT_LE((force - last).norm(), 1.0 + 1e-12);
    EXPECT_EQ((faults & kFaultRate) != 0, (i < 10 ? Vec3(3.0, 1.0, 0.0) : Vec3(-3.0, 0.0, 1.0)) != force) << i;
    last = force;
  }
  EXPECT_NEAR((last - Vec3(-3.0, 0.0, 1.0)).norm(), 0.0, 1e-12);
}

TEST(Limits, MagnitudeStopsAtThePeakAndKeepsTheDirection) {
  LimitState state = engaged();
  std::uint32_t faults = 0;
  Vec3 force;
  for (int i = 0; i < 50; ++i) force = limitForce(Vec3(30.0, -40.0, 0.0), {}, {}, kTick, state, faults);
  EXPECT_NEAR(force.norm(), 3.3, 1e-12);
  EXPECT_NEAR(force.x() / force.y(), -0.75, 1e-12);
  EXPECT_TRUE(faults & kFaultMagnitude);
}

TEST(Limits, PeakForceDeratesToTheContinuousForce) {
  LimitState state = engaged();
  double atPeak = 0.0, force = 0.0;  // [s] [N]
  std::uint32_t faults = 0;
  for (int i = 0; i < 300000; ++i) {
    force = limitForce(Vec3(0.0, 5.0, 0.0), {}, {}, kTick, state, faults).norm();
    if (force > 3.29) atPeak += kTick;
    EXPECT_LE(state.heat, 1.0 + 1e-9);
  }
  EXPECT_NEAR(force, 0.88, 0.02);
  EXPECT_GT(atPeak, 2.0);
  EXPECT_LT(atPeak, 6.0);
  EXPECT_TRUE(faults & kFaultThermal);
}

TEST(Limits, ContinuousForceIsNeverDerated) {
  LimitState state = engaged();
  std::uint32_t faults = 0;
  double force = 0.0;  // [N]
  for (int i = 0; i < 600000; ++i) force = limitForce(Vec3(0.88, 0.0, 0.0), {}, {}, kTick, state, faults).norm();
  EXPECT_NEAR(force, 0.88, 1e-12);
  EXPECT_EQ(faults, 0u);
}

TEST(Limits, MotorsCoolAgain) {
  LimitState state = engaged();
  state.heat = 1.0;
  std::uint32_t faults = 0;
  for (int i = 0; i < 120000; ++i) limitForce(Vec3::Zero(), {}, {}, kTick, state, faults);
  EXPECT_NEAR(state.heat, std::exp(-2.0), 1e-3);
  EXPECT_NEAR(allowedForce(state.heat, {}, {}), 3.3, 1e-12);
}

TEST(Limits, EveryCuttingFaultIsZeroNowAndEasesInLater) {
  for (const std::uint32_t fault : {kFaultBadReading, kFaultDeviceGone, kFaultVelocity}) {
    LimitState state = engaged();
    const Vec3 wanted(0.0, 2.0, 0.0);
    std::uint32_t faults = fault;
    EXPECT_EQ(limitForce(wanted, {}, {}, kTick, state, faults), Vec3(Vec3::Zero()));
    Vec3 last = Vec3::Zero();
    for (int i = 0; i < 200; ++i) {
      std::uint32_t none = 0;
      const Vec3 force = limitForce(wanted, {}, {}, kTick, state, none);
      EXPECT_EQ(force == Vec3(Vec3::Zero()), i < 50) << i;
      EXPECT_LE((force - last).norm(), 0.05) << i;
      last = force;
    }
    EXPECT_NEAR((last - wanted).norm(), 0.0, 1e-12);
  }
}

TEST(Limits, FirstForceOfASessionEasesIn) {
  LimitState state;
  std::uint32_t faults = 0;
  EXPECT_LT(limitForce(Vec3(0.0, 3.0, 0.0), {}, {}, kTick, state, faults).norm(), 0.05);
}

TEST(Limits, EveryFaultHasAName) {
  for (const FaultCode code : {kFaultNonFinite, kFaultBadReading, kFaultDeviceGone, kFaultVelocity, kFaultStale, kFaultRate,
                               kFaultMagnitude, kFaultThermal, kFaultPassivity})
    EXPECT_STRNE(faultName(code), "unknown fault");
}

}  // namespace
}  // namespace halsted::haptics
