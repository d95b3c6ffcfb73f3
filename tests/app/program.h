#pragma once
/// The real program, as a user starts it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/process.h"

namespace halsted::app {

inline testing::ProcessResult runHalsted(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), HALSTED_BINARY);
  return testing::run(arguments);
}

/// Runs in `folder`, standard output into `output` where one is named.
inline testing::ProcessResult runIn(const std::string& folder, const std::string& command, const std::string& output = "") {
  return testing::run({"/bin/sh", "-c", "cd '" + folder + "' && '" + HALSTED_BINARY + "' " + command + (output.empty() ? "" : " >" + output)});
}

/// Bad usage or input: code 2 and one line that mentions it.
inline void expectRefused(const std::vector<std::string>& arguments, const std::string& mentions) {
  const testing::ProcessResult result = runHalsted(arguments);
  EXPECT_EQ(result.exitCode, 2) << result.errors;
  EXPECT_THAT(result.errors, ::testing::HasSubstr(mentions));
  EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
}

}  // namespace halsted::app
