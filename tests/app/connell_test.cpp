/// The whole Connell suture, by physics, from one script with the beginner's knot.
#include "sim/outcome.h"
#include "tests/app/sewn_run.h"

namespace halsted::app {
namespace {

TEST(SlowConnell, GoesThroughTheWholeWallMeetsAndIsTiedByTheScriptWithoutAFaultOrATear) {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/connell/expert.toml", {"thread.assist=knot"});
  double hardest = 0.0;                        // [N] at a hole as it was drawn and tied
  Lockstep run(scenario);
  while (run.advance())
    if (run.state().assist->placed) hardest = std::max(hardest, hardestHole(run.state()));
  auto m = expectTied(run, "connell");
  EXPECT_EQ(m["bites"], 4.0);                  // outside in and inside out, on either side
  EXPECT_EQ(m["full_thickness_bites"], 4.0);
  EXPECT_LT(m["wall_gap_m"], 1.5e-3);          // nobody holds it any more: the knot does
  EXPECT_GT(m["inversion_deg"], 0.0);          // the edges are not turned out
  const Outcome outcome = testOutcome(scenario.model, run.state());
  EXPECT_TRUE(outcome.tested);
  std::printf("connell: %.1f s, walls %.2f mm and edges %.2f mm apart, turned in by %.1f degrees, %.2f N at a hole as it was drawn, leaks at %.1f mmHg\n",
              run.time(), 1e3 * m["wall_gap_m"], 1e3 * m["rim_gap_m"], m["inversion_deg"], hardest, outcome.leakPressure);
}

}  // namespace
}  // namespace halsted::app
