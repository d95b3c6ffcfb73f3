/// The whole stay suture, by physics, from one script with the beginner's knot.
#include "sim/outcome.h"
#include "tests/app/sewn_run.h"

namespace halsted::app {
namespace {

TEST(SlowStay, IsTiedCutAndHeldByTheScriptWithoutAFaultOrATear) {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/stay/expert.toml", {"thread.assist=knot"});
  double widest = 0.0, hardest = 0.0;          // [m] between the walls and [N] at a hole, since the knot locked
  Lockstep run(scenario);
  while (run.advance()) {
    const State& s = run.state();
    if (!s.assist->locked) continue;
    widest = std::max(widest, s.metrics.seam->join.wallGap);
    hardest = std::max(hardest, hardestHole(s));
  }
  auto m = expectTied(run, "stay");
  EXPECT_EQ(m["bites"], 2.0);
  EXPECT_LT(m["tail_difference_m"], 12e-3);    // with the needle off: both long enough to hold
  EXPECT_LT(m["wall_gap_m"], 1.5e-3);          // the walls lie on each other where they are sewn
  const Outcome outcome = testOutcome(scenario.model, run.state());
  std::printf("stay: %.1f s, tails %.1f mm apart in length, walls %.2f mm apart (%.2f at most since the knot), %.2f N at a hole, leaks at %.1f mmHg\n",
              run.time(), 1e3 * m["tail_difference_m"], 1e3 * m["wall_gap_m"], 1e3 * widest, hardest, outcome.leakPressure);
}

}  // namespace
}  // namespace halsted::app
