/// A training session with devices of the vendor's library, and what can become of them. What was recorded must replay to the bit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/support/process.h"

namespace halsted::haptics {
namespace {

using halsted::testing::ProcessResult;
using ::testing::HasSubstr;
using ::testing::Not;
using nlohmann::json;

class TrainVendor : public ::testing::Test {
 protected:
  static ProcessResult halsted(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), HALSTED_BINARY);
    return halsted::testing::run(arguments);
  }
  ProcessResult train(const char* fault, const std::string& left, const std::string& right, const std::string& seconds) const {
    setenv("HALSTED_VENDOR_LIBHD", HALSTED_FAULTY_VENDOR_LIBRARY, 1);
    setenv("HALSTED_FAULTY_VENDOR", fault, 1);
    return halsted({"train", "purse_string", "--headless", "--size", "160x90", "--json", "--left", left, "--right", right, "--seconds",
                    seconds, "--record", folder.file("a.halsted")});
  }
  void expectWhole(const ProcessResult& result, int steps) const {
#ifdef HALSTED_SANITIZED
    steps /= 25;                               // physics falls behind
#endif
    ASSERT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_GT(json::parse(result.output)["steps"].get<int>(), steps);
    const ProcessResult replay = halsted({"replay", folder.file("a.halsted"), "--verify"});
    EXPECT_EQ(replay.exitCode, 0) << replay.errors;
  }
  ~TrainVendor() override {
    unsetenv("HALSTED_VENDOR_LIBHD");
    unsetenv("HALSTED_FAULTY_VENDOR");
  }
  halsted::testing::TemporaryFolder folder;
};

TEST_F(TrainVendor, NumbersThatAreNoneLeaveTheRecordingWhole) {
  const ProcessResult result = train("nan", "vendor", "virtual", "4");
  EXPECT_THAT(result.errors, HasSubstr("left hand"));                  // the fault is said
  EXPECT_THAT(result.errors, Not(HasSubstr("the session waits")));
  expectWhole(result, 500);
}

TEST_F(TrainVendor, AStallOfHalfASecondLeavesTheRecordingWhole) { expectWhole(train("stall", "vendor", "virtual", "4"), 500); }

TEST_F(TrainVendor, ALostDevicePausesTheSessionAndItGoesOnWhenItIsBack) {
  const ProcessResult result = train("replug", "vendor", "virtual", "7");
  EXPECT_THAT(result.errors, HasSubstr("the left device is away (a transfer failed): the session waits"));
  EXPECT_THAT(result.errors, HasSubstr("the left device is back: the session goes on"));
  EXPECT_GT(json::parse(result.output)["physics"]["paused_s"].get<double>(), 0.8);
  expectWhole(result, 500);
}

TEST_F(TrainVendor, AnotherDeviceAfterTheReplugIsNotTakenAndTheRecordingStaysWhole) {
  const ProcessResult result = train("swap", "virtual", "vendor:left", "7");
  EXPECT_THAT(result.errors, HasSubstr("the right device is away"));
  EXPECT_THAT(result.errors, HasSubstr("the right device is back: the session goes on"));
  EXPECT_GT(json::parse(result.output)["physics"]["paused_s"].get<double>(), 0.8);
  expectWhole(result, 500);
}

TEST_F(TrainVendor, OfTwoDevicesOfOneKindTheOneThatLeavesIsNamed) {
  const ProcessResult result = train("lost-right", "vendor:left", "vendor:right", "4");
  EXPECT_THAT(result.errors, HasSubstr("the right device is away"));
  EXPECT_THAT(result.errors, Not(HasSubstr("the left device is away")));
  expectWhole(result, 50);
}

}  // namespace
}  // namespace halsted::haptics
