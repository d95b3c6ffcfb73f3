#include "haptics/hand_loop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "haptics/replay_device.h"
#include "tests/haptics/bench_rig.h"

namespace halsted::haptics {
namespace {

/// A loop around recorded readings: the position is exactly what the test says.
struct ReplayRig {
  explicit ReplayRig(const std::vector<DeviceReading>& readings) : device(readings) { state.limits.ramp = 1.0; }
  Vec3 next() {
    tick(device, config, contact, {}, ++index, state, output);
    return output.force;
  }
  ReplayDevice device;
  HandLoopConfig config;
  HandLoopState state;
  HandLoopOutput output;
  LocalContact contact;
  std::uint64_t index = 0;
};

DeviceReading readingAt(const Vec3& position) {  // [m]
  DeviceReading reading;
  reading.pose.position = position;
  return reading;
}

/// A grasp: it may push and pull.
LocalContact bilateral(std::uint64_t step, const Vec3& force, double stiffness = 300.0) {  // [N] [N/m]
  LocalContact contact;
  contact.step = step;
  contact.touching = true;
  contact.force = force;
  contact.stiffness = Mat3::Identity() * stiffness;
  return contact;
}

/// Numbers without a library's generator: the same on every machine.
struct Noise {
  std::uint64_t state = 1;
  double operator()() {  // [1] in [-1, 1)
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state >> 11) / 4503599627370496.0 - 1.0;
  }
  Vec3 vector() { return {(*this)(), (*this)(), (*this)()}; }
};

TEST(HandLoop, ForceIsContinuousWhenTheModelIsReplaced) {
  ReplayRig rig({readingAt(Vec3(0.01, 0.0, 0.0))});
  Noise noise;
  Vec3 last = Vec3::Zero();
  for (int i = 0; i < 5000; ++i) {
    if (i % 7 == 0) {  // any force and stiffness, touching or not, with planes or without
      rig.contact = bilateral(static_cast<std::uint64_t>(i) + 1, 1.5 * noise.vector(), 500.0 * (1.0 + noise()));
      rig.contact.position = Vec3(0.01, 0.0, 0.0) + 1e-3 * noise.vector();
      rig.contact.touching = i % 5 != 0;
      rig.contact.planeCount = i % 3;
      for (ContactPlane& plane : rig.contact.planes) plane.normal = noise.vector().normalized(), plane.point = Vec3(-1, -1, -1);
    }
    const Vec3 force = rig.next();
    EXPECT_LT((force - last).norm(), 0.05) << i;
    last = force;
  }
}

TEST(HandLoop, BlendIsGoneAfterTensOfMilliseconds) {
  ReplayRig rig({readingAt(Vec3::Zero())});
  rig.contact = bilateral(1, Vec3(1.0, 0.0, 0.0));
  for (int i = 0; i < 45; ++i) rig.next();
  EXPECT_NEAR(rig.output.force.x(), 1.0, 1e-3);
}

TEST(HandLoop, APunctureMayJump) {
  ReplayRig rig({readingAt(Vec3::Zero())});
  for (int i = 1; i < 100; ++i) rig.contact = bilateral(i, Vec3(0.0, 0.9, 0.0)), rig.next();
  rig.contact = bilateral(100, Vec3(0.0, 0.2, 0.0));
  rig.contact.puncture = true;
  EXPECT_NEAR(rig.next().y(), 0.2, 1e-12);
}

TEST(HandLoop, SampleActsOnTheForceOfTheSameTick) {
  std::vector<DeviceReading> readings(20, readingAt(Vec3::Zero()));
  readings.push_back(readingAt(Vec3(0.0, -0.055e-3, 0.0)));
  ReplayRig rig(readings);
  rig.contact = bilateral(1, Vec3::Zero(), 1000.0);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(rig.next().y(), 0.0);
  EXPECT_NEAR(rig.next().y(), 0.055, 1e-9);  // one count on one newton per millimetre, no tick later
}

TEST(HandLoop, AModelOfNeedleThreadOrGraspPushesAndPulls) {
  for (const double side : {-1.0, 1.0}) {
    ReplayRig rig({readingAt(Vec3(0.0, side * 2e-3, 0.0))});
    rig.contact = bilateral(1, Vec3::Zero(), 300.0);
    for (int i = 0; i < 40; ++i) rig.next();
    EXPECT_NEAR(rig.output.force.y(), -side * 0.6, 1e-6);
  }
}

TEST(HandLoop, PlanesNeverPull) {
  ReplayRig rig({readingAt(Vec3(0.0, 3e-3, 0.0))});
  rig.contact = bilateral(1, Vec3(0.2, 0.5, 0.0), 500.0);
  rig.contact.planeCount = 1;
  rig.contact.planes[0].normal = Vec3::UnitY();
  for (int i = 0; i < 40; ++i) {
    rig.next();
    EXPECT_GE(rig.output.force.y(), -1e-12);
  }
  EXPECT_NEAR(rig.output.force.x(), 0.2, 1e-6);  // friction along the plane stays
}

TEST(HandLoop, ForceFallsToZeroWithin100MillisecondsOfAStalledPhysics) {
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

TEST(HandLoop, NonFiniteModelIsZeroInTheSameTickAndPassesOver) {
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

TEST(HandLoop, BadReadingKeepsTheLastPoseAndCutsTheForce) {
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

TEST(HandLoop, LostDeviceIsAFaultAndItsReturnEasesIn) {
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

TEST(HandLoop, FasterThanAHandCutsTheForce) {
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

TEST(HandLoop, TwoDevicesNeverShareAForce) {
  SpringWall wall{800.0, 0.5};
  Rig pressing, free, alone;
  pressing.target.pose.position.y() = -2e-3;
  free.target.pose.position.y() = alone.target.pose.position.y() = 5e-3;
  for (int i = 0; i < 3000; ++i) {
    if (i == 1500) pressing.contact.force.x() = std::nan(""), pressing.contact.step = ++pressing.steps;
    pressing.advance(wall);
    free.advance(wall);
    ASSERT_EQ(free.output.force, Vec3(Vec3::Zero())) << i;
  }
  EXPECT_GT(pressing.output.force.norm(), 0.5);
  // The free hand moved to the same bits as one that shares its process with nobody.
  for (int i = 0; i < 3000; ++i) alone.advance(wall);
  EXPECT_EQ(0, std::memcmp(alone.device.position().data(), free.device.position().data(), 3 * sizeof(double)));
}

TEST(HandLoop, SameInputSameBits) {
  Rig one, two;
  SoftTissue tissueOne, tissueTwo;
  Noise noise;
  for (int i = 0; i < 5000; ++i) {
    if (i % 100 == 0) one.target.pose.position = two.target.pose.position = 8e-3 * noise.vector();
    one.advance(tissueOne);
    two.advance(tissueTwo);
    ASSERT_EQ(0, std::memcmp(one.output.force.data(), two.output.force.data(), 3 * sizeof(double))) << i;
    ASSERT_EQ(0, std::memcmp(one.output.sample.pose.position.data(), two.output.sample.pose.position.data(), 3 * sizeof(double))) << i;
  }
  EXPECT_GT(one.peak, 0.1);
}

double hostileNumber(Noise& noise) {
  static constexpr double kNumbers[] = {0.0, -0.0, 5e-324, 1e-310, 1e-200, 1e-3, 1.0, 3.3, 1e6, 1e100, 1e200, 1e300, 1.7976931348623157e308};
  const int index = static_cast<int>((noise() + 1.0) * 7.5);  // 13 and 14: NaN, infinity
  if (index == 13) return std::nan("");
  if (index == 14) return std::numeric_limits<double>::infinity();
  return (noise() < 0.0 ? -1.0 : 1.0) * kNumbers[index];
}

TEST(HandLoop, HostileModelsLeaveForceFiniteAndWithinThePeak) {
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

TEST(HandLoop, ForceAndMotionMapBetweenDeviceAndWorld) {
  HandLoopConfig config;
  config.mapping.origin.position = Vec3(0.1, -0.2, 0.3);
  config.mapping.origin.orientation = Quat(Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitZ()));
  config.mapping.scale = 2.0;
  const Pose device{Vec3(0.01, 0.02, 0.03), Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX()))};
  const Pose world = toWorld(config.mapping, device);
  EXPECT_NEAR((world.position - Vec3(0.1 - 0.04, -0.2 + 0.02, 0.3 + 0.06)).norm(), 0.0, 1e-12);
  const Pose back = toDevice(config.mapping, world);
  EXPECT_NEAR((back.position - device.position).norm(), 0.0, 1e-12);
  EXPECT_NEAR(back.orientation.angularDistance(device.orientation), 0.0, 1e-7);

  // A force along world y leaves the device along its own x, and is reported in the world.
  Rig rig;
  rig.config.mapping = config.mapping;
  rig.target.pose = toWorld(config.mapping, {});
  for (int i = 1; i < 400; ++i) rig.contact = bilateral(i, Vec3(0.0, 1.0, 0.0), 0.0), rig.tickOnly();
  EXPECT_NEAR((rig.output.force - Vec3(0.0, 1.0, 0.0)).norm(), 0.0, 0.02);
  EXPECT_NEAR((rig.state.limits.lastForce - Vec3(1.0, 0.0, 0.0)).norm(), 0.0, 0.02);
  EXPECT_GT(rig.device.handForce().x(), -1.3);
  EXPECT_LT(rig.device.handForce().x(), -0.7);  // the hand holds against it
}

TEST(HandLoop, TargetInTheWorldIsReachedInTheWorld) {
  Rig rig;
  rig.config.mapping.origin.position = Vec3(0.02, 0.05, -0.01);
  rig.config.mapping.origin.orientation = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 1, 0).normalized()));
  rig.config.mapping.scale = 0.5;
  rig.target.pose = {Vec3(0.025, 0.052, -0.008), Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY()))};
  for (int i = 0; i < 800; ++i) rig.tickOnly();
  EXPECT_LT((rig.output.sample.pose.position - rig.target.pose.position).norm(), 0.06e-3);
  EXPECT_LT(rig.output.sample.pose.orientation.angularDistance(rig.target.pose.orientation), 1e-3);
}

