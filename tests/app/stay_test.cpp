/// The whole stay suture, by physics, from one script with the beginner's knot.
#include <algorithm>
#include <map>

#include "sim/outcome.h"
#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

/// What the stitch went through after its knot had locked.
struct AfterTheKnot {
  double widest = 0.0, slipped = 0.0, hardest = 0.0;             // [m] between the walls; [m] of thread through the knot; [N] at a hole
  void look(const State& s) {
    if (!s.assist->locked) return;
    widest = std::max(widest, s.metrics.seam->join.wallGap);
    slipped = s.assist->slipped;
    for (int i = 0; i < s.strand.holeCount; ++i) hardest = std::max(hardest, s.strand.holes[i].force.norm());
  }
};

TEST(SlowStay, IsTiedCutAndHeldByTheScriptWithoutAFaultOrATear) {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/stay/expert.toml", {"thread.assist=knot"});
  AfterTheKnot after;
  Lockstep run(scenario);
  while (run.advance()) after.look(run.state());
  EXPECT_EQ(run.failure(), "");
  const RunSummary summary = summariseRun("stay", "t", scenario.model, run.state(), run.stepTimes(), 1.0);
  EXPECT_TRUE(summary.completed);
  for (const ProcedureLine& line : summary.procedure) EXPECT_EQ(line.faults, 0) << line.id;
  std::map<std::string, double> m(summary.metrics.begin(), summary.metrics.end());   // by the name's unit
  EXPECT_EQ(m["bites"], 2.0);
  EXPECT_EQ(m["crossings"], 1.0);
  EXPECT_EQ(m["tears"], 0.0);
  EXPECT_EQ(m["assisted_knots"], 1.0);
  EXPECT_EQ(run.state().knot.cuts, 1);
  EXPECT_EQ(run.state().knot.breaks, 1);       // where it was cut, and nowhere else
  EXPECT_LT(m["tail_difference_m"], 12e-3);    // with the needle off: both long enough to hold
  EXPECT_LT(m["wall_gap_m"], 1.5e-3);          // the walls lie on each other where they are sewn
  EXPECT_EQ(after.slipped, 0.0);
  const Outcome outcome = testOutcome(scenario.model, run.state());
  std::printf("stay: %.1f s, tails %.1f mm apart in length, walls %.2f mm apart (%.2f at most since the knot), %.2f N at a hole, leaks at %.1f mmHg\n",
              run.time(), 1e3 * m["tail_difference_m"], 1e3 * m["wall_gap_m"], 1e3 * after.widest, after.hardest, outcome.leakPressure);
}

}  // namespace
}  // namespace halsted::app
