/// The Falcon driver through the real libusb, against the same model that the loopback carries.
#include <atomic>

#include "haptics/falcon/falcon_protocol.h"
#include "haptics/usb/libusb_bus.h"
#include "haptics/usb/usb_device.h"
#include "tests/usb/program.h"

namespace halsted::haptics {
namespace {

using halsted::testing::UsbEmulation;

/// Runs `turn` once a millisecond until it says so, at most `longest` seconds.
template <typename Turn>
bool until(double longest, Turn&& turn) {
  for (int i = 0; i < static_cast<int>(longest * 1000); ++i) {
    if (turn()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

class LibusbFalcon : public halsted::testing::WithEmulation {
 protected:
  void begin(const FalconModelOptions& options, std::vector<std::uint8_t> firmware = {}) {
    model = std::make_unique<FalconModel>(options);
    emulation = std::make_unique<UsbEmulation>();
    port = emulation->plug(*model);
    bus = std::make_shared<LibusbBus>();
    device = std::make_unique<UsbDevice>(bus, std::make_unique<FalconProtocol>(std::move(firmware)));
    service = std::thread([this] { device->serve(stop); });
  }
  void TearDown() override {
    stop.store(true);
    if (service.joinable()) service.join();
    device.reset();
    bus.reset();
  }
  bool ready() { return device->status().stage == DeviceStage::kReady; }

  std::unique_ptr<FalconModel> model;
  std::unique_ptr<UsbEmulation> emulation;
  std::shared_ptr<LibusbBus> bus;
  std::unique_ptr<UsbDevice> device;
  std::thread service;
  std::atomic<bool> stop{false};
  int port = 0;
};

TEST_F(LibusbFalcon, IsListedWithIdsPortAndSerial) {
  FalconModel falcon(FalconRig::homedFalcon());
  UsbEmulation usb;
  usb.plug(falcon);
  LibusbBus real;
  ASSERT_TRUE(real.available());
  const auto found = real.list();
  ASSERT_EQ(found.size(), 2u);                 // the hub and the Falcon
  EXPECT_EQ(found[1].vendor, kFalconVendor);
  EXPECT_EQ(found[1].product, kFalconProduct);
  EXPECT_EQ(found[1].port, "1-1");
  EXPECT_EQ(found[1].serial, "FALCON0");
  EXPECT_EQ(found[1].productName, "FALCON HAPTIC");
}

TEST_F(LibusbFalcon, ComesUpReadsAndPushes) {
  begin(FalconRig::homedFalcon());
  ASSERT_TRUE(until(5.0, [&] { return device->read(1e-3), ready(); }));
  {
    const std::lock_guard guard(emulation->lock());
    model->moveHand(Vec3(0.02, -0.01, 0.01));
  }
  Vec3 read = Vec3::Zero();
  const bool arrived = until(5.0, [&] {
    const DeviceReading reading = device->read(1e-3);
    device->write(Vec3(0.0, 2.0, 0.0));
    read = reading.pose.position;
    const std::lock_guard guard(emulation->lock());
    return (model->motorForce() - Vec3(0.0, 2.0, 0.0)).norm() < 0.05 && (read - model->grip().position()).norm() < 0.2e-3;
  });
  const std::lock_guard guard(emulation->lock());
  EXPECT_TRUE(arrived) << read.transpose() << " for " << model->grip().position().transpose() << ", force " << model->motorForce().transpose();
}

TEST_F(LibusbFalcon, UploadsTheUsersFirmware) {
  FalconModelOptions options = FalconRig::homedFalcon();
  options.firmware = modelFirmware();
  begin(options, modelFirmware());
  EXPECT_TRUE(until(20.0, [&] { return ready(); })) << problemText(device->status().problem);
  const std::lock_guard guard(emulation->lock());
  EXPECT_TRUE(model->running());
}

TEST_F(LibusbFalcon, UnplugIsSeenAndTheSameDeviceComesBack) {
  begin(FalconRig::homedFalcon());
  ASSERT_TRUE(until(5.0, [&] { return device->read(1e-3), ready(); }));
  emulation->unplug(port);
  EXPECT_TRUE(until(2.0, [&] { return !device->read(1e-3).connected; }));
  EXPECT_EQ(device->status().problem, DeviceProblem::kUnplugged);
  emulation->replug(port);
  EXPECT_TRUE(until(5.0, [&] { return device->read(1e-3).connected; }));
}

TEST_F(LibusbFalcon, AStalledEndpointIsClearedAndGoesOn) {
  begin(FalconRig::homedFalcon());
  ASSERT_TRUE(until(5.0, [&] { return device->read(1e-3), ready(); }));
  {
    const std::lock_guard guard(emulation->lock());
    emulation->faults(port).failedTransfers = 3;
  }
  EXPECT_TRUE(until(2.0, [&] { return !device->read(1e-3).fresh; }));
  EXPECT_TRUE(until(2.0, [&] { return device->read(1e-3).fresh; }));
}

TEST_F(LibusbFalcon, AnotherProgramHoldsIt) {
  FalconModel falcon(FalconRig::homedFalcon());
  UsbEmulation usb;
  usb.faults(usb.plug(falcon)).refuseOpen = UsbStatus::kBusy;
  UsbDevice waiting(std::make_shared<LibusbBus>(), std::make_unique<FalconProtocol>(std::vector<std::uint8_t>{}));
  waiting.serviceOnce();
  EXPECT_EQ(waiting.status().problem, DeviceProblem::kBusy);
}

}  // namespace
}  // namespace halsted::haptics
