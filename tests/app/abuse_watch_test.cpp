/// What the watch over wild hands counts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/app/abuse_watch.h"
#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

/// Thread straight from outside a bowel into its lumen, square to the wall; no hole leads it.
struct Piercing {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/stay/expert.toml", {"thread.assist=knot"});
  Lockstep run{scenario};
  const Model& model = scenario.model;
  State& state = run.state();
  const Opening& end = model.bowels.opening[1];
  const double radius = (model.mesh.vertices[model.bowels.rim[1].front()] - end.centre).norm();   // [m]

  /// Nodes `segment` [m] apart: from six segments above the bowel's top, shifted by a `share` [1] of one, to 10 mm below it, where the rest lie in a heap.
  int through(double segment, double share) {
    for (int i = 0; i < model.strand.nodes; ++i)
      state.strand.position[i] = end.centre - 15e-3 * end.axis + (radius + std::fmax(-10e-3, (6 + share - i) * segment)) * end.up;
    return threadDepth(model, state).through;
  }
};

/// However its nodes lie to the faces: one segment may go in and out again, or several lie in the wall.
TEST(AbuseWatch, CountsThreadThroughAWallWhereverItsNodesLie) {
  Piercing thread;
  for (const double segment : {0.5e-3, 1.1e-3, 2.0e-3, 3.5e-3})  // [m] the wall is 2 mm thick
    for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8}) EXPECT_EQ(thread.through(segment, share), 1) << segment << " " << share;
}

/// Two walls may be pushed into each other, and the face that is nearest to thread deep in the one may be the other's: each is asked by itself. Asked
/// together, thread that lay through both was found in neither.
TEST(AbuseWatch, CountsThreadThroughWallsThatOverlap) {
  Piercing thread;
  const Opening &ours = thread.model.bowels.opening[1], &theirs = thread.model.bowels.opening[0];
  const double radius = thread.radius;         // [m]
  for (const double above : {0.7e-3, -0.7e-3}) {                 // [m] the other wall lies so far above the one that is pierced
    const State before = thread.state;
    const Vec3 to = ours.centre - 15e-3 * ours.axis + above * ours.up, from = theirs.centre - 15e-3 * theirs.axis;   // [m]
    for (std::size_t v = 0; v < thread.model.bowels.of.size(); ++v)
      if (thread.model.bowels.of[v] == 0) thread.state.tissue.position[v] += to - from;
    EXPECT_EQ(thread.through(2.0e-3, 0.4), 2) << above;
    for (std::size_t v = 0; v < thread.model.bowels.of.size(); ++v)
      if (thread.model.bowels.of[v] == 0) thread.state.tissue.position[v] += 4.0 * radius * ours.right;   // beside it
    EXPECT_EQ(thread.through(2.0e-3, 0.4), 1) << above;
    thread.state = before;
  }
}

/// Its pieces may lie anywhere: what joins them in the list of nodes is not thread.
TEST(AbuseWatch, CountsNothingWhereThreadIsBroken) {
  Piercing thread;
  std::vector<std::uint8_t>& cut = thread.state.threadContacts.cut;
  ASSERT_EQ(cut.size() + 1, thread.state.strand.position.size());
  cut.back() = 1;
  EXPECT_EQ(thread.through(3.5e-3, 0.4), 1);   // broken elsewhere
  std::fill(cut.begin(), cut.end(), std::uint8_t{1});
  EXPECT_EQ(thread.through(3.5e-3, 0.4), 0);
}

}  // namespace
}  // namespace halsted::app
