/// `halsted devices` as a user meets it: the real program and the real libusb, with device models on the cable.
#include "haptics/open_device/open_model.h"
#include "haptics/touch/touch_model.h"
#include "tests/usb/program.h"

namespace halsted::haptics {
namespace {

using halsted::testing::ProcessResult;
using halsted::testing::runHalsted;
using halsted::testing::TemporaryFolder;
using halsted::testing::UsbEmulation;
using ::testing::HasSubstr;
using nlohmann::json;

class DevicesCommand : public halsted::testing::WithEmulation {
 protected:
  static json list(std::vector<std::string> more = {}, int exitCode = 0) {
    more.insert(more.begin(), {"devices", "--json"});
    return outcome(runHalsted(more), exitCode);
  }
  static void expectOneLine(const std::string& text) { EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text; }
};

TEST_F(DevicesCommand, NamesEveryKnownDeviceAndWhatItCanDoWithIt) {
  UsbEmulation usb;
  FalconModel falcon(FalconRig::homedFalcon());
  OpenModel open;
  TouchModel touch(TouchType::kSerial), early(TouchType::kSerialEarly), hid(TouchType::kHid);
  for (UsbModel* model : std::initializer_list<UsbModel*>{&falcon, &open, &touch, &early, &hid}) usb.plug(*model);
  const json attached = list()["attached"];
  ASSERT_EQ(attached.size(), 5u);
  EXPECT_EQ(attached[0]["title"], "Novint Falcon");
  EXPECT_EQ(attached[0]["serial"], "FALCON0");
  EXPECT_EQ(attached[0]["ready"], true);
  EXPECT_EQ(attached[1]["driver"], "open");
  EXPECT_EQ(attached[1]["ready"], true);
  for (int i = 2; i < 5; ++i) {
    EXPECT_EQ(attached[i]["drivable"], false);
    EXPECT_EQ(attached[i]["ready"], false);
    EXPECT_THAT(attached[i]["problem"].get<std::string>(), HasSubstr("not public"));
    EXPECT_THAT(attached[i]["remedy"].get<std::string>(), HasSubstr("libHD.so"));
  }
  for (int i = 2; i < 4; ++i) {
    EXPECT_EQ(attached[i]["state"], "identified");
    EXPECT_EQ(attached[i]["firmware"], "Touch model 1.0");
    EXPECT_EQ(attached[i]["serial"], "TM-0001");
  }
  EXPECT_EQ(attached[4]["state"], "listed");
  const std::string text = runHalsted({"devices"}).output;
  EXPECT_THAT(text, HasSubstr("ready: --left falcon"));
  EXPECT_THAT(text, HasSubstr("its servo protocol is not public: install the vendor's driver"));
}

TEST_F(DevicesCommand, SaysWhatKeepsAFalconFromWorking) {
  UsbEmulation usb;
  FalconModelOptions options;
  options.firmware = modelFirmware();
  FalconModel bare(options);
  options.firmware.clear();
  options.serial = "UNHOMED";
  FalconModel unhomed(options);
  options.serial = "BUSY";
  FalconModel busy(options);
  usb.plug(bare);
  usb.plug(unhomed);
  EXPECT_EQ(list()["attached"].size(), 2u);              // what waits for its user is no fault
  usb.faults(usb.plug(busy)).refuseOpen = UsbStatus::kBusy;
  const json attached = list({}, 3)["attached"];
  ASSERT_EQ(attached.size(), 3u);
  EXPECT_THAT(attached[0]["remedy"].get<std::string>(), HasSubstr("--firmware"));
  EXPECT_EQ(attached[1]["problem"], "not calibrated");
  EXPECT_EQ(attached[1]["state"], "homing");
  EXPECT_EQ(attached[2]["problem"], "in use by another program");
  for (int i = 0; i < 3; ++i) EXPECT_EQ(attached[i]["fault"], i == 2);

  const TemporaryFolder folder;
  const std::vector<std::uint8_t> firmware = modelFirmware();
  halsted::testing::writeText(folder.file("falcon.bin"), {firmware.begin(), firmware.end()});
  EXPECT_EQ(list({"--firmware", folder.file("falcon.bin")}, 3)["attached"][0]["problem"], "not calibrated");
  EXPECT_EQ(runHalsted({"devices", "--firmware", folder.file("none.bin")}).exitCode, 2);
}

TEST_F(DevicesCommand, NothingAttachedIsSaidWithTheRemedy) {
  UsbEmulation usb;
  EXPECT_THAT(runHalsted({"devices"}).output, HasSubstr("No haptic device is attached: plug it in"));
  const ProcessResult train = runHalsted({"train", "purse_string", "--headless", "--left", "falcon"});
  EXPECT_EQ(train.exitCode, 3);
  EXPECT_THAT(train.errors, HasSubstr("falcon: not attached; plug it in"));
  expectOneLine(train.errors);
}

TEST_F(DevicesCommand, ForceCheckPushesEachWayAndWithinItsBounds) {
  UsbEmulation usb;
  FalconModel falcon(FalconRig::homedFalcon());
  usb.plug(falcon);
  const ProcessResult result = runHalsted({"devices", "--test", "falcon", "--json"});
  const json check = json::parse(result.output);
  EXPECT_EQ(result.exitCode, 0) << result.output;
  EXPECT_EQ(check["passed"], true);
  EXPECT_EQ(check["pushes"].size(), 6u);
  EXPECT_LE(check["largest_force_n"].get<double>(), 1.8);
}

}  // namespace
}  // namespace halsted::haptics
