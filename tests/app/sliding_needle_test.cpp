/// A needle that does not go in where it should slides along the wall; the scripted surgeon sees it and takes it back before it gets to the edge.
#include <algorithm>

#include "scenes/bite_plan.h"
#include "sim/strand/strand.h"
#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

/// A wall that no needle enters: the tip, from entry (0) to exit (1), and how high it is over the entry.
TEST(SlidingNeedle, IsTakenBackBeforeItGoesInElsewhere) {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/lembert/expert.toml", {"preset=friction", "needle.puncture_force=20"});
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

}  // namespace
}  // namespace halsted::app
