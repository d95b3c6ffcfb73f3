/// Hashes of every scene, and of hands at work, reached by gcc and clang, Debug and Release, on any x86-64 (DESIGN 7). The files under
/// tests/golden are rewritten by a run of these tests (`--gtest_filter=*Golden*`) with HALSTED_WRITE_GOLDEN=1, on purpose and with a reason in the commit.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "app/lockstep.h"
#include "app/run_summary.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/sim/cut_rig.h"
#include "tests/sim/laced_wall.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

constexpr int kGoldenSteps = 240;                    // a Debug build takes a quarter of a minute for it
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

void addHash(const char* when, const State& s, std::string& text) { text += std::string(when) + " " + hexadecimal(hash(s)) + "\n"; }

void expectGolden(const std::string& name, const std::string& found) {
  const std::string path = halsted::testing::sourceFolder() + "/tests/golden/" + name + ".txt";
  if (std::getenv("HALSTED_WRITE_GOLDEN")) halsted::testing::writeText(path, found);
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_EQ(found, halsted::testing::readText(path));
}

class SolverHash : public ::testing::TestWithParam<const char*> {};

TEST_P(SolverHash, IsReachedByEveryCompilerAndBuild) {
  const std::string solver = GetParam();
  expectGolden("purse_string_" + solver, hashesOf(expertScenario({"tissue.solver=" + solver}), kGoldenSteps));
}

TEST(GoldenHash, OfTheNeedledSlabIsReachedByEveryCompilerAndBuild) {
  const std::string script = halsted::testing::sourceFolder() + "/scenes/acupuncture/expert.toml";
  expectGolden("acupuncture_slab", hashesOf(scenarioFromFile(script, {}), kNeedlingSteps));
}

class SceneHash : public ::testing::TestWithParam<const char*> {};

TEST_P(SceneHash, IsReachedByEveryCompilerAndBuild) {
  const std::string scene = GetParam();
  expectGolden(scene, hashesOf(scenarioFromFile(halsted::testing::sourceFolder() + "/scenes/" + scene + "/expert.toml", {"thread.assist=knot"}), kGoldenSteps));
}

INSTANTIATE_TEST_SUITE_P(GoldenHash, SceneHash, ::testing::Values("stay", "connell", "lembert", "altemeier"),
                         [](const auto& scene) { return std::string(scene.param); });

/// What no scene's first steps reach: a knot drawn tight, its thread cut off and kept as a stitch, the next needle handed.
std::string hashesOfAKnot() {
  LacedWall w(std::vector<int>{3, -3}, ThreadContactParams{}.friction, 1);
  std::string text;
  w.drawTight(3.0, 0.4);
  EXPECT_GT(w.state.threadContacts.count, 0);
  addHash("knot", w.state, text);
  w.letGo(0.05);
  w.cutOff();
  w.goAside();
  w.ask();
  EXPECT_EQ(w.state.stitches->count, 1);
  EXPECT_EQ(w.state.supply->handed, 1);
  addHash("stitch", w.state, text);
  return text;
}

/// The left hand takes the wall's edge, the right one pushes the needle in beside it.
std::string hashesOfABite() {
  SimParams p = wallParams();
  p.thread.knots = true;
  const double radius = p.needle.arcLength / p.needle.arcAngle;   // [m]
  const auto needleAt = [&](double gap) {      // [m] of its tip before the face
    return frame(Vec3(kWallX + gap, 8.3e-3, 9.2e-3 + radius), Vec3::UnitZ(), Vec3::UnitX());
  };
  const auto jawsOver = [](double height) {    // [m] of their tips over the edge
    return frame(Vec3(0.5 * kWallX, 18e-3, kWallZ + height), Vec3::UnitX(), Vec3::UnitY());
  };
  StepRig rig(p, needleAt(0.3e-3), jawsOver(4e-3));
  for (int k = 1; k <= 60; ++k) {
    rig.input.tools[kLeft].pose = jawsOver(4e-3 - 5.5e-3 * k / 60);
    rig.step();
  }
  rig.input.tools[kLeft].jaw = 0.0;
  for (int k = 1; k <= 150; ++k) {             // 20 mm/s
    rig.needleTo(needleAt(0.3e-3 - 20e-6 * k));
    rig.step();
  }
  EXPECT_GT(rig.state.strand.holeCount, 0);
  EXPECT_GT(rig.state.tools[kLeft].grasp.count, 0);
  std::string text;
  addHash("bite", rig.state, text);
  return text;
}

TEST(GoldenHash, OfHandsAtWorkIsReachedByEveryCompilerAndBuild) { expectGolden("hands_at_work", hashesOfAKnot() + hashesOfABite()); }

TEST(GoldenHash, OfAStripThatIsCutIsReachedByEveryCompilerAndBuild) {
  CutRig rig;
  std::string text;
  for (const char* when : {"touched", "cut", "deeper"}) {
    rig.saw(300, static_cast<int>(rig.state.step));
    addHash(when, rig.state, text);
  }
  EXPECT_GT(rig.cut().burnt, 0);
  expectGolden("strip", text);
}

INSTANTIATE_TEST_SUITE_P(GoldenHash, SolverHash, ::testing::Values("projective", "xpbd", "shape_matching"),
                         [](const auto& solver) { return std::string(solver.param); });

}  // namespace
}  // namespace halsted::app