TEST(HandLoop, SkippedPeriodsShowInTheIndexAndDoNotFakeSpeed) {
  std::vector<DeviceReading> readings;
  for (int i = 0; i < 400; ++i) readings.push_back(readingAt(Vec3(1e-4 * i, 0.0, 0.0)));
  ReplayRig rig(readings);  // 0.1 mm a reading, one reading every second period: 50 mm/s
  for (int i = 0; i < 100; ++i) ++rig.index, rig.next();
  EXPECT_NEAR(rig.output.sample.velocity.x(), 0.05, 1e-6);
  EXPECT_EQ(rig.output.sample.tick, 200u);
}

TEST(HandLoop, WorkDoneByAMovingSceneIsBrakedOnlyALittle) {
  // The other hand pulls the tissue, and with it this hand: energy rightly comes in. The observer may add at most its cap.
  Rig rig;
  double most = 0.0;  // [N]
  for (int i = 1; i < 2000; ++i) {
    const double pulled = 5e-6 * i;  // [m] 5 mm/s
    rig.contact = bilateral(i, Vec3(300.0 * (pulled - rig.output.sample.pose.position.x()), 0.0, 0.0), 300.0);
    rig.contact.position = rig.output.sample.pose.position;
    rig.tickOnly();
    most = std::max(most, rig.state.passiveForce.norm());
  }
  EXPECT_LE(most, rig.config.passivity.maxForce + 1e-12);
  EXPECT_LE(most, 0.02);  // 1 N s/m at this speed
}

}  // namespace
}  // namespace halsted::haptics
