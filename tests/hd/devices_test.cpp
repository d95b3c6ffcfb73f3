/// Devices, their names, which one is current, and the error stack.
#include <string>
#include <thread>

#include "tests/hd/hd_rig.h"

namespace halsted::hdtest {
namespace {

using Devices = Hd;
using Errors = Hd;

TEST_F(Devices, HaveTheNamesThatProgramsUse) {
  for (const char* name : {"Default Device", "Default PHANToM", "Default PHANTOM", "left", "right", "phantom1", "Left Device"}) {
    EXPECT_EQ(hdInitDevice(name), 0u) << name;
    hdDisableDevice(0);
  }
  EXPECT_TRUE(drain().empty());
}

TEST_F(Devices, OpenOnceUnderAnyOfTheirNames) {
  EXPECT_EQ(hdInitDevice(HD_DEFAULT_DEVICE), 0u);
  EXPECT_EQ(hdInitDevice("Default PHANToM"), HD_INVALID_HANDLE);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_DEVICE_ALREADY_INITIATED});
  EXPECT_EQ(hdInitDevice("left"), 1u);
  EXPECT_EQ(hdInitDevice("no such device"), HD_INVALID_HANDLE);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_DEVICE_FAULT});
}

TEST_F(Devices, AreCurrentWhenOpenedBegunOrMadeCurrent) {
  EXPECT_EQ(hdGetCurrentDevice(), HD_INVALID_HANDLE);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_OPERATION});
  const HHD left = hdInitDevice("left"), right = hdInitDevice("right");
  EXPECT_EQ(hdGetCurrentDevice(), right);
  hdMakeCurrentDevice(left);
  EXPECT_EQ(hdGetCurrentDevice(), left);
  hdBeginFrame(right);
  EXPECT_EQ(hdGetCurrentDevice(), right);
  hdEndFrame(right);
  hdMakeCurrentDevice(99);
  EXPECT_EQ(hdGetCurrentDevice(), right);
  const HDErrorInfo error = hdGetError();
  EXPECT_EQ(error.errorCode, static_cast<HDerror>(HD_BAD_HANDLE));
  EXPECT_EQ(error.hHD, right);
}

TEST_F(Devices, OfTheClientAreThoseOfTheServoLoopUntilItChoosesItsOwn) {
  const HHD left = hdInitDevice("left"), right = hdInitDevice("right");
  hdStartScheduler();
  onServo([&] {
    EXPECT_EQ(hdGetCurrentDevice(), right);
    hdMakeCurrentDevice(left);
  });
  EXPECT_EQ(hdGetCurrentDevice(), left);  // as if the client had called it
  std::thread([&] { EXPECT_EQ(hdGetCurrentDevice(), right); }).join();  // what a client chose last
}

TEST_F(Devices, SurviveTheSwitchingOfAnAsynchronousCallback) {
  const HHD left = hdInitDevice("left"), right = hdInitDevice("right");
  hdMakeCurrentDevice(left);
  hdStartScheduler();
  Step step = [&] {
    for (const HHD device : {left, right}) {
      hdBeginFrame(device);
      hdEndFrame(device);
    }
    return HDCallbackCode{HD_CALLBACK_CONTINUE};
  };
  const HDSchedulerHandle handle = schedule(step);
  for (int i = 0; i < 20; ++i) {
    onServo([&] { EXPECT_EQ(hdGetCurrentDevice(), left); });
    EXPECT_EQ(hdGetCurrentDevice(), left);
  }
  hdUnschedule(handle);
  EXPECT_TRUE(drain().empty());
}

TEST_F(Devices, CloseOnceAndComeBack) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdDisableDevice(device);
  hdDisableDevice(device);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_BAD_HANDLE});
  EXPECT_EQ(hdInitDevice(HD_DEFAULT_DEVICE), device);
  EXPECT_TRUE(drain().empty());
}

TEST_F(Errors, ComeBackLastOneFirstThenSuccess) {
  hdInitDevice(HD_DEFAULT_DEVICE);
  hdEndFrame(0);
  hdInitDevice("nothing");
  hdEnable(0x9999);
  EXPECT_EQ(drain(), (std::vector<HDerror>{HD_INVALID_ENUM, HD_DEVICE_FAULT, HD_ILLEGAL_END}));
  EXPECT_EQ(hdGetError().errorCode, static_cast<HDerror>(HD_SUCCESS));
}

TEST_F(Errors, KeepTheNewestWhenNobodyAsks) {
  hdInitDevice(HD_DEFAULT_DEVICE);
  for (int i = 0; i < 500; ++i) hdEndFrame(0);
  hdEnable(0x9999);
  const auto codes = drain();
  EXPECT_EQ(codes.front(), static_cast<HDerror>(HD_INVALID_ENUM));
  EXPECT_LE(codes.size(), 64u);
}

TEST_F(Errors, HaveATextThatNamesThem) {
  EXPECT_EQ(std::string(hdGetErrorString(HD_ILLEGAL_BEGIN)).rfind("HD_ILLEGAL_BEGIN", 0), 0u);
  for (const HDerror code : {0x0, 0x100, 0x101, 0x102, 0x103, 0x104, 0x200, 0x201, 0x202, 0x203, 0x204, 0x300, 0x301, 0x302, 0x303, 0x304,
                             0x400, 0x401, 0x402, 0x500, 0x501, 0x600})
    EXPECT_EQ(std::string(hdGetErrorString(code)).rfind("HD_", 0), 0u) << code;
  EXPECT_NE(hdGetErrorString(0xBEEF), nullptr);
}

TEST_F(Errors, AreTwelveBytes) { EXPECT_EQ(sizeof(HDErrorInfo), 12u); }

}  // namespace
}  // namespace halsted::hdtest
