/// The acupuncture scene from script to recording and back, by the same loop and the same session files as every other scene.
#include <gtest/gtest.h>

#include <map>

#include "app/lockstep.h"
#include "app/run_summary.h"
#include "app/session/session_writer.h"
#include "app/verifier.h"
#include "scenes/mesh_path.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/support/process.h"
#include "tests/support/source_folder.h"

namespace halsted::app {
namespace {

Scenario acupuncture(const std::vector<std::string>& overrides = {}) {
  return scenarioFromFile(halsted::testing::sourceFolder() + "/scenes/acupuncture/expert.toml", overrides);
}

RunSummary expectCompleted(const std::vector<std::string>& overrides) {
  return expectCompleted(acupuncture(overrides), "acupuncture", [](const Lockstep&) {});
}

std::map<std::string, double> metricsOf(const RunSummary& run) { return {run.metrics.begin(), run.metrics.end()}; }   // by the name's unit

TEST(Acupuncture, ScriptCompletesOnTheSlabAtThePointsAngleAndDepth) {
  auto m = metricsOf(expectCompleted({}));     // by the name's unit
  EXPECT_NEAR(m["insertion_angle_deg"], 90.0, 2.0);
  EXPECT_NEAR(m["depth_error_m"], 0.0, 1e-3);
  EXPECT_LT(m["entry_offset_m"], 1e-3);
  EXPECT_GT(m["peak_grasp_1"], 1.3);
  EXPECT_NEAR(m["twirl_amplitude_mean_deg"], 150.0, 10.0);
  EXPECT_LT(m["peak_force_right_n"], 3.3);
}

TEST(Acupuncture, ScriptCompletesObliquely) {
  auto m = metricsOf(expectCompleted({"anatomy.point=P45"}));   // by the name's unit
  EXPECT_NEAR(m["insertion_angle_deg"], 45.0, 5.0);
  EXPECT_NEAR(m["depth_error_m"], 0.0, 1.5e-3);
}

TEST(Acupuncture, ScriptCompletesOnRealBodies) {
  if (scenes::dataFolder().empty()) GTEST_SKIP() << "HALSTED_DATA is not set";
  expectCompleted({"anatomy.body=torso"});
  expectCompleted({"anatomy.mesh=" + scenes::dataFolder() + "/skin/patient-00020-torso.vtk", "anatomy.scale=0.66e-3", "anatomy.body=", "anatomy.point=CV6"});
  expectCompleted({"anatomy.body=leg"});
}

TEST(Acupuncture, WrongAngleAndDepthAreFaults) {
  const halsted::testing::TemporaryFolder folder;
  const std::string path = folder.file("wrong.toml");
  halsted::testing::writeText(path, "scene = \"acupuncture\"\n[[action]]\ndo = \"find\"\n[[action]]\ndo = \"press\"\n[[action]]\ndo = \"find\"\nangle_deg = 60\n"
                                    "[[action]]\ndo = \"insert\"\nangle_deg = 60\n[[action]]\ndo = \"insert\"\nangle_deg = 60\ndepth_mm = 27\n");
  const Scenario scenario = scenarioFromFile(path, {});
  Lockstep run(scenario);
  while (run.advance()) {}
  const RunSummary summary = summariseRun("acupuncture", "t", scenario.model, run.state(), run.stepTimes(), 1.0);
  std::map<std::string, int> faults;
  for (const ProcedureLine& line : summary.procedure) faults[line.id] = line.faults;
  EXPECT_GE(faults["pierce"], 1);              // 30 degrees off
  EXPECT_GE(faults["twirl"], 1);               // 7 mm too deep
  EXPECT_FALSE(summary.completed);
}

TEST(Acupuncture, ARecordingReplaysToTheBit) {
  const halsted::testing::TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  const Scenario scenario = acupuncture({"anatomy.point=P45", "anatomy.order=8"});
  {
    Lockstep run(scenario);
    SessionWriter recorder(path, sessionHeader(scenario, ""));
    for (int k = 0; k < 9000 && run.advance(); ++k) recorder.addStep(run.input(), hash(run.state()));
    EXPECT_GT(run.state().metrics.needling->deepest, 5e-3);   // the needle is in
    recorder.close();
  }
  const Scenario again = scenarioFromFile(path, {});
  EXPECT_EQ(again.anatomy.body.points[1].name, "oblique");
  Lockstep run(again);
  Verifier verifier;
  while (run.advance()) ASSERT_TRUE(verifier.check(run)) << verifier.message();
  EXPECT_EQ(verifier.stepsChecked(), 9000u);
}

}  // namespace
}  // namespace halsted::app
