#pragma once
/// The shipped program beside emulated devices: it inherits the emulation from this process.
#include <future>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/process.h"

namespace halsted::testing {

inline ProcessResult runHalsted(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), HALSTED_BINARY);
  return run(arguments);
}

/// The same, going on while the test pulls cables.
inline std::future<ProcessResult> startHalsted(const std::vector<std::string>& arguments) {
  return std::async(std::launch::async, [arguments] { return runHalsted(arguments); });
}

}  // namespace halsted::testing
