/// A training session with a Falcon on the real libusb, and with everything that can happen to its cable. What was recorded must replay
/// to the bit whatever happened.
#include <algorithm>
#include <cmath>

#include "app/hardware.h"
#include "haptics/open_device/open_model.h"
#include "tests/usb/program.h"

namespace halsted::haptics {
namespace {

using halsted::testing::enough;
using halsted::testing::homedFalcon;
using halsted::testing::pause;
using halsted::testing::ProcessResult;
using halsted::testing::runHalsted;
using halsted::testing::startHalsted;
using halsted::testing::TemporaryFolder;
using halsted::testing::UsbEmulation;
using ::testing::HasSubstr;
using ::testing::Not;
using nlohmann::json;

TEST(DefaultDevices, AHandWithoutAChoiceTakesWhatTheOtherHasNotGot) {
  const auto chosen = [](std::vector<std::string> attached, std::string left, std::string right) {
    app::takeAttached(std::move(attached), left, right);
    return left + "|" + right;
  };
  EXPECT_EQ(chosen({}, "", ""), "|");
  EXPECT_EQ(chosen({"falcon:A"}, "", ""), "|falcon:A");
  EXPECT_EQ(chosen({"falcon:A", "open:B"}, "", ""), "open:B|falcon:A");
  EXPECT_EQ(chosen({"falcon:A"}, "virtual", ""), "virtual|falcon:A");
  EXPECT_EQ(chosen({"falcon:A"}, "", "falcon:A"), "|falcon:A");
  EXPECT_EQ(chosen({"falcon:A", "falcon:B"}, "falcon", ""), "falcon|falcon:B");
  EXPECT_EQ(chosen({"falcon:A", "falcon:B"}, "falcon:A", ""), "falcon:A|falcon:B");
  EXPECT_EQ(chosen({"falcon:A", "falcon:AB"}, "", "falcon:AB"), "falcon:A|falcon:AB");
  EXPECT_EQ(chosen({"falcon:A"}, "script:x", "mouse"), "script:x|mouse");
}

class TrainUsb : public halsted::testing::WithEmulation {
 protected:
  /// An empty name leaves the choice of that hand's device to the program.
  std::vector<std::string> command(const std::string& left, const std::string& right, const std::string& seconds) const {
    std::vector<std::string> words{"train", "purse_string", "--headless", "--size", "160x90", "--json", "--seconds", seconds, "--record", folder.file("a.halsted")};
    if (!left.empty()) words.insert(words.end(), {"--left", left});
    if (!right.empty()) words.insert(words.end(), {"--right", right});
    return words;
  }
  void expectWhole() const {
    const ProcessResult replay = runHalsted({"replay", folder.file("a.halsted"), "--verify"});
    EXPECT_EQ(replay.exitCode, 0) << replay.errors;
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
  EXPECT_GT(result["steps"].get<int>(), enough(500));
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
  const json report = outcome(result);
  EXPECT_GT(report["physics"]["paused_s"].get<double>(), 1.0);
  EXPECT_GT(report["steps"].get<int>(), enough(500));
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
  EXPECT_GT(outcome(result)["steps"].get<int>(), enough(100));
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
  EXPECT_GT(outcome(running.get())["steps"].get<int>(), enough(500));
  expectWhole();
}

TEST_F(TrainUsb, TwoFalconsGoToTheHandsThatNameThem) {
  FalconModel a(homedFalcon("A")), b(homedFalcon("B"));
  usb.plug(a);
  usb.plug(b);
  a.moveHand(Vec3(0.03, 0.0, 0.0));
  b.moveHand(Vec3(-0.03, 0.0, 0.0));
  auto running = startHalsted(command("falcon:B", "falcon:A", "4"));
  const json result = outcome(running.get());
  EXPECT_GT(result["steps"].get<int>(), enough(300));
  EXPECT_GT(a.commands(), 200u);
  EXPECT_GT(b.commands(), 200u);
  expectWhole();
}

/// A session with two Falcons of which one leaves: which hand was it?
TEST_F(TrainUsb, AfterASwapOfTheCablesEachHandHasItsOwnDeviceAgain) {
  FalconModel a(homedFalcon("A")), b(homedFalcon("B"));
  const int first = usb.plug(a), second = usb.plug(b);
  auto running = startHalsted(command("falcon:A", "falcon:B", "9"));
  pause(3.5);
  usb.unplug(first);
  usb.unplug(second);
  pause(0.7);
  std::uint64_t before[2];
  {
    const std::lock_guard guard(usb.lock());
    before[0] = a.commands();
    before[1] = b.commands();
  }
  usb.replug(first, b);                        // each cable in the other socket
  pause(1.0);
  {
    const std::lock_guard guard(usb.lock());
    EXPECT_EQ(a.commands(), before[0]);
    EXPECT_GT(b.commands(), before[1]) << "known by its serial number, wherever it is";
  }
  usb.replug(second, a);
  pause(1.2);
  usb.unplug(second);                          // and A is still the left one
  const ProcessResult result = running.get();
  EXPECT_THAT(result.errors, HasSubstr("the right device is back"));
  const std::size_t back = result.errors.find("the left device is back");
  ASSERT_NE(back, std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find("the left device is away (unplugged)", back), std::string::npos) << result.errors;
  EXPECT_GT(outcome(result)["steps"].get<int>(), enough(500));
  expectWhole();
}

TEST_F(TrainUsb, ADeviceThatLostItsHomeGoesOnOnceItIsHomedAgain) {
  FalconModel falcon(homedFalcon("A"));
  FalconModelOptions unhomed;
  unhomed.serial = "A";
  FalconModel afterPowerLoss(unhomed);
  const int port = usb.plug(falcon);
  auto running = startHalsted(command("virtual", "falcon", "9"));
  pause(3.5);
  usb.unplug(port);
  pause(0.6);
  usb.replug(port, afterPowerLoss);
  pause(1.5);
  EXPECT_EQ(afterPowerLoss.motorForce().norm(), 0.0) << "no force before it is homed";
  {
    const std::lock_guard guard(usb.lock());
    afterPowerLoss.moveHand(Vec3(0.0, 0.0, -0.04));
  }
  const ProcessResult result = running.get();
  EXPECT_THAT(result.errors, HasSubstr("the right device is away (unplugged): the session waits"));
  EXPECT_THAT(result.errors, HasSubstr("the right device is back: the session goes on"));
  EXPECT_TRUE(afterPowerLoss.homed());
  const json report = outcome(result);
  EXPECT_GT(report["physics"]["paused_s"].get<double>(), 1.8) << "also while it waits for its user";
  expectWhole();
}

TEST_F(TrainUsb, WhereNothingIsChosenTheFirstDeviceIsTheRightHandAndTheSecondTheLeft) {
  FalconModel a(homedFalcon("A")), b(homedFalcon("B"));
  usb.plug(a);
  const int second = usb.plug(b);
  auto running = startHalsted(command("", "", "5"));
  pause(3.5);
  usb.unplug(second);
  const ProcessResult result = running.get();
  EXPECT_THAT(result.errors, HasSubstr("the left device is away"));
  EXPECT_THAT(result.errors, Not(HasSubstr("the right device is away")));
  EXPECT_GT(outcome(result)["steps"].get<int>(), enough(100));
  EXPECT_GT(std::min(a.commands(), b.commands()), 100u);
  expectWhole();
}

TEST_F(TrainUsb, WhereOneHandIsChosenTheOtherTakesWhatIsLeft) {
  FalconModel a(homedFalcon("A")), b(homedFalcon("B"));
  usb.plug(a);
  const int second = usb.plug(b);
  auto running = startHalsted(command("falcon:A", "", "5"));
  pause(3.5);
  usb.unplug(second);
  EXPECT_THAT(running.get().errors, HasSubstr("the right device is away"));
  EXPECT_GT(a.commands(), 100u);
  FalconModel c(homedFalcon("C"));
  usb.replug(second, c);
  const json result = outcome(startHalsted(command("", "virtual", "3")).get());
  EXPECT_GT(result["steps"].get<int>(), enough(100));
  expectWhole();
}

TEST_F(TrainUsb, WhereNothingIsAttachedBothHandsAreVirtual) {
  const ProcessResult result = runHalsted(command("", "", "2"));
  EXPECT_THAT(result.errors, Not(HasSubstr("device")));
  EXPECT_GT(outcome(result)["steps"].get<int>(), enough(500));
  expectWhole();
}

TEST_F(TrainUsb, AnOpenDeviceTrainsToo) {
  OpenModel open;
  usb.plug(open);
  const json result = outcome(startHalsted(command("open:OPEN0", "virtual", "4")).get());
  EXPECT_GT(result["steps"].get<int>(), enough(500));
  expectWhole();
}

}  // namespace
}  // namespace halsted::haptics
