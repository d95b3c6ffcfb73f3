/// The open wire protocol: the driver against the reference firmware over the loopback, and each against what must not pass.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "haptics/hand_loop.h"
#include "haptics/open_device/open_model.h"
#include "haptics/open_device/open_protocol.h"
#include "tests/haptics/usb/falcon_rig.h"

namespace halsted::haptics {
namespace {

struct OpenRig {
  explicit OpenRig(const OpenModelOptions& options = {}) : model(options) {
    auto driver = std::make_unique<OpenProtocol>();
    protocol = driver.get();
    device = std::make_unique<UsbDevice>(borrowed(bus), std::move(driver));
    port = bus.plug(model);
  }
  void tick() {
    bus.advance(1e-3);
    device->serviceOnce();
    contact.step = ++index;
    contact.touching = true;
    haptics::tick(*device, config, contact, {}, index, state, output);
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) tick();
  }
  LoopbackBus bus;
  OpenModel model;
  OpenProtocol* protocol = nullptr;
  std::unique_ptr<UsbDevice> device;
  int port = 0;
  HandLoopConfig config;
  HandLoopState state;
  HandLoopOutput output;
  LocalContact contact;
  std::uint64_t index = 0;
};

TEST(OpenDevice, ExchangesAtItsOwnRateAndTellsWhatItIs) {
  OpenRig rig;
  rig.run(100);
  ASSERT_EQ(rig.device->status().stage, DeviceStage::kReady);
  EXPECT_EQ(rig.protocol->identity().serial, "OPEN0");
  EXPECT_EQ(rig.device->limits().peakForce, 4.0);
  EXPECT_EQ(rig.device->limits().continuousForce, 1.0);
  EXPECT_EQ(rig.device->limits().stiffness, 1500.0);
  EXPECT_NEAR(rig.device->limits().positionStep, 20e-6, 1e-12);
  const std::uint64_t before = rig.device->counters().readings;
  rig.run(2000);
  EXPECT_NEAR(static_cast<double>(rig.device->counters().readings - before), 2000.0, 3.0);
  EXPECT_EQ(rig.device->counters().corrupt, 0u);
  EXPECT_EQ(rig.model.firmware().rejected, 0u);
}

TEST(OpenDevice, PositionAndForceMeanTheSameOnBothSides) {
  OpenRig rig;
  rig.model.moveHand(Vec3(0.03, -0.02, 0.015));
  rig.contact.force = Vec3(0.6, -0.4, 0.5);
  rig.run(1500);
  EXPECT_LT((rig.output.sample.pose.position - rig.model.stylus().position()).norm(), 30e-6);
  EXPECT_LT((rig.model.motorForce() - Vec3(0.6, -0.4, 0.5)).norm(), 2e-3);
}

TEST(OpenDevice, ButtonClosesTheJaws) {
  OpenRig rig;
  rig.run(200);
  rig.model.setButtons(1);
  rig.run(200);
  EXPECT_EQ(rig.output.sample.jaw, 0.0);
  rig.model.setButtons(2);
  rig.run(200);
  EXPECT_EQ(rig.output.sample.jaw, 1.0);
  EXPECT_EQ(rig.output.sample.presses, 1u);
}

/// The limits divide by the continuous force: a device that gives none of its own cannot be driven, and would be switched on and off.
TEST(OpenDevice, AnIdentityWithoutForceIsRefused) {
  std::array<std::uint8_t, kHodIdentityBytes> payload{};
  payload[0] = payload[1] = kOpenVersion;
  const auto declared = [&](std::uint8_t peak, std::uint8_t continuous) {   // [256 mN]
    payload[7] = peak;
    payload[9] = continuous;
    OpenIdentity identity;
    return decodeIdentity(payload, identity);
  };
  EXPECT_TRUE(declared(16, 4));
  EXPECT_FALSE(declared(16, 0));
  EXPECT_FALSE(declared(0, 4));
  EXPECT_FALSE(declared(0, 0));
}

TEST(OpenDevice, AnotherVersionIsNamedAndNotDriven) {
  OpenModelOptions options;
  options.version = 2;
  OpenRig rig(options);
  rig.run(20);
  EXPECT_EQ(rig.device->status().problem, DeviceProblem::kOtherVersion);
  EXPECT_EQ(rig.model.firmware().accepted, 0u);
}

TEST(OpenDevice, UnhomedShowsNoForce) {
  OpenModelOptions options;
  options.homed = false;
  OpenRig rig(options);
  rig.contact.force = Vec3(1.0, 0.0, 0.0);
  rig.run(500);
  EXPECT_EQ(rig.device->status().stage, DeviceStage::kHoming);
  EXPECT_EQ(rig.model.motorForce().norm(), 0.0);
  rig.model.setHomed(true);
  rig.run(800);
  EXPECT_GT(rig.model.motorForce().norm(), 0.5);
}

/// Safety rule 2: the device itself lets go when the host falls silent, and says so.
TEST(OpenDevice, ItsWatchdogLetsGoTenMillisecondsAfterTheLastForce) {
  OpenRig rig;
  rig.contact.force = Vec3(1.0, 0.0, 0.0);
  rig.run(800);
  ASSERT_GT(rig.model.motorForce().norm(), 0.5);
  rig.bus.faults(rig.port).silentFor = 12e-3;
  rig.bus.advance(9e-3);
  EXPECT_GT(rig.model.motorForce().norm(), 0.5);
  rig.bus.advance(3e-3);
  EXPECT_EQ(rig.model.motorForce().norm(), 0.0);
  EXPECT_TRUE(rig.model.firmware().tripped);
  double largestRise = 0.0, before = 0.0;      // [N]
  for (int i = 0; i < 600; ++i) {
    rig.tick();
    largestRise = std::max(largestRise, rig.model.motorForce().norm() - before);
    before = rig.model.motorForce().norm();
  }
  EXPECT_GT(before, 0.5);
  EXPECT_LT(largestRise, 0.05) << "it eases in";
}

TEST(OpenDevice, CorruptShortAndDoubledPacketsNeverMoveTheTool) {
  OpenRig rig;
  rig.run(500);
  const Vec3 still = rig.output.sample.pose.position;
  for (int i = 0; i < 2000; ++i) {
    if (i % 7 == 0) ++rig.bus.faults(rig.port).corruptPackets;
    if (i % 11 == 0) ++rig.bus.faults(rig.port).shortPackets;
    rig.tick();
    ASSERT_LT((rig.output.sample.pose.position - still).norm(), 50e-6) << i;
  }
  EXPECT_GT(rig.device->counters().corrupt, 300u);
  EXPECT_EQ(rig.device->counters().opened, 1u);
}

TEST(OpenDevice, UnplugInContactIsZeroWithinTwoMilliseconds) {
  OpenRig rig;
  rig.contact.force = Vec3(0.0, 1.0, 0.0);
  rig.run(800);
  ASSERT_GT(rig.output.force.norm(), 0.5);
  rig.bus.unplug(rig.port);
  rig.run(2);
  EXPECT_EQ(rig.output.force.norm(), 0.0);
  rig.bus.replug(rig.port);
  rig.run(1500);
  EXPECT_GT(rig.model.motorForce().norm(), 0.5);
}

TEST(OpenWire, ChecksumsOfBothSidesAreTheStandardOne) {
  const std::string check = "123456789";
  const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(check.data()), check.size());
  EXPECT_EQ(openChecksum(bytes), 0x29b1);
  EXPECT_EQ(hodChecksum(bytes.data(), bytes.size()), 0x29b1);
}

