/// Interrupted Lembert stitches by physics, from one script with the beginner's knot.
#include <algorithm>
#include <map>

#include "sim/outcome.h"
#include "sim/whole_seam.h"
#include "tests/app/sewn_run.h"

namespace halsted::app {
namespace {

using halsted::testing::TemporaryFolder;

struct Worst {
  double hole = 0.0, loop = 0.0;               // [N] at a hole and in a kept stitch, since the knot of the thread in use
  double moved = 0.0;                          // [m] of any tissue in the step in which a thread is handed
  std::vector<Vec3> before;
  void look(const State& s, const StepInput& input) {
    if (input.command.kind == Command::Kind::kFreshThread)
      for (std::size_t v = 0; v < before.size(); ++v) moved = std::max(moved, (s.tissue.position[v] - before[v]).norm());
    before = s.tissue.position;
    if (s.assist->locked)
      for (int i = 0; i < s.strand.holeCount; ++i) hole = std::max(hole, s.strand.holes[i].force.norm());
    for (int k = 0; k < s.stitches->count; ++k) loop = std::max(loop, s.stitches->stitch[k].tension);
  }
};

/// Two of the script's stitches, neighbours: all that ten are made of.
TEST(SlowLembert, StitchesAreBittenTiedCutAndFollowedByTheNextWithoutAFaultOrATear) {
  const TemporaryFolder folder;
  const Scenario scenario = scenarioFromFile(scriptAt(folder, "lembert", "0, 16"), {"thread.assist=knot"});
  Worst worst;
  Lockstep run(scenario);
  while (run.advance()) worst.look(run.state(), run.input());
  EXPECT_EQ(run.failure(), "");
  EXPECT_TRUE(run.lostStitches().empty()) << run.lostStitches().front();
  const State& s = run.state();
  const RunSummary summary = summariseRun("lembert", "t", scenario.model, s, run.stepTimes(), 1.0);
  for (const ProcedureLine& line : summary.procedure) EXPECT_EQ(line.faults, 0) << line.id;
  std::map<std::string, double> m(summary.metrics.begin(), summary.metrics.end());   // by the name's unit
  EXPECT_FALSE(summary.completed);             // two of ten
  EXPECT_EQ(s.procedure.current, 0);
  EXPECT_EQ(m["stitches"], 2.0);
  EXPECT_EQ(m["bites"], 4.0);
  EXPECT_EQ(m["full_thickness_bites"], 0.0);
  EXPECT_EQ(m["tears"], 0.0);
  EXPECT_EQ(m["assisted_knots"], 2.0);
  EXPECT_GT(m["stitch_spacing_min_m"], 4e-3);
  EXPECT_LT(m["stitch_spacing_max_m"], 7e-3);
  EXPECT_LT(m["seam_wall_gap_m"], 1.5e-3);     // between the two, with nobody holding them
  EXPECT_GT(m["seam_inversion_deg"], 0.0);
  EXPECT_LT(worst.hole, scenario.model.params.needle.tearForce);
  EXPECT_LT(worst.moved, 0.1e-3);              // the stitch goes on with its pull: tissue feels next to nothing of the act
  const Outcome outcome = testOutcome(scenario.model, s);
  EXPECT_TRUE(outcome.tested);
  std::printf("lembert: %.1f s, spacing %.1f mm, walls %.2f mm apart, turned in by %.1f degrees, %.2f N at a hole, %.2f N in a loop, handing moves %.3f mm, leaks at %.1f mmHg\n",
              run.time(), 1e3 * m["stitch_spacing_mean_m"], 1e3 * m["seam_wall_gap_m"], m["seam_inversion_deg"], worst.hole, worst.loop, 1e3 * worst.moved, outcome.leakPressure);
}

}  // namespace
}  // namespace halsted::app
