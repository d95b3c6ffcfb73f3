#pragma once
/// The shipped program beside emulated devices: it inherits the emulation from this process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "haptics/falcon/falcon_model.h"
#include "tests/haptics/usb/falcon_rig.h"
#include "tests/support/process.h"
#include "tests/usb/usb_emulation.h"

namespace halsted::testing {

inline ProcessResult runHalsted(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), HALSTED_BINARY);
  return run(arguments);
}

/// The same, going on while the test pulls cables.
inline std::future<ProcessResult> startHalsted(const std::vector<std::string>& arguments) {
  return std::async(std::launch::async, [arguments] { return runHalsted(arguments); });
}

inline void pause(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }  // [s]

/// As many steps as a session must have taken; under a sanitizer physics falls behind.
inline int enough(int steps) {
#ifdef HALSTED_SANITIZED
  return steps / 25;
#else
  return steps;
#endif
}

/// A Falcon that waits for nothing but its driver.
inline haptics::FalconModelOptions homedFalcon(const std::string& serial) {
  haptics::FalconModelOptions options = haptics::FalconRig::homedFalcon();
  options.serial = serial;
  return options;
}

/// Tests that need the emulation and look at what the program says.
class WithEmulation : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(UsbEmulation::available()) << "run through ctest: it needs LD_PRELOAD=libumockdev-preload.so.0";
  }
  static nlohmann::json outcome(const ProcessResult& result, int exitCode = 0) {
    EXPECT_EQ(result.exitCode, exitCode) << result.errors;
    return nlohmann::json::parse(result.output);
  }
};

}  // namespace halsted::testing
