/// The excision of a rectal prolapse by physics, from one script: clamped, cut round both walls, carried away.
#include "app/session/session_writer.h"
#include "app/verifier.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/app/sewn_run.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::TemporaryFolder;

constexpr std::uint64_t kRecorded = 15000;     // steps that are replayed too: well into the outer wall

struct Excision {
  double outerAtInner = 0.0;                   // [1] share of the outer wall that was through when the inner one was first hurt
  double hardest = 0.0;                        // [N] on a hand
  void look(const State& s) {
    const CutMetrics& cut = *s.metrics.cut;
    if (cut.share[1] <= 0.0) outerAtInner = cut.share[0];
    for (const ToolState& t : s.tools) hardest = std::max(hardest, t.force.norm());
  }
};

TEST(SlowAltemeier, TheSpecimenIsCutOffRoundBothWallsAndCarriedAwayByTheScriptWithoutAFault) {
  const TemporaryFolder folder;
  const std::string session = folder.file("a.halsted");
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/altemeier/expert.toml", {});
  Excision seen;
  Lockstep run(scenario);
  {
    SessionWriter writer(session, sessionHeader(scenario, ""));
    while (run.advance()) {
      if (run.state().step <= kRecorded) writer.addStep(run.input(), hash(run.state()));
      seen.look(run.state());
    }
    writer.close();
  }
  EXPECT_EQ(run.failure(), "");
  const State& s = run.state();
  const RunSummary summary = summariseRun("altemeier", "t", scenario.model, s, run.stepTimes(), 1.0);
  EXPECT_TRUE(summary.completed);
  for (const ProcedureLine& line : summary.procedure) EXPECT_EQ(line.faults, 0) << line.id;
  std::map<std::string, double> m(summary.metrics.begin(), summary.metrics.end());   // by the name's unit
  EXPECT_EQ(m["cut_share_outer_1"], 1.0);
  EXPECT_EQ(m["cut_share_inner_1"], 1.0);
  EXPECT_EQ(m["pieces_taken"], 1.0);
  EXPECT_EQ(seen.outerAtInner, 1.0) << "the outer wall first";
  EXPECT_LT(m["cut_error_mean_m"], 1.0e-3);
  for (const Vec3& p : s.tissue.position) EXPECT_TRUE(p.allFinite());
  for (int v : scenario.model.mesh.fixed) EXPECT_EQ(s.tissue.position[v], scenario.model.mesh.vertices[v]);
  const Scenario again = scenarioFromFile(session, {});
  Lockstep replay(again);
  Verifier verifier;
  while (replay.advance() && verifier.check(replay)) {}
  EXPECT_EQ(verifier.message(), "");
  EXPECT_EQ(verifier.stepsChecked(), kRecorded);
  std::printf("altemeier: %.1f s, %.0f J in %.1f s of current, off the line by %.2f mm in the mean and %.2f at worst, %.1f J where it should not be, %.1f N on a hand\n",
              run.time(), m["cut_energy_j"], m["cut_time_s"], 1e3 * m["cut_error_mean_m"], 1e3 * m["cut_error_worst_m"], m["cut_overshoot_j"], seen.hardest);
}

}  // namespace
}  // namespace halsted::app
