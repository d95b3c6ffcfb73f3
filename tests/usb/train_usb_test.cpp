/// A training session with a Falcon on the real libusb, and with everything that can happen to its cable. What was recorded must replay
/// to the bit whatever happened.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "haptics/falcon/falcon_model.h"
#include "haptics/open_device/open_model.h"
#include "tests/haptics/usb/falcon_rig.h"
#include "tests/usb/program.h"
#include "tests/usb/usb_emulation.h"

namespace halsted::haptics {
namespace {

using halsted::testing::ProcessResult;
using halsted::testing::runHalsted;
using halsted::testing::startHalsted;
using halsted::testing::TemporaryFolder;
using halsted::testing::UsbEmulation;
using ::testing::HasSubstr;
using nlohmann::json;

void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

class TrainUsb : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(UsbEmulation::available()) << "run through ctest: it needs LD_PRELOAD=libumockdev-preload.so.0";
  }
  std::vector<std::string> command(const std::string& left, const std::string& right, const std::string& seconds) const {
    return {"train", "purse_string", "--headless", "--size", "160x90", "--json", "--left", left, "--right", right, "--seconds", seconds, "--record", folder.file("a.halsted")};
  }
  void expectWhole() const {
    const ProcessResult replay = runHalsted({"replay", folder.file("a.halsted"), "--verify"});
    EXPECT_EQ(replay.exitCode, 0) << replay.errors;
  }
  static json outcome(const ProcessResult& result) {
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    return json::parse(result.output);
  }
  TemporaryFolder folder;
  UsbEmulation usb;
};

TEST_F(TrainUsb, FalconLeftAndVirtualRightTrainAndReplay) {
  FalconModel falcon(FalconRig::homedFalcon());
  usb.plug(falcon);
  auto running = startHalsted(command("falcon", "virtual", "4"));
  for (int i = 0; i < 60; ++i) {
    pause(0.1);
    const std::lock_guard guard(usb.lock());
    falcon.moveHand(Vec3(0.02 * std::sin(0.3 * i), 0.01 * std::cos(0.2 * i), 0.0));
  }
  const json result = outcome(running.get());
  EXPECT_GT(result["steps"].get<int>(), 500);
  EXPECT_GT(falcon.commands(), 500u);
  EXPECT_EQ(falcon.lights(), kFalconBlue) << "let go at the end";
  expectWhole();
}

TEST_F(TrainUsb, APulledCablePausesTheSessionAndItGoesOn) {
  FalconModel falcon(FalconRig::homedFalcon());
  const int port = usb.plug(falcon);
  auto running = startHalsted(command("falcon", "virtual", "8"));
  pause(4.0);
  usb.unplug(port);
  pause(1.5);
  usb.replug(port);
  const ProcessResult result = running.get();
  EXPECT_THAT(result.errors, HasSubstr("the left device is away (unplugged): the session waits. plug the cable in again"));
  EXPECT_THAT(result.errors, HasSubstr("the left device is back: the session goes on"));
  const json json = outcome(result);
  EXPECT_GT(json["physics"]["paused_s"].get<double>(), 1.0);
  EXPECT_GT(json["steps"].get<int>(), 500);
  expectWhole();
}

TEST_F(TrainUsb, AnUnhomedFalconHoldsTheSessionUntilItsUserHomesIt) {
  FalconModel falcon;
  usb.plug(falcon);
  auto running = startHalsted(command("virtual", "falcon", "7"));
  pause(3.0);
  {
    const std::lock_guard guard(usb.lock());
    falcon.moveHand(Vec3(0.0, 0.0, -0.04));
  }
  const ProcessResult result = running.get();
  EXPECT_THAT(result.errors, HasSubstr("the right device is away (not calibrated): the session waits. pull the grip"));
  EXPECT_GT(outcome(result)["steps"].get<int>(), 100);
  expectWhole();
}

TEST_F(TrainUsb, StallsAndBrokenPacketsLeaveTheSessionWhole) {
  FalconModel falcon(FalconRig::homedFalcon());
  const int port = usb.plug(falcon);
  auto running = startHalsted(command("falcon", "virtual", "8"));
  pause(3.0);
  for (const double stall : {5e-3, 50e-3, 500e-3}) {
    {
      const std::lock_guard guard(usb.lock());
      usb.faults(port).silentFor = stall;
      usb.faults(port).corruptPackets = 20;
      usb.faults(port).shortPackets = 20;
      usb.faults(port).failedTransfers = 2;
    }
    pause(1.2);
  }
  EXPECT_GT(outcome(running.get())["steps"].get<int>(), 500);
  expectWhole();
}

TEST_F(TrainUsb, TwoFalconsGoToTheHandsThatNameThem) {
  FalconModelOptions options = FalconRig::homedFalcon();
  options.serial = "A";
  FalconModel a(options);
  options.serial = "B";
  FalconModel b(options);
  usb.plug(a);
  usb.plug(b);
  a.moveHand(Vec3(0.03, 0.0, 0.0));
  b.moveHand(Vec3(-0.03, 0.0, 0.0));
  auto running = startHalsted(command("falcon:B", "falcon:A", "4"));
  const json result = outcome(running.get());
  EXPECT_GT(result["steps"].get<int>(), 300);
  EXPECT_GT(a.commands(), 200u);
  EXPECT_GT(b.commands(), 200u);
  expectWhole();
}

TEST_F(TrainUsb, AnOpenDeviceTrainsToo) {
  OpenModel open;
  usb.plug(open);
  const json result = outcome(startHalsted(command("open:OPEN0", "virtual", "4")).get());
  EXPECT_GT(result["steps"].get<int>(), 500);
  expectWhole();
}

}  // namespace
}  // namespace halsted::haptics
