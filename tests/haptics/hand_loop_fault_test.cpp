/// What the hand loop does when something is wrong: a stalled physics, numbers that are none, a lost or absurd device.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/haptics/bench_rig.h"
#include "tests/haptics/replay_rig.h"

namespace halsted::haptics {
namespace {

TEST(HandLoopFaults, ForceFallsToZeroWithin100MillisecondsOfAStalledPhysics) {
  SpringWall wall{800.0, 0.5};
  Rig rig;
  rig.target.pose.position.y() = -2e-3;
  for (int i = 0; i < 1000; ++i) rig.advance(wall);
  const double held = rig.output.force.norm();  // [N]
  ASSERT_GT(held, 0.5);
  EXPECT_FALSE(rig.output.stale);
  for (int i = 1; i <= 300; ++i) {
    rig.tickOnly();
    ASSERT_EQ(rig.output.force.norm() == 0.0, i >= 100) << i;
    EXPECT_EQ(rig.output.stale, i > 50) << i;
    EXPECT_EQ((rig.output.faults & kFaultStale) != 0, rig.output.stale);
  }
  rig.largestStep = 0.0;
  for (int i = 0; i < 500; ++i) rig.advance(wall);  // and it comes back gently
  EXPECT_FALSE(rig.output.stale);
  EXPECT_GT(rig.output.force.norm(), 0.5);
  EXPECT_LT(rig.largestStep, 0.11);  // the blend's step and one or two encoder counts at 800 N/m
}

TEST(HandLoopFaults, NonFiniteModelIsZeroInTheSameTickAndPassesOver) {
  const double bad[] = {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int field = 0; field < 6; ++field)
    for (const double value : bad) {
      ReplayRig rig({readingAt(Vec3(0.0, 1e-3, 0.0))});
      LocalContact good = bilateral(0, Vec3(0.0, 1.0, 0.0));
      good.planeCount = 1;
      good.planes[0].normal = Vec3::UnitY();
      for (int i = 1; i < 100; ++i) rig.contact = good, rig.contact.step = i, rig.next();
      ASSERT_GT(rig.output.force.norm(), 0.5);
      rig.contact.step = 100;
      double* const fields[] = {&rig.contact.force.y(), &rig.contact.stiffness(1, 1), &rig.contact.damping(0, 2), &rig.contact.position.z(),
                                &rig.contact.planes[0].normal.x(), &rig.contact.planes[0].point.y()};
      *fields[field] = value;
      EXPECT_EQ(rig.next(), Vec3(Vec3::Zero())) << field;
      EXPECT_TRUE(rig.output.faults & kFaultNonFinite) << field;
      for (int i = 101; i < 400; ++i) rig.contact = good, rig.contact.step = i, rig.next();
      EXPECT_GT(rig.output.force.norm(), 0.5) << "recovers";
      EXPECT_EQ(rig.output.faults, 0u);
    }
}

TEST(HandLoopFaults, BadReadingKeepsTheLastPoseAndCutsTheForce) {
  std::vector<DeviceReading> readings(100, readingAt(Vec3(0.0, -2e-3, 0.0)));
  readings[60].pose.position.x() = std::nan("");
  readings[61].pose.orientation.coeffs().setZero();
  readings[62].pose.position.x() = 1e30;
  ReplayRig rig(readings);
  rig.contact = bilateral(1, Vec3::Zero());
  for (int i = 0; i < 40; ++i) rig.next();
  ASSERT_GT(rig.output.force.norm(), 0.5);
  for (int i = 40; i < 63; ++i) {
    rig.next();
    EXPECT_EQ((rig.output.faults & kFaultBadReading) != 0, i >= 60) << i;
    EXPECT_EQ(rig.output.force.norm() == 0.0, i >= 60) << i;
    EXPECT_EQ(rig.output.sample.pose.position, Vec3(0.0, -2e-3, 0.0));
  }
}

TEST(HandLoopFaults, LostDeviceIsAFaultAndItsReturnEasesIn) {
  SpringWall wall{800.0, 0.5};
  Rig rig;
  rig.target.pose.position.y() = -2e-3;
  for (int i = 0; i < 1000; ++i) rig.advance(wall);
  rig.device.setConnected(false);
  rig.advance(wall);
  EXPECT_TRUE(rig.output.faults & kFaultDeviceGone);
  EXPECT_EQ(rig.output.force, Vec3(Vec3::Zero()));
  rig.device.setConnected(true);
  rig.largestStep = 0.0;
  for (int i = 0; i < 1000; ++i) rig.advance(wall);
  EXPECT_GT(rig.output.force.norm(), 0.5);
  EXPECT_LT(rig.largestStep, 0.15);
}

TEST(HandLoopFaults, FasterThanAHandCutsTheForce) {
  std::vector<DeviceReading> readings;
  for (int i = 0; i < 40; ++i) readings.push_back(readingAt(Vec3(0.0, -2e-3, 0.0)));
  for (int i = 0; i < 40; ++i) readings.push_back(readingAt(Vec3(3e-3 * i, -2e-3, 0.0)));  // 3 m/s
  ReplayRig rig(readings);
  rig.contact = bilateral(1, Vec3::Zero());
  for (int i = 0; i < 40; ++i) rig.next();
  ASSERT_GT(rig.output.force.norm(), 0.5);
  for (int i = 0; i < 10; ++i) rig.next();
  EXPECT_TRUE(rig.output.faults & kFaultVelocity);
  EXPECT_EQ(rig.output.force, Vec3(Vec3::Zero()));
}

double hostileNumber(Noise& noise) {
  static constexpr double kNumbers[] = {0.0, -0.0, 5e-324, 1e-310, 1e-200, 1e-3, 1.0, 3.3, 1e6, 1e100, 1e200, 1e300, 1.7976931348623157e308};
  const int index = static_cast<int>((noise() + 1.0) * 7.5);  // 13 and 14: NaN, infinity
  if (index == 13) return std::nan("");
  if (index == 14) return std::numeric_limits<double>::infinity();
  return (noise() < 0.0 ? -1.0 : 1.0) * kNumbers[index];
}

TEST(HandLoopFaults, HostileModelsLeaveForceFiniteAndWithinThePeak) {
  Rig rig;
  Noise noise;
  for (int i = 0; i < 50000; ++i) {
    LocalContact& contact = rig.contact;
    contact.step = static_cast<std::uint64_t>(i) + 1;
    for (int k = 0; k < 3; ++k) contact.force[k] = hostileNumber(noise), contact.position[k] = hostileNumber(noise);
    for (int k = 0; k < 9; ++k) contact.stiffness(k) = hostileNumber(noise), contact.damping(k) = hostileNumber(noise);
    // Most models would be refused for a single NaN; often enough they are merely absurd.
    if (i % 2) contact.force = 1e250 * noise.vector(), contact.stiffness = 1e300 * Mat3::Identity(), contact.damping = -contact.stiffness,
               contact.position.setConstant(1e-310);
    contact.planeCount = static_cast<int>(4.0 * noise());
    for (ContactPlane& plane : contact.planes) plane.normal = i % 3 ? Vec3(noise.vector().normalized()) : Vec3(1e200 * noise.vector());
    contact.touching = i % 5 != 0;
    contact.puncture = i % 11 == 0;
    rig.tickOnly();
    ASSERT_TRUE(allFinite(rig.output.force)) << i;
    ASSERT_LE(rig.output.force.norm(), 3.3 + 1e-9) << i;
    ASSERT_TRUE(allFinite(rig.output.sample.pose.position) && allFinite(rig.output.sample.velocity)) << i;
    ASSERT_TRUE(std::isfinite(rig.state.observedEnergy)) << i;
  }
  // And afterwards it is a working loop again.
  SpringWall wall{500.0, 0.5};
  rig.steps = 100000;
  rig.target.pose.position.y() = -2e-3;
  for (int i = 0; i < 3000; ++i) rig.advance(wall);
  EXPECT_NEAR(rig.output.force.y(), 1.0, 0.1);
}

}  // namespace
}  // namespace halsted::haptics
