/// A sample that a hole has led through a wall is on the other side of it, and is not pushed back the way it came.
#include "sim/suture/hole_sides.h"

#include <gtest/gtest.h>

#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

/// Puts a hole on a vertex of the wall's outside (0) or inside (1), somewhere in the same bowel.  [1]
void putOnSide(const Model& m, double depth, Hole& h) {
  for (std::size_t t = 0; t < m.tissue.tets.size(); ++t)
    for (int c = 0; c < 4; ++c) {
      if (m.bowels.wallDepth[m.tissue.tets[t][c]] != depth) continue;
      h.tet = static_cast<std::int32_t>(t);
      h.weight = {};
      h.weight[c] = 1.0;
      return;
    }
}

double sideOf(const SewnEnds& ends, int node) { return ends.model.bowels.wallDepth[ends.state.strand.nearVertex[node]]; }   // [1]

TEST(HoleSides, ThreadThatAHoleLeadsIsOnTheSideOfThatHole) {
  SewnEnds ends({.stitches = 1});
  Hole& h = ends.state.strand.holes[0];
  const int led = threadSpot(ends.model.strand, h.coordinate).node, free = led - 4;
  const std::int32_t far = ends.state.strand.nearVertex[free];
  for (const double side : {1.0, 0.0, 1.0}) {  // into the lumen, out, and in again
    putOnSide(ends.model, side, h);
    rememberSides(ends.model, ends.state);
    EXPECT_EQ(onMucosa(ends.model, h), side > 0.5);
    EXPECT_EQ(sideOf(ends, led), side);
    EXPECT_EQ(ends.state.strand.nearVertex[free], far);
  }
}

/// Where the needle's tip is, no hole leads yet: the tip is within the wall.
TEST(HoleSides, ATipThatIsStillInTheWallLeadsNothing) {
  SewnEnds ends({.stitches = 1});
  StrandState& s = ends.state.strand;
  s.holeCount = 1;
  putOnSide(ends.model, 1.0, s.holes[0]);
  s.holes[0].role = static_cast<std::int32_t>(HoleRole::kTip);
  const std::vector<std::int32_t> before = s.nearVertex;
  rememberSides(ends.model, ends.state);
  EXPECT_EQ(s.nearVertex, before);
}

}  // namespace
}  // namespace halsted
