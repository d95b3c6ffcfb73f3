/// One hash per scene, reached by gcc and clang, Debug and Release, on any x86-64 (DESIGN 7). The files under tests/golden are
/// rewritten by a run with HALSTED_WRITE_GOLDEN=1, on purpose and with a reason in the commit.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/lockstep.h"
#include "app/run_summary.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

constexpr int kSteps = 240;                    // a Debug build takes a quarter of a minute for it

std::string hashesOf(const std::vector<std::string>& overrides) {
  const Scenario scenario = expertScenario(overrides);
  Lockstep run(scenario);
  std::string text;
  for (int i = 1; i <= kSteps; ++i) {
    if (!run.advance()) break;
    if (i % 40 == 0) text += std::to_string(i) + " " + hexadecimal(hash(run.state())) + "\n";
  }
  return text;
}

class GoldenHash : public ::testing::TestWithParam<const char*> {};

TEST_P(GoldenHash, IsReachedByEveryCompilerAndBuild) {
  const std::string solver = GetParam();
  const std::string path = halsted::testing::sourceFolder() + "/tests/golden/purse_string_" + solver + ".txt";
  const std::string found = hashesOf({"tissue.solver=" + solver});
  if (std::getenv("HALSTED_WRITE_GOLDEN")) halsted::testing::writeText(path, found);
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(found, halsted::testing::readText(path));
}

INSTANTIATE_TEST_SUITE_P(PurseString, GoldenHash, ::testing::Values("projective", "xpbd", "shape_matching"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace halsted::app