/// Every single-bit error of a frame is refused by both readers.
TEST(OpenWire, NoSingleBitErrorPasses) {
  std::array<std::uint8_t, kOpenMaxFrame> packet{};
  const auto payload = forcePayload(Vec3(1.0, -2.0, 3.0), 1);
  const std::size_t size = sealOpenFrame(kOpenForce, 9, payload, packet);
  for (std::size_t bit = 0; bit < size * 8; ++bit) {
    auto broken = packet;
    broken[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
    OpenFrame frame;
    std::size_t used = 0;
    EXPECT_NE(parseOpenFrame({broken.data(), size}, frame, used), OpenParse::kFrame) << bit;
    HodDevice device;
    const HodIdentity identity{};
    hodBegin(&device, &identity);
    hodReceive(&device, broken.data(), size, 0);
    EXPECT_EQ(device.accepted, 0u) << bit;
  }
}

TEST(OpenWire, FirmwareFindsFramesInABrokenStream) {
  HodDevice device;
  HodIdentity identity{};
  identity.peakForce = 4000;
  hodBegin(&device, &identity);
  std::array<std::uint8_t, kOpenMaxFrame> packet{};
  const auto payload = forcePayload(Vec3(9.0, -9.0, 0.25), 1);
  for (int i = 0; i < 100; ++i) {
    const std::size_t size = sealOpenFrame(kOpenForce, static_cast<std::uint8_t>(i), payload, packet);
    const std::uint8_t noise[] = {0xc3, 0x00, 0xc3, 0xc3, 0x5a, 0x01, 0x02};
    hodReceive(&device, noise, static_cast<std::size_t>(i) % 8, 0);
    for (std::size_t k = 0; k < size; ++k) hodReceive(&device, &packet[k], 1, 0);
    for (std::size_t k = 0; k < kOpenMaxFrame; ++k) hodReceive(&device, noise + 1, 1, 0);   // whatever was waited for has come
  }
  EXPECT_GE(device.accepted, 50u);
  EXPECT_EQ(device.force[0], 4000) << "safety rule 4: clamped to its own peak";
  EXPECT_EQ(device.force[1], -4000);
  EXPECT_EQ(device.force[2], 250);
}

TEST(OpenWire, NotANumberIsZeroOnTheWire) {
  const auto payload = forcePayload(Vec3(std::nan(""), 1e300, -INFINITY), 1);
  EXPECT_EQ(payload[0] | payload[1] << 8, 0);
  EXPECT_EQ(payload[2] | payload[3] << 8, 32767);
  EXPECT_EQ(payload[4] | payload[5] << 8, 0);
}

}  // namespace
}  // namespace halsted::haptics
