/// The Falcon driver against the Falcon model over the loopback: bring-up, exchange, position, force, buttons, homing.
#include <gtest/gtest.h>

#include "haptics/falcon/falcon_kinematics.h"
#include "tests/haptics/usb/falcon_rig.h"

namespace halsted::haptics {
namespace {

TEST(FalconLoopback, ExchangesAThousandTimesASecond) {
  FalconRig rig;
  rig.run(100);
  ASSERT_EQ(rig.device.status().stage, DeviceStage::kReady);
  const std::uint64_t before = rig.device.counters().readings;
  rig.run(2000);
  EXPECT_NEAR(static_cast<double>(rig.device.counters().readings - before), 2000.0, 20.0);
  EXPECT_EQ(rig.device.counters().corrupt, 0u);
  EXPECT_EQ(rig.device.counters().failed, 0u);
}

TEST(FalconLoopback, ReadsWhereTheGripIsToItsEncoders) {
  FalconRig rig;
  for (const Vec3& place : {Vec3(0.0, 0.0, 0.0), Vec3(0.03, -0.02, 0.01), Vec3(-0.025, 0.03, -0.02), Vec3(0.0, 0.0, 0.04)}) {
    rig.model.moveHand(place);
    rig.run(1500);
    EXPECT_LT((rig.output.sample.pose.position - rig.model.grip().position()).norm(), 0.1e-3) << place.transpose();
    EXPECT_EQ(rig.output.faults & kFaultCutMask, 0u);
  }
}

TEST(FalconLoopback, TheHandFeelsTheForceThatTheTickAskedFor) {
  FalconRig rig;
  rig.run(300);
  rig.spring(Vec3(0.004, -0.003, 0.002));
  rig.run(800);
  ASSERT_GT(rig.output.force.norm(), 1.0);
  EXPECT_LT((rig.model.motorForce() - rig.output.force).norm(), 0.05) << "motor counts and a tick of delay";
  // A spring pulls the grip toward its anchor against the hand that holds the middle.
  EXPECT_GT(rig.model.grip().position().dot(Vec3(0.004, -0.003, 0.002)), 0.0);
}

TEST(FalconLoopback, CentreButtonClosesTheJawsAndOthersCount) {
  FalconRig rig;
  rig.run(200);
  EXPECT_EQ(rig.output.sample.jaw, 1.0);
  rig.model.setButtons(kFalconCentre);
  rig.run(200);
  EXPECT_EQ(rig.output.sample.jaw, 0.0);
  rig.model.setButtons(0);
  rig.run(200);
  EXPECT_EQ(rig.output.sample.jaw, 1.0);
  for (int i = 0; i < 3; ++i) {
    rig.model.setButtons(kFalconPlus);
    rig.run(20);
    rig.model.setButtons(0);
    rig.run(20);
  }
  EXPECT_EQ(rig.output.sample.presses, 3u);
}

TEST(FalconLoopback, WithoutFirmwareItAsksForTheFile) {
  FalconModelOptions options;
  options.firmware = modelFirmware();
  FalconRig rig(options);
  rig.run(700);
  EXPECT_EQ(rig.device.status().stage, DeviceStage::kSearching);
  EXPECT_EQ(rig.device.status().problem, DeviceProblem::kFirmwareMissing);
  EXPECT_FALSE(rig.model.running());
}

TEST(FalconLoopback, UploadsTheUsersFirmwareAndRunsIt) {
  FalconModelOptions options;
  options.firmware = modelFirmware();
  options.homed = true;
  FalconRig rig(options, modelFirmware());
  rig.run(50);
  EXPECT_TRUE(rig.model.running());
  EXPECT_EQ(rig.device.status().stage, DeviceStage::kReady);
}

TEST(FalconLoopback, AnotherFileIsRefusedByName) {
  FalconModelOptions options;
  options.firmware = modelFirmware();
  std::vector<std::uint8_t> other = modelFirmware();
  other[4000] ^= 1;
  FalconRig rig(options, other);
  rig.run(5);
  EXPECT_EQ(rig.device.status().problem, DeviceProblem::kFirmwareRefused);
}

/// Until every arm has passed its mark the position is not known: no force, and the light is red.
TEST(FalconLoopback, NoForceBeforeHoming) {
  FalconRig rig(FalconModelOptions{});
  rig.run(200);
  EXPECT_EQ(rig.device.status().stage, DeviceStage::kHoming);
  EXPECT_EQ(rig.device.status().problem, DeviceProblem::kNeedsHoming);
  EXPECT_EQ(rig.model.lights(), kFalconRed);
  rig.spring(Vec3(0.02, 0.0, 0.0));
  for (int i = 0; i < 300; ++i) {
    rig.tick();
    ASSERT_EQ(rig.model.motorForce().norm(), 0.0) << i;
    ASSERT_TRUE(rig.output.faults & kFaultDeviceGone);
  }
  rig.model.moveHand(Vec3(0.0, 0.0, -0.04));                     // the user pushes the grip in
  rig.run(1500);
  rig.model.moveHand(Vec3::Zero());
  rig.run(1500);
  EXPECT_EQ(rig.device.status().stage, DeviceStage::kReady);
  EXPECT_EQ(rig.model.lights(), kFalconGreen);
  EXPECT_GT(rig.model.motorForce().norm(), 1.0);
  EXPECT_LT((rig.output.sample.pose.position - rig.model.grip().position()).norm(), 0.1e-3);
}

}  // namespace
}  // namespace halsted::haptics
