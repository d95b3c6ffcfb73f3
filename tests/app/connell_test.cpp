/// The whole Connell suture, by physics, from one script with the beginner's knot.
#include <algorithm>
#include <map>

#include "sim/outcome.h"
#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

double hardestHole(const State& s) {           // [N]
  double force = 0.0;                          // [N]
  for (int i = 0; i < s.strand.holeCount; ++i) force = std::max(force, s.strand.holes[i].force.norm());
  return force;
}

/// What the stitch bore while it was drawn and tied, and what slipped afterwards.
struct DrawnStitch {
  double hardest = 0.0, slipped = 0.0;         // [N] at a hole; [m] of thread through the knot
  void look(const State& s) {
    if (s.assist->placed) hardest = std::max(hardest, hardestHole(s));
    slipped = s.assist->slipped;
  }
};

TEST(SlowConnell, GoesThroughTheWholeWallMeetsAndIsTiedByTheScriptWithoutAFaultOrATear) {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/connell/expert.toml", {"thread.assist=knot"});
  DrawnStitch drawn;
  Lockstep run(scenario);
  while (run.advance()) drawn.look(run.state());
  EXPECT_EQ(run.failure(), "");
  const RunSummary summary = summariseRun("connell", "t", scenario.model, run.state(), run.stepTimes(), 1.0);
  EXPECT_TRUE(summary.completed);
  for (const ProcedureLine& line : summary.procedure) EXPECT_EQ(line.faults, 0) << line.id;
  std::map<std::string, double> m(summary.metrics.begin(), summary.metrics.end());   // by the name's unit
  EXPECT_EQ(m["bites"], 4.0);                  // outside in and inside out, on either side
  EXPECT_EQ(m["full_thickness_bites"], 4.0);
  EXPECT_EQ(m["crossings"], 1.0);
  EXPECT_EQ(m["tears"], 0.0);
  EXPECT_EQ(m["assisted_knots"], 1.0);
  EXPECT_EQ(run.state().knot.cuts, 1);
  EXPECT_EQ(run.state().knot.breaks, 1);       // where it was cut, and nowhere else
  EXPECT_LT(m["wall_gap_m"], 1.5e-3);          // nobody holds it any more: the knot does
  EXPECT_GT(m["inversion_deg"], 0.0);          // the edges are not turned out
  EXPECT_EQ(drawn.slipped, 0.0);
  const Outcome outcome = testOutcome(scenario.model, run.state());
  EXPECT_TRUE(outcome.tested);
  std::printf("connell: %.1f s, walls %.2f mm and edges %.2f mm apart, turned in by %.1f degrees, %.2f N at a hole as it was drawn, leaks at %.1f mmHg\n",
              run.time(), 1e3 * m["wall_gap_m"], 1e3 * m["rim_gap_m"], m["inversion_deg"], drawn.hardest, outcome.leakPressure);
}

}  // namespace
}  // namespace halsted::app
