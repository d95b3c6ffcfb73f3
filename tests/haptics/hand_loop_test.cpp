#include "haptics/hand_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "tests/haptics/bench_rig.h"
#include "tests/haptics/replay_rig.h"

namespace halsted::haptics {
namespace {

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

TEST(HandLoop, ToolPinchedBetweenTwoWallsFeelsBoth) {
  // The net force points into the plane of the weaker wall: that is no adhesion, the other wall pushes.
  for (const double side : {-1.0, 1.0}) {
    ReplayRig rig({readingAt(Vec3(side * 1e-3, 0.0, 0.0))});
    rig.contact = bilateral(1, Vec3(0.1, 0.0, 0.0), 500.0);
    rig.contact.planeCount = 2;
    rig.contact.planes[0].normal = Vec3::UnitX();
    rig.contact.planes[1].normal = -Vec3::UnitX();
    for (int i = 0; i < 40; ++i) rig.next();
    EXPECT_NEAR(rig.output.force.x(), 0.1 - side * 0.5, 1e-6);
  }
}

TEST(HandLoop, ANearWallThatDoesNotPushLeavesTheForceAlone) {
  ReplayRig rig({readingAt(Vec3(0.0, -0.5e-3, 0.0))});
  rig.contact = bilateral(1, Vec3(0.3, 0.5, 0.0), 500.0);  // pressed on the floor, friction to the right
  rig.contact.planeCount = 2;
  rig.contact.planes[0].normal = Vec3::UnitY();
  rig.contact.planes[1].normal = -Vec3::UnitX();           // a wall on the right
  for (int i = 0; i < 40; ++i) rig.next();
  EXPECT_NEAR((rig.output.force - Vec3(0.3, 0.75, 0.0)).norm(), 0.0, 1e-5);
}

TEST(HandLoop, PlanesWithoutContactGiveNoForceUnlessPublishedAhead) {
  for (const bool ahead : {false, true}) {
    ReplayRig rig({readingAt(Vec3(0.0, -1e-3, 0.0))});
    rig.contact = bilateral(1, Vec3::Zero(), 500.0);
    rig.contact.touching = false;
    rig.contact.ahead = ahead;
    rig.contact.planeCount = 1;
    rig.contact.planes[0].normal = Vec3::UnitY();
    for (int i = 0; i < 40; ++i) rig.next();
    EXPECT_NEAR((rig.output.force - Vec3(0.0, ahead ? 0.5 : 0.0, 0.0)).norm(), 0.0, 1e-6);
  }
}

/// A shaft that lies on tissue touches it at points whose normals differ by tens of degrees and flicker: the force must stay the
/// model's. It once fed on itself through the blend, to tens of newtons.
TEST(HandLoop, ObliquePlanesLeaveTheForceOfTheModel) {
  ReplayRig rig({readingAt(Vec3::Zero())});
  for (int i = 1; i <= 3000; ++i) {
    rig.contact = bilateral(static_cast<std::uint64_t>(i), i < 300 ? Vec3(2.5, 0.1, 0.9) : Vec3(0.438, 0.073, 0.213), 750.0);
    rig.contact.planeCount = i % 3 == 0 ? 1 : 2;
    rig.contact.planes[0].normal = (i % 2 ? Vec3(0.986, 0.054, 0.156) : Vec3(0.988, 0.001, 0.156)).normalized();
    rig.contact.planes[1].normal = Vec3(0.712, 0.097, 0.695).normalized();
    rig.next();
    ASSERT_LT(rig.output.force.norm(), 2.7) << i;
  }
  EXPECT_NEAR((rig.output.force - Vec3(0.438, 0.073, 0.213)).norm(), 0.0, 0.03);
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

TEST(HandLoop, ForceAndMotionMapBetweenDeviceAndWorld) {
  HandLoopConfig config;
  config.mapping.origin.position = Vec3(0.1, -0.2, 0.3);
  config.mapping.origin.orientation = Quat(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vec3::UnitZ()));
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
