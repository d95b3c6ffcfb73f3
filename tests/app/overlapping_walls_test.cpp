/// Thread between walls that have been pushed into each other (sim/suture/pierced_wall.h).
#include <gtest/gtest.h>

#include "sim/suture/pierced_wall.h"
#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

/// One segment of thread square through the wall of one of two bowels, no hole on its way, the needle's hand behind it; the other's wall where it is put.
struct Overlap {
  static constexpr int kNode = 60, kPierced = 1;
  static constexpr double kOut = 0.9e-3, kThick = 2e-3;          // [m] of a node from its face; of the wall
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/stay/expert.toml", {"thread.assist=knot"});
  Lockstep run{scenario};
  const Model& model = scenario.model;
  State& state = run.state();

  SurfacePoint facing(const Vec3& p, int& vertex) const { return nearestTriangle(model.surface, state.tissue.position, p, vertex, model.bowels.of); }   // [m]
  /// Of a bowel, behind its opening.
  SurfacePoint topOf(int bowel, int& vertex) const {
    const Opening& end = model.bowels.opening[bowel];
    vertex = model.bowels.rim[bowel].front();
    return facing(end.centre - 15e-3 * end.axis + 60e-3 * end.up, vertex);
  }
  /// Does the node on the side of the tail follow the face of the next, with the other wall so far above the one that is pierced?
  bool comesThrough(double above) {            // [m]
    int vertex = -1, other = -1;
    const SurfacePoint top = topOf(kPierced, vertex), theirs = topOf(1 - kPierced, other);
    for (std::size_t v = 0; v < model.bowels.of.size(); ++v)
      if (model.bowels.of[v] != kPierced) state.tissue.position[v] += top.point - theirs.point + above * top.normal;
    auto& x = state.strand.position;
    auto& near = state.strand.nearVertex;
    x[kNode - 1] = top.point + kOut * top.normal;
    x[kNode] = top.point - (kThick + kOut) * top.normal;
    near[kNode - 1] = near[kNode] = vertex;
    const SurfacePoint before = facing(x[kNode - 1], near[kNode - 1]), now = facing(x[kNode], near[kNode]);
    EXPECT_NE(near[kNode - 1], near[kNode]);
    drawBack(model, kNode, before, now, state);
    return near[kNode - 1] == near[kNode];
  }
};

/// Asked which face is nearest of all, thread in one wall beside a face of another was taken for thread that goes through none, and stayed in it.
TEST(OverlappingWalls, ThreadThroughOneOfThemIsFound) {
  for (const double above : {40e-3, 1e-3, -1e-3}) EXPECT_TRUE(Overlap().comesThrough(above)) << above;   // [m] the first does not overlap
}

}  // namespace
}  // namespace halsted::app
