/// What a pulled cable, a stall, a broken packet and a mixed-up pair of devices do to the force: through the loopback, in virtual time.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/haptics/usb/falcon_rig.h"
#include "tests/support/realtime_guard.h"

namespace halsted::haptics {
namespace {

/// The hand presses the grip against a spring: some newtons, steady.
struct Pressed : FalconRig {
  Pressed() {
    run(300);
    spring(Vec3(0.006, 0.0, 0.0));
    run(600);
    EXPECT_EQ(device.status().stage, DeviceStage::kReady);
    EXPECT_GT(output.force.norm(), 1.5);
    EXPECT_GT(model.motorForce().norm(), 1.5);
  }
};

TEST(UsbFaults, UnplugInContactMakesTheForceZeroWithinTwoMilliseconds) {
  Pressed rig;
  const Vec3 held = rig.output.sample.pose.position;
  rig.bus.unplug(rig.port);
  rig.run(2);
  EXPECT_EQ(rig.output.force, Vec3(Vec3::Zero()));
  EXPECT_TRUE(rig.output.faults & kFaultDeviceGone);
  EXPECT_EQ(rig.output.sample.pose.position, held) << "the tool stays where it was";
  rig.run(300);
  EXPECT_EQ(rig.device.status().stage, DeviceStage::kSearching);
  EXPECT_EQ(rig.device.status().problem, DeviceProblem::kUnplugged);
  EXPECT_EQ(rig.device.counters().failed, 1u) << "it is said once";
}

TEST(UsbFaults, AfterReplugForceEasesInAndTheToolWalksBack) {
  Pressed rig;
  rig.bus.unplug(rig.port);
  rig.run(50);
  rig.model.moveHand(Vec3(-0.004, 0.002, 0.0));                   // the hand goes on while nobody reads it
  rig.run(1000);
  const Vec3 tool = rig.output.sample.pose.position;
  rig.bus.replug(rig.port);
  double largestStep = 0.0;                    // [m]
  double largestRise = 0.0;                    // [N]
  Vec3 before = tool, force = Vec3::Zero();
  for (int i = 0; i < 1500; ++i) {
    rig.tick();
    largestStep = std::max(largestStep, (rig.output.sample.pose.position - before).norm());
    largestRise = std::max(largestRise, rig.output.force.norm() - force.norm());
    before = rig.output.sample.pose.position;
    force = rig.output.force;
  }
  EXPECT_EQ(rig.output.faults & kFaultCutMask, 0u);
  EXPECT_LT(largestStep, 0.5e-3) << "no jump through the tissue";
  EXPECT_LT(largestRise, 0.2);
  EXPECT_GT(rig.output.force.norm(), 1.0);
  EXPECT_LT((rig.output.sample.pose.position - rig.model.grip().position()).norm(), 0.2e-3);
}

/// Its motors hold their last command while the cable is out (the unkind assumption); after the replug the first packet lets go.
TEST(UsbFaults, ReplugSendsZeroFirst) {
  Pressed rig;
  rig.bus.unplug(rig.port);
  rig.run(100);
  rig.bus.replug(rig.port);
  for (int i = 0; i < 100 && rig.device.status().stage != DeviceStage::kReady; ++i) rig.tick();
  ASSERT_EQ(rig.device.status().stage, DeviceStage::kReady);
  EXPECT_EQ(rig.model.motorForce().norm(), 0.0);
}

void stall(double seconds, bool cut, bool reopened) {  // [s]
  Pressed rig;
  const std::uint64_t opened = rig.device.counters().opened;
  rig.bus.faults(rig.port).silentFor = seconds;
  const int ticks = static_cast<int>(seconds * 1e3);
  bool zero = false;
  for (int i = 0; i < ticks; ++i) {
    rig.tick();
    if (i > 12) {
      EXPECT_EQ(rig.output.force.norm(), 0.0) << seconds << " s, tick " << i;
    }
    zero = zero || rig.output.force.norm() == 0.0;
  }
  EXPECT_EQ(zero, cut) << seconds;
  double largestRise = 0.0, force = rig.output.force.norm();  // [N]
  for (int i = 0; i < 1500; ++i) {
    rig.tick();
    largestRise = std::max(largestRise, rig.output.force.norm() - force);
    force = rig.output.force.norm();
  }
  EXPECT_LT(largestRise, 0.2) << seconds;
  EXPECT_GT(force, 1.5) << seconds << ": it goes on";
  EXPECT_EQ(rig.output.faults & kFaultCutMask, 0u);
  EXPECT_EQ(rig.device.counters().opened > opened, reopened) << seconds;
}

TEST(UsbFaults, AStallOf5MillisecondsIsBridged) { stall(5e-3, false, false); }
TEST(UsbFaults, AStallOf50MillisecondsCutsTheForceAndItEasesIn) { stall(50e-3, true, false); }
TEST(UsbFaults, AStallOf500MillisecondsBeginsAgain) { stall(500e-3, true, true); }

TEST(UsbFaults, ShortAndCorruptPacketsAreDroppedAndAskedForAgain) {
  Pressed rig;
  const std::uint64_t before = rig.device.counters().corrupt;
  double largestStep = 0.0;                    // [m]
  Vec3 last = rig.output.sample.pose.position;
  for (int i = 0; i < 1000; ++i) {
    if (i % 20 == 0) ++rig.bus.faults(rig.port).corruptPackets;
    if (i % 20 == 10) ++rig.bus.faults(rig.port).shortPackets;
    rig.tick();
    largestStep = std::max(largestStep, (rig.output.sample.pose.position - last).norm());
    last = rig.output.sample.pose.position;
  }
  EXPECT_GE(rig.device.counters().corrupt - before, 40u);
  EXPECT_LT(largestStep, 0.6e-3) << "no broken packet moved the tool";
  EXPECT_GT(rig.output.force.norm(), 1.5);
  EXPECT_EQ(rig.device.counters().opened, 1u);
}

TEST(UsbFaults, OneFailedTransferIsZeroForceAtTheNextTickAndPassesOver) {
  Pressed rig;
  rig.bus.faults(rig.port).failedTransfers = 1;
  rig.run(2);
  EXPECT_EQ(rig.output.force.norm(), 0.0);
  EXPECT_TRUE(rig.output.faults & kFaultDeviceSilent);
  rig.run(700);
  EXPECT_GT(rig.output.force.norm(), 1.5);
  EXPECT_EQ(rig.device.counters().opened, 1u);
}

TEST(UsbFaults, ACableThatFailsForEverIsOpenedAgain) {
  Pressed rig;
  rig.bus.faults(rig.port).failedTransfers = 20;
  rig.bus.faults(rig.port).failure = UsbStatus::kFailed;
  rig.run(3000);
  EXPECT_GE(rig.device.counters().opened, 2u);
  EXPECT_GT(rig.output.force.norm(), 1.5);
}

/// The haptic thread stops writing: the driver itself lets go after 10 ms.
TEST(UsbFaults, ATickThatStopsLetsTheMotorsGo) {
  Pressed rig;
  for (int i = 0; i < 15; ++i) {
    rig.bus.advance(1e-3);
    rig.device.serviceOnce();
  }
  EXPECT_EQ(rig.model.motorForce().norm(), 0.0);
}

TEST(UsbFaults, NotANumberAsForceReachesNoMotor) {
  Pressed rig;
  for (int i = 0; i < 20; ++i) {
    rig.bus.advance(1e-3);
    rig.device.serviceOnce();
    rig.device.write(Vec3(std::nan(""), 1e300, -1e300));
    ASSERT_EQ(rig.model.motorForce().norm() < 10.0, true);
  }
}

TEST(UsbFaults, PermissionAndBusyAreToldApart) {
  for (const auto& [refusal, problem] : {std::pair{UsbStatus::kNoPermission, DeviceProblem::kNoPermission}, std::pair{UsbStatus::kBusy, DeviceProblem::kBusy}}) {
    FalconRig rig;
    rig.bus.faults(rig.port).refuseOpen = refusal;
    rig.run(5);
    EXPECT_EQ(rig.device.status().problem, problem);
    rig.bus.faults(rig.port).refuseOpen = UsbStatus::kOk;
    rig.run(700);
    EXPECT_EQ(rig.device.status().stage, DeviceStage::kReady) << "it is tried again by itself";
  }
}

FalconModelOptions falconNamed(const std::string& serial) {
  FalconModelOptions options = FalconRig::homedFalcon();
  options.serial = serial;
  return options;
}

/// Two Falcons and their hands on one bus.
struct TwoFalcons {
  explicit TwoFalcons(const std::string& first = "A", const std::string& second = "B") : a(falconNamed(first)), b(falconNamed(second)) {
    portA = bus.plug(a);
    portB = bus.plug(b);
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      bus.advance(1e-3);
      for (UsbDevice* device : {&left, &right}) {
        device->serviceOnce();
        (device == &left ? leftReading : rightReading) = device->read(1e-3);
        device->write(Vec3::Zero());
      }
    }
  }
  LoopbackBus bus;
  FalconModel a, b;
  int portA = 0, portB = 0;
  UsbDevice left{borrowed(bus), std::make_unique<FalconProtocol>(std::vector<std::uint8_t>{})};
  UsbDevice right{borrowed(bus), std::make_unique<FalconProtocol>(std::vector<std::uint8_t>{})};
  DeviceReading leftReading, rightReading;
};

TEST(UsbFaults, TwoOfOneKindGoToTwoHands) {
  TwoFalcons two;
  two.a.moveHand(Vec3(0.02, 0.0, 0.0));
  two.b.moveHand(Vec3(-0.02, 0.0, 0.0));
  two.run(1500);
  EXPECT_EQ(two.left.binding().serial, "A");
  EXPECT_EQ(two.right.binding().serial, "B");
  EXPECT_NEAR(two.leftReading.pose.position.x(), 0.02, 1e-3);
  EXPECT_NEAR(two.rightReading.pose.position.x(), -0.02, 1e-3);
}

/// Both cables out, plugged in again the other way round: each hand keeps its own device, by serial number.
TEST(UsbFaults, SwappedPortsDoNotSwapTheHands) {
  TwoFalcons two;
  two.a.moveHand(Vec3(0.02, 0.0, 0.0));
  two.b.moveHand(Vec3(-0.02, 0.0, 0.0));
  two.run(1500);
  two.bus.unplug(two.portA);
  two.bus.unplug(two.portB);
  two.run(100);
  EXPECT_FALSE(two.leftReading.connected || two.rightReading.connected);
  two.bus.plug(two.b);                         // a new port each, in the other order
  two.run(200);
  EXPECT_FALSE(two.leftReading.connected) << "B is not the left hand's";
  EXPECT_TRUE(two.rightReading.connected);
  two.bus.plug(two.a);
  two.run(700);
  EXPECT_TRUE(two.leftReading.connected);
  EXPECT_NEAR(two.leftReading.pose.position.x(), 0.02, 1e-3);
  EXPECT_NEAR(two.rightReading.pose.position.x(), -0.02, 1e-3);
}

/// Without serial numbers only the port tells them apart.
TEST(UsbFaults, WithoutSerialThePortDecides) {
  TwoFalcons two("", "");
  two.run(600);
  EXPECT_EQ(two.left.binding().port, "1-1");
  EXPECT_EQ(two.right.binding().port, "1-2");
  two.bus.unplug(two.portA);
  two.run(700);
  EXPECT_FALSE(two.leftReading.connected);
  EXPECT_TRUE(two.rightReading.connected);
}

/// The tick's side of a device on a cable: no heap, lock, sleep or file in 10 000 ticks with every fault in them.
TEST(UsbFaults, TheTickNeverWaitsForTheCable) {
  if (!test::RealtimeGuard::available()) GTEST_SKIP() << "the sanitizer owns malloc";
  FalconRig rig;
  rig.run(300);
  std::uint64_t calls = 0;
  for (int i = 0; i < 10000; ++i) {
    if (i % 3000 == 1000) rig.bus.unplug(rig.port);
    if (i % 3000 == 1400) rig.bus.replug(rig.port);
    if (i % 500 == 50) rig.bus.faults(rig.port).failedTransfers = 1;
    if (i % 700 == 300) rig.bus.faults(rig.port).silentFor = 30e-3;
    rig.bus.advance(1e-3);
    rig.device.serviceOnce();
    rig.contact.step = ++rig.steps;
    test::RealtimeGuard guard;
    haptics::tick(rig.device, rig.config, rig.contact, rig.target, ++rig.index, rig.state, rig.output);
    calls += guard.calls();
    ASSERT_EQ(calls, 0u) << guard.first() << " in tick " << i;
  }
}

}  // namespace
}  // namespace halsted::haptics
