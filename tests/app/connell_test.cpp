/// The whole Connell suture, by physics, from one script: with the beginner's knot, and with a knot that nothing but friction holds.
#include "sim/outcome.h"
#include "sim/strand/knot_diagram.h"
#include "sim/strand/strand.h"
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

TEST(SlowConnellFriction, IsTiedByThreadOnThreadAloneWhichHoldsTheWallsWhenTheHandsHaveLetGo) {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/connell/expert.toml", {"preset=friction"});
  Lockstep run(scenario);
  while (run.advance()) {}
  auto m = expectSewn(run, "connell");
  EXPECT_FALSE(run.state().assist);
  EXPECT_EQ(m.count("assisted_knots"), 0u);
  EXPECT_EQ(m["full_thickness_bites"], 4.0);
  EXPECT_LT(m["wall_gap_m"], 1.5e-3);
  EXPECT_EQ(run.state().threadContacts.dropped, 0) << "thread has passed through thread";
  for (int hand = 0; hand < kHands; ++hand) EXPECT_LT(run.state().tools[hand].threadCoordinate, 0.0) << "nobody holds it";
  const StrandState& s = run.state().strand;
  const double left = strandTension(scenario.model.strand, s, 0.5 * (s.holes[0].coordinate + s.holes[s.holeCount - 1].coordinate), 1);   // [N]
  std::printf("connell by friction: %.1f s, read as %s, walls %.2f mm apart, %.2f N in the stitch, at most %.2f N in the thread\n", run.time(),
              knotName(readKnot(s.position)).c_str(), 1e3 * m["wall_gap_m"], left, m["peak_tension_n"]);
}

}  // namespace
}  // namespace halsted::app
