/// HL and HLU: there is no haptic rendering, and every call says so in the interface's own way; nothing is written, nothing crashes.
#include <HL/hl.h>
#include <HLU/hlu.h>

#include <cstring>
#include <set>
#include <string>

#include "tests/hd/hd_rig.h"

namespace halsted::hdtest {
namespace {

class Hl : public Hd {
 protected:
  Hl() { errors(); }
  static std::vector<HLerror> errors() {
    std::vector<HLerror> all;
    for (HLerror error = hlGetError(); HL_ERROR(error); error = hlGetError()) all.push_back(error);
    return all;
  }
};

TEST_F(Hl, NoContextCanBeMadeAndTheReasonIsADeviceError) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  EXPECT_EQ(hlCreateContext(device), nullptr);
  const auto all = errors();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].errorCode, HL_DEVICE_ERROR);
  EXPECT_EQ(all[0].errorInfo.errorCode, static_cast<HDerror>(HD_INVALID_OPERATION));
  EXPECT_EQ(all[0].errorInfo.hHD, device);
  EXPECT_EQ(hlGetCurrentContext(), nullptr);
  EXPECT_TRUE(drain().empty()) << "the device itself is in order";
}

TEST_F(Hl, CallsWithoutAContextAreInvalidAndWriteNothing) {
  HLdouble numbers[16] = {7};
  HLboolean flag = 9;
  hlGetDoublev(HL_PROXY_POSITION, numbers);
  hlGetBooleanv(HL_BUTTON1_STATE, &flag);
  hlBeginFrame();
  hlStartEffect(HL_EFFECT_SPRING, hlGenEffects(1));
  hluFitWorkspace(numbers);
  EXPECT_EQ(hluScreenToModelScale(numbers, numbers, nullptr), 0.0);
  hlMakeCurrent(nullptr);                                             // to have none is allowed
  const auto all = errors();
  EXPECT_EQ(all.size(), 7u);
  for (const HLerror& error : all) EXPECT_EQ(error.errorCode, HL_INVALID_OPERATION);
  EXPECT_EQ(numbers[0], 7.0);
  EXPECT_EQ(flag, 9);
  EXPECT_FALSE(hlIsEnabled(HL_HAPTIC_CAMERA_VIEW));
}

TEST_F(Hl, ErrorsComeLastFirstAndTheOldestAreLost) {
  hlCreateContext(3);
  for (int i = 0; i < 63; ++i) hlEndFrame();
  EXPECT_EQ(errors().back().errorCode, HL_DEVICE_ERROR);
  hlCreateContext(3);
  for (int i = 0; i < 64; ++i) hlEndFrame();
  const auto all = errors();
  EXPECT_EQ(all.size(), 64u);
  EXPECT_EQ(all.back().errorCode, HL_INVALID_OPERATION);
}

TEST_F(Hl, NamesAreTextsThatDifferAndTheLibrarySaysWhatItIs) {
  std::set<std::string> texts;
  int names = 0;
#define HALSTED_HL_NAME(NAME) ++names, texts.insert(NAME);
#include <HL/hlNames.h>
#undef HALSTED_HL_NAME
  EXPECT_EQ(static_cast<int>(texts.size()), names);
  EXPECT_STREQ(HL_EVENT_1BUTTONDOWN, "HL_EVENT_1BUTTONDOWN");
  EXPECT_NE(std::string(reinterpret_cast<const char*>(hlGetString(HL_VENDOR))).find("not provided"), std::string::npos);
}

}  // namespace
}  // namespace halsted::hdtest
