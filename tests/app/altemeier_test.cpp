/// The Altemeier procedure by physics, from one script with the beginner's knot: clamped, cut round both walls, carried away, instruments
/// changed, the two edges sewn to each other.
#include "app/session/session_writer.h"
#include "app/verifier.h"
#include "sim/outcome.h"
#include "sim/suture/holes.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/app/sewn_run.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::TemporaryFolder;

constexpr std::uint64_t kRecorded = 15000;     // steps that are replayed too: well into the outer wall

struct WorstCut {
  double outerAtInner = 0.0;                   // [1] share of the outer wall that was through when the inner one was first hurt
  double cutting = 0.0, sewing = 0.0;          // [N] on a hand
  double hole = 0.0, loop = 0.0;               // [N] at a hole and in a kept stitch
  void look(const State& s) {
    const CutMetrics& cut = *s.metrics.cut;
    if (cut.share[1] <= 0.0) outerAtInner = cut.share[0];
    double& hand = s.instruments->second[kRight] ? sewing : cutting;       // [N]
    for (const ToolState& t : s.tools) hand = std::max(hand, t.force.norm());
    hole = std::max(hole, hardestHole(s));
    for (int k = 0; k < s.stitches->count; ++k) loop = std::max(loop, s.stitches->stitch[k].tension);
  }
};

/// Between the two serosae at the loosest stitch, along its thread: second hole to third.  [m]
double widestStitch(const Model& m, const State& s) {
  const auto& x = s.tissue.position;
  double most = s.strand.holeCount == 4 ? (holePoint(m, s.strand.holes[2], x) - holePoint(m, s.strand.holes[1], x)).norm() : 1.0;   // [m]
  for (int k = 0; k < s.stitches->count; ++k) {
    const TiedStitch& t = s.stitches->stitch[k];
    most = std::max(most, t.holeCount == 4 ? (pointOf(m, t.hole[2], x) - pointOf(m, t.hole[1], x)).norm() : 1.0);
  }
  return most;
}

TEST(SlowAltemeier, TheSpecimenIsCutOffAndBothEdgesAreSewnToEachOtherByTheScriptWithoutAFault) {
  const TemporaryFolder folder;
  const std::string session = folder.file("a.halsted");
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/altemeier/expert.toml", {"thread.assist=knot"});
  WorstCut seen;
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
  EXPECT_TRUE(run.lostStitches().empty()) << run.lostStitches().front();
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
  EXPECT_EQ(m["stitches"], 4.0);
  EXPECT_EQ(m["threads_used"], 4.0);
  EXPECT_EQ(m["bites"], 8.0) << "one through each wall, four times";
  EXPECT_EQ(m["full_thickness_bites"], 8.0);
  EXPECT_EQ(m["tears"], 0.0);
  EXPECT_EQ(m["assisted_knots"], 4.0);
  EXPECT_GT(m["seam_sewn_share_1"], 0.7) << "all round but from the last stitch to the first";
  EXPECT_LT(widestStitch(scenario.model, s), 3e-3) << "wider is an air knot";
  EXPECT_LT(seen.loop, scenario.model.params.needle.tearForce);
  const Outcome outcome = testOutcome(scenario.model, s);
  EXPECT_TRUE(outcome.tested);
  EXPECT_EQ(outcome.end, LeakEnd::kOpen) << "between two of four stitches the walls stand apart";
  EXPECT_EQ(outcome.leakPressure, 0.0);        // [mmHg]
  EXPECT_GT(outcome.narrowing, -0.5);
  EXPECT_LT(outcome.narrowing, 0.5);
  for (const Vec3& p : s.tissue.position) EXPECT_TRUE(p.allFinite());
  for (int v : scenario.model.mesh.fixed) EXPECT_EQ(s.tissue.position[v], scenario.model.mesh.vertices[v]);
  const Scenario again = scenarioFromFile(session, {});
  Lockstep replay(again);
  Verifier verifier;
  while (replay.advance() && verifier.check(replay)) {}
  EXPECT_EQ(verifier.message(), "");
  EXPECT_EQ(verifier.stepsChecked(), kRecorded);
  std::printf("altemeier: %.1f s, %.0f J in %.1f s of current, off the line by %.2f mm in the mean and %.2f at worst, %.1f J where it should not be, %.1f N on a hand; "
              "sewn: walls %.2f mm apart at the loosest stitch, %.1f between two, %.1f N at a hole, %.2f N in a loop, %.1f N on a hand\n",
              run.time(), m["cut_energy_j"], m["cut_time_s"], 1e3 * m["cut_error_mean_m"], 1e3 * m["cut_error_worst_m"], m["cut_overshoot_j"], seen.cutting,
              1e3 * widestStitch(scenario.model, s), 1e3 * m["seam_wall_gap_m"], seen.hole, seen.loop, seen.sewing);
}

}  // namespace
}  // namespace halsted::app
