#include "haptics/virtual_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "haptics/replay_device.h"

namespace halsted::haptics {
namespace {

constexpr double kDeviceTick = 1e-3;  // [s]

HandTarget at(const Vec3& position) {
  HandTarget target;
  target.pose.position = position;
  target.valid = true;
  return target;
}

/// Runs `seconds` with a constant motor force and returns the last reading.
DeviceReading run(VirtualDevice& device, double seconds, const Vec3& force = Vec3::Zero()) {  // [s] [N]
  DeviceReading reading;
  for (int i = 0; i < static_cast<int>(seconds / kDeviceTick + 0.5); ++i) {
    reading = device.read(kDeviceTick);
    device.write(force);
  }
  return reading;
}

HandDynamics noHand() {
  HandDynamics hand;
  hand.stiffness = hand.damping = hand.visualGain = 0.0;
  return hand;
}

TEST(VirtualTouch, ReadsMultiplesOfItsResolution) {
  VirtualDevice device;
  device.setTarget(at(Vec3(0.0123, -0.0077, 0.0031)));
  for (int i = 0; i < 400; ++i) {
    const Vec3 counts = device.read(kDeviceTick).pose.position / 0.055e-3;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(counts[axis], std::round(counts[axis]), 1e-6);
    EXPECT_LE((device.position() - counts * 0.055e-3).cwiseAbs().maxCoeff(), 0.0275e-3 + 1e-12);
  }
}

TEST(VirtualTouch, FrictionHoldsBelowItsThresholdAndMassAcceleratesAboveIt) {
  VirtualDevice still({}, {}, noHand()), moving({}, {}, noHand());
  run(still, 1.0, Vec3(0.25, 0.0, 0.0));
  EXPECT_EQ(still.position(), Vec3(Vec3::Zero()));
  run(moving, 0.021, Vec3(0.71, 0.0, 0.0));  // the first read comes before the first force: 20 ms under force
  // (0.71 - 0.26) N on 45 g with 0.1 N s/m: v = a t to first order, less 2 % of viscosity.
  EXPECT_NEAR(moving.velocity().x(), 10.0 * 0.020 * (1.0 - 0.5 * 0.020 * 0.1 / 0.045), 0.005);
}

TEST(VirtualTouch, MotorGivesNoMoreThanItsPeak) {
  VirtualDevice strong({}, {}, noHand()), absurd({}, {}, noHand());
  run(strong, 0.02, Vec3(3.3, 0.0, 0.0));
  run(absurd, 0.02, Vec3(1e300, 0.0, 0.0));
  EXPECT_EQ(strong.position(), absurd.position());
}

TEST(VirtualTouch, HandReachesItsTargetThroughFriction) {
  for (const Vec3& goal : {Vec3(0.03, 0.0, 0.0), Vec3(-0.01, 0.02, 0.005), Vec3(0.0004, 0.0, 0.0)}) {
    VirtualDevice device;
    device.setTarget(at(goal));
    run(device, goal.norm() / 0.25 + 0.35);
    EXPECT_LT((device.position() - goal).norm(), 0.06e-3) << goal.transpose();
    double far = 0.0;  // [m] and it stays there: looking does not make it hunt
    for (int i = 0; i < 2000; ++i) {
      run(device, kDeviceTick);
      far = std::max(far, (device.position() - goal).norm());
    }
    EXPECT_LT(far, 0.06e-3) << goal.transpose();
  }
}

TEST(VirtualTouch, HandDoesNotOvershootMuchAndStaysWithinItsSpeed) {
  VirtualDevice device;
  device.setTarget(at(Vec3(0.04, 0.0, 0.0)));
  double farthest = 0.0, fastest = 0.0;  // [m] [m/s]
  for (int i = 0; i < 1000; ++i) {
    run(device, kDeviceTick);
    farthest = std::max(farthest, device.position().x());
    fastest = std::max(fastest, device.velocity().norm());
  }
  EXPECT_LT(farthest, 0.040 + 0.6e-3);
  EXPECT_LT(fastest, 0.25 * 1.15);  // the tip catches up with the aim
}

TEST(VirtualTouch, ForceMovesTheHandAndTheEyeBringsItBack) {
  VirtualDevice device;
  device.setTarget(at(Vec3::Zero()));
  run(device, 0.05, Vec3(0.0, 1.0, 0.0));
  EXPECT_GT(device.position().y(), 0.6e-3);  // (1 - 0.26) N on 400 N/m is 1.85 mm, less what the eye has added by then
  EXPECT_LT(device.position().y(), 1.85e-3);
  run(device, 0.6, Vec3(0.0, 1.0, 0.0));
  EXPECT_LT(std::abs(device.position().y()), 0.06e-3);
}

TEST(VirtualTouch, ReleasedAfterALongPushTheHandSettlesSoon) {
  VirtualDevice device;
  device.setTarget(at(Vec3::Zero()));
  run(device, 5.0, Vec3(0.0, 3.3, 0.0));  // more than looking may add: the integral must not have wound up
  double farthest = 0.0;  // [m]
  for (int i = 0; i < 500; ++i) {
    run(device, kDeviceTick);
    farthest = std::max(farthest, -device.position().y());
  }
  EXPECT_LT(farthest, 2.0 / 400.0);
  EXPECT_LT(device.position().norm(), 0.06e-3);
}

TEST(VirtualTouch, StopsHoldTheWorkspace) {
  VirtualDevice device;
  device.setTarget(at(Vec3(0.5, -0.5, 0.5)));
  run(device, 5.0);
  EXPECT_LT(std::abs(device.position().x()), 0.080 + 0.120);
  VirtualDevice free({}, {}, noHand());
  run(free, 5.0, Vec3(3.3, 0.0, 0.0));
  EXPECT_NEAR(free.position().x(), 0.080 + 3.3 / 2000.0, 0.26 / 2000.0 + 1e-6);
}

TEST(VirtualTouch, HoldsStillWithoutATarget) {
  VirtualDevice device({Vec3(0.01, 0.02, -0.01), Quat::Identity()});
  for (int i = 0; i < 500; ++i) {
    device.setTarget({});
    device.read(kDeviceTick);
    device.write(Vec3::Zero());
  }
  EXPECT_LT((device.position() - Vec3(0.01, 0.02, -0.01)).norm(), 1e-12);
}

TEST(VirtualTouch, OrientationFollowsAtAHandsRate) {
  VirtualDevice device;
  HandTarget target = at(Vec3::Zero());
  target.pose.orientation = Quat(Eigen::AngleAxisd(1.5, Vec3(1, 2, 3).normalized()));
  device.setTarget(target);
  Quat last = Quat::Identity();
  for (int i = 0; i < 400; ++i) {
    const Quat now = device.read(kDeviceTick).pose.orientation;
    EXPECT_LE(now.angularDistance(last), 12.0 * kDeviceTick * 1.05);
    EXPECT_NEAR(now.norm(), 1.0, 1e-12);
    last = now;
  }
  EXPECT_LT(last.angularDistance(target.pose.orientation), 1e-4);
}

TEST(VirtualTouch, JawMovesAtItsRate) {
  VirtualDevice device;
  HandTarget target = at(Vec3::Zero());
  target.jaw = 0.0;
  device.setTarget(target);
  EXPECT_NEAR(run(device, 0.1).jaw, 0.3, 1e-9);
  EXPECT_NEAR(run(device, 0.1).jaw, 0.0, 1e-12);
}

TEST(VirtualTouch, HostileTargetsAndTimesLeaveItFinite) {
  VirtualDevice device;
  HandTarget bad = at(Vec3(std::nan(""), 0.0, 0.0));
  device.setTarget(bad);
  device.read(kDeviceTick);
  bad = at(Vec3::Zero());
  bad.pose.orientation.coeffs().setConstant(std::nan(""));
  bad.jaw = 7.0;
  device.setTarget(bad);
  for (const double dt : {0.0, -1.0, 1e9, std::nan(""), 1e-12}) {
    const DeviceReading reading = device.read(dt);
    EXPECT_TRUE(reading.pose.position.allFinite());
    EXPECT_NEAR(reading.pose.orientation.norm(), 1.0, 1e-9);
  }
  device.write(Vec3(std::nan(""), 0.0, 0.0));
  EXPECT_TRUE(device.read(kDeviceTick).pose.position.allFinite());
}

TEST(VirtualTouch, SameInputSameBits) {
  VirtualDevice one, two;
  for (int i = 0; i < 2000; ++i) {
    const HandTarget target = at(Vec3(0.02 * (i % 300), -0.01 * (i % 170), 0.005) * 0.005);
    const Vec3 force(0.01 * (i % 97) - 0.5, 0.02 * (i % 31) - 0.3, 0.1);
    one.setTarget(target), two.setTarget(target);
    const DeviceReading a = one.read(kDeviceTick), b = two.read(kDeviceTick);
    one.write(force), two.write(force);
    ASSERT_EQ(0, std::memcmp(a.pose.position.data(), b.pose.position.data(), 3 * sizeof(double)));
    ASSERT_EQ(0, std::memcmp(one.velocity().data(), two.velocity().data(), 3 * sizeof(double)));
  }
}

TEST(VirtualTouch, SaysWhenItIsUnplugged) {
  VirtualDevice device;
  device.setConnected(false);
  EXPECT_FALSE(device.read(kDeviceTick).connected);
  EXPECT_FALSE(device.write(Vec3(1.0, 0.0, 0.0)));
}

TEST(ReplayDevice, GivesBackWhatWasRecordedAndThenItsLast) {
  std::vector<DeviceReading> readings(3);
  for (int i = 0; i < 3; ++i) readings[i].pose.position.x() = i, readings[i].presses = static_cast<std::uint32_t>(i);
  ReplayDevice device(readings);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(device.read(kDeviceTick).presses, static_cast<std::uint32_t>(i));
  EXPECT_TRUE(device.finished());
  EXPECT_EQ(device.read(kDeviceTick).pose.position.x(), 2.0);
  EXPECT_TRUE(device.write(Vec3::Zero()));
}

TEST(ReplayDevice, WithNothingRecordedIsGone) {
  ReplayDevice device({});
  EXPECT_FALSE(device.read(kDeviceTick).connected);
  EXPECT_FALSE(device.write(Vec3::Zero()));
}

}  // namespace
}  // namespace halsted::haptics
