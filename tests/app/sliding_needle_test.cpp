/// A needle that does not go in where it should slides along the wall; the scripted surgeon sees it, takes it back before it gets to the edge and
/// presses it in at a slant the next time.
#include <algorithm>

#include "scenes/bite_plan.h"
#include "sim/strand/strand.h"
#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

Scenario lembertWith(const std::string& puncture) {
  return scenarioFromFile(testing::sourceFolder() + "/scenes/lembert/expert.toml", {"preset=friction", "needle.puncture_force=" + puncture});
}

/// A wall that no needle enters: the tip, from entry (0) to exit (1), and how high it is over the entry.
TEST(SlidingNeedle, IsTakenBackBeforeItGoesInElsewhere) {
  const Scenario scenario = lembertWith("20");
  const Model& model = scenario.model;
  scenes::BitePlan plan;
  const auto& actions = scenario.scripts[0].actions;
  const auto bite = std::find_if(actions.begin(), actions.end(), [](const auto& a) { return a.assist == ThreadAssist::kNone; });   // the first at this level
  ASSERT_TRUE(bite != actions.end() && scenes::planPlaces(model, *bite, plan));
  Lockstep run(scenario);
  double farthest = 0.0;                       // [1]
  bool touched = false, lifted = false;
  while (!(touched && lifted) && run.time() < 15.0 && run.advance()) {
    const State& s = run.state();
    const Vec3 entry = positionOf(model, s, plan.entry), way = positionOf(model, s, plan.exit) - entry;
    const Vec3 tip = strandPoint(model.strand, s.strand, tipCoordinate(model.strand)) - entry;
    const double height = tip.dot(normalOf(model, s, plan.entry));   // [m]
    touched = touched || height < 0.5e-3;
    lifted = touched && height > 10e-3;
    if (touched && !lifted) farthest = std::max(farthest, tip.dot(way) / way.squaredNorm());
  }
  EXPECT_TRUE(touched && lifted);
  EXPECT_GT(farthest, 0.5);                    // it did slide
  EXPECT_LT(farthest, 1.0);
  EXPECT_EQ(run.state().strand.bitesBegun, 0);
}

/// A wall a quarter tougher than that of the scene, in the middle of what bowel withstands (0.5 to 2 N).
TEST(SlidingNeedle, IsPressedInAtASlantTheNextTimeAndNotThroughTheWall) {
  const Scenario scenario = lembertWith("1.0");
  Lockstep run(scenario);
  const MetricsState& seen = run.state().metrics;
  while (seen.biteCount == 0 && run.time() < 20.0 && run.advance()) {}
  ASSERT_EQ(seen.biteCount, 1);
  EXPECT_GT(run.time(), 11.0);                 // it slid first: a bite that goes in at once is through in ten seconds
  EXPECT_GT(seen.bites[0].width, 5e-3);
  EXPECT_LT(seen.seam->wallShare[0], 0.8);
}

/// Edges wedged into each other shake from step to step: a hand that waits until it is where the wall is would wait for ever.
TEST(TremblingWall, DoesNotKeepTheNeedleFromIt) {
  constexpr double kTremble = 0.3e-3;          // [m] three times what a hand moves in a step
  const Scenario scenario = lembertWith("0.8");
  const Model& model = scenario.model;
  Lockstep run(scenario);
  while (run.state().strand.bitesBegun == 0 && run.time() < 15.0 && run.advance()) {
    State& s = run.state();
    const Vec3 by(0.0, s.step % 2 == 0 ? kTremble : -kTremble, 0.0);
    for (std::size_t v = 0; v < s.tissue.position.size(); ++v)
      if (model.bowels.of[v] == 0 && !model.tissue.isFixed[v]) s.tissue.position[v] += by;
  }
  EXPECT_EQ(run.state().strand.bitesBegun, 1);
}

}  // namespace
}  // namespace halsted::app
