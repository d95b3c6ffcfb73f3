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
constexpr int kNeedlingSteps = 18000;          // of a few microseconds each: until the needle is twirled

std::string hashesOf(const Scenario& scenario, int steps) {
  Lockstep run(scenario);
  std::string text;
  for (int i = 1; i <= steps; ++i) {
    if (!run.advance()) break;
    if (i % (steps / 6) == 0) text += std::to_string(i) + " " + hexadecimal(hash(run.state())) + "\n";
  }
  return text;
}

void expectGolden(const std::string& name, const std::string& found) {
  const std::string path = halsted::testing::sourceFolder() + "/tests/golden/" + name + ".txt";
  if (std::getenv("HALSTED_WRITE_GOLDEN")) halsted::testing::writeText(path, found);
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(found, halsted::testing::readText(path));
}

class SolverHash : public ::testing::TestWithParam<const char*> {};

TEST_P(SolverHash, IsReachedByEveryCompilerAndBuild) {
  const std::string solver = GetParam();
  expectGolden("purse_string_" + solver, hashesOf(expertScenario({"tissue.solver=" + solver}), kSteps));
}

TEST(GoldenHash, OfTheNeedledSlabIsReachedByEveryCompilerAndBuild) {
  const std::string script = halsted::testing::sourceFolder() + "/scenes/acupuncture/expert.toml";
  expectGolden("acupuncture_slab", hashesOf(scenarioFromFile(script, {}), kNeedlingSteps));
}

INSTANTIATE_TEST_SUITE_P(GoldenHash, SolverHash, ::testing::Values("projective", "xpbd", "shape_matching"),
                         [](const auto& solver) { return std::string(solver.param); });

}  // namespace
}  // namespace halsted::app
