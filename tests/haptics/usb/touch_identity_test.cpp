/// A Touch tells firmware and serial number over its public frames, and nothing here pretends to more.
#include <gtest/gtest.h>

#include "haptics/device_status.h"
#include "haptics/touch/touch_identity.h"
#include "haptics/touch/touch_model.h"
#include "haptics/usb/known_devices.h"
#include "haptics/usb/loopback_bus.h"

namespace halsted::haptics {
namespace {

TEST(TouchIdentity, SerialTypeTellsFirmwareAndSerial) {
  for (const TouchType type : {TouchType::kSerial, TouchType::kSerialEarly}) {
    LoopbackBus bus;
    TouchModel touch(type);
    bus.plug(touch);
    const auto listed = bus.list();
    ASSERT_EQ(listed.size(), 1u);
    const KnownDevice* known = knownDevice(listed[0]);
    ASSERT_NE(known, nullptr);
    EXPECT_EQ(known->drive, Drive::kIdentified);
    EXPECT_TRUE(known->driver.empty()) << "no driver of ours moves it";
    UsbStatus status = UsbStatus::kOk;
    const auto link = bus.open(listed[0], kTouchInterfaces, status);
    ASSERT_TRUE(link);
    TouchIdentity identity;
    EXPECT_EQ(identifyTouch(*link, identity), UsbStatus::kOk);
    EXPECT_EQ(identity.firmware, "Touch model 1.0");
    EXPECT_EQ(identity.serial, "TM-0001");
  }
}

TEST(TouchIdentity, HidTypeIsOnlyListed) {
  LoopbackBus bus;
  TouchModel touch(TouchType::kHid);
  bus.plug(touch);
  const KnownDevice* known = knownDevice(bus.list()[0]);
  ASSERT_NE(known, nullptr);
  EXPECT_EQ(known->drive, Drive::kListed);
}

TEST(TouchIdentity, SilenceIsATimeoutNotAnIdentity) {
  LoopbackBus bus;
  TouchModel touch;
  const int port = bus.plug(touch);
  UsbStatus status = UsbStatus::kOk;
  const auto link = bus.open(bus.list()[0], kTouchInterfaces, status);
  bus.faults(port).silentFor = 10.0;
  TouchIdentity identity;
  EXPECT_EQ(identifyTouch(*link, identity), UsbStatus::kTimeout);
  EXPECT_TRUE(identity.firmware.empty() && identity.serial.empty());
}

TEST(TouchIdentity, FramerDropsWhatIsNoFrame) {
  TouchFramer framer;
  int frames = 0;
  for (const int byte : {0x00, 0xa5, 0xa5, 0x5a, 0x0e, 0x02, 0x68, 0x69, 0x5a, 0xa5, 0x00, 0xa5, 0x5a, 0x09, 0x00})
    frames += framer.push(static_cast<std::uint8_t>(byte)).has_value();
  EXPECT_EQ(frames, 2);
}

TEST(KnownDevices, TestIdsOfOthersAreNotTakenForOurs) {
  UsbDeviceInfo info;
  info.vendor = kOpenDeviceVendor;
  info.product = kOpenDeviceProduct;
  info.productName = "somebody's experiment";
  EXPECT_EQ(knownDevice(info), nullptr);
  info.productName = kOpenDeviceName;
  EXPECT_NE(knownDevice(info), nullptr);
}

/// One line for what is wrong, one for what to do.
TEST(DeviceStatusText, EveryProblemHasItsRemedy) {
  for (int i = 1; i < kDeviceProblems; ++i) {
    const auto problem = static_cast<DeviceProblem>(i);
    ASSERT_NE(problemText(problem), nullptr);
    EXPECT_GT(std::string(problemText(problem)).size(), 5u) << i;
    EXPECT_GT(std::string(remedyText(problem)).size(), 10u) << i;
    EXPECT_EQ(std::string(problemText(problem)).find('\n'), std::string::npos);
    EXPECT_EQ(std::string(remedyText(problem)).find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace halsted::haptics
