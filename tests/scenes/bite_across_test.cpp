/// Bites through both cut edges of a prolapse: behind what the cut has left of each, from mucosa to mucosa.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/bite_plan.h"
#include "scenes/prolapse.h"
#include "sim/cutting/edge.h"
#include "sim/cutting/pieces.h"
#include "sim/measure.h"
#include "sim/portable_math.h"
#include "sim/step.h"
#include "tests/scenes/prolapse_params.h"

namespace halsted::scenes {
namespace {

class BitesAcross : public ::testing::Test {
 protected:
  const Model model = buildModel(penAndProlapse(), prolapse(prolapsed()), {});
  State state = initialState(model, startPoses(model));
  const AnatomyParams& anatomy = model.params.anatomy;
  ExpertAction bite;

  BitesAcross() {
    bite.across = true;
    bite.angleDegrees = 40.0;
    bite.depth = 4e-3;
  }
  /// Burns all of a wall within `back` of the line and beyond it.  [m]
  void burn(int wall, double back, int firstBin, int lastBin) {
    for (std::size_t t = 0; t < model.mesh.cutLine.size(); ++t) {
      const CutMark& mark = model.mesh.cutLine[t];
      if (mark.wall == wall && mark.bin >= firstBin && mark.bin <= lastBin && mark.fromLine > -back - 1e-9 && mark.fromLine < 1e-9) state.tissue.gone[t] = 1;
    }
    findPieces(model, state);
  }
  double depthOf(const TissuePlace& place) const {   // [m] behind the rim, at rest
    const Opening& o = model.bowels.opening[0];
    return -(pointOn(model.surface, model.mesh.vertices, place.triangle, place.weight) - o.centre).dot(o.axis);
  }
};

TEST_F(BitesAcross, EdgesAreTheRimsUntilTissueGoes) {
  for (const int wall : {0, 1}) {
    const std::span<const int> edge = edgeOf(model, state, wall);
    ASSERT_EQ(edge.size(), model.bowels.rim[wall].size());
    for (std::size_t i = 0; i < edge.size(); ++i) EXPECT_EQ(edge[i], model.bowels.rim[wall][i]);
  }
}

/// Where the row on the line has gone the rim is the edge; where two more have gone toward the base it lies two rows behind.
TEST_F(BitesAcross, EdgesMoveBackToTheFirstRowThatIsWhole) {
  burn(0, 0.0, 0, anatomy.around - 1);
  for (std::size_t i = 0; i < model.bowels.rim[0].size(); ++i) EXPECT_EQ(edgeOf(model, state, 0)[i], model.bowels.rim[0][i]);
  burn(0, 2e-3, 4, 4);                         // between columns 4 and 5
  for (int i = 0; i < anatomy.around; ++i) {
    const int edge = edgeOf(model, state, 0)[i], rim = model.bowels.rim[0][i];
    EXPECT_NEAR(model.mesh.uv[edge].y() - model.mesh.uv[rim].y(), i == 4 || i == 5 ? 2e-3 : 0.0, 1e-9) << i;
    EXPECT_EQ(model.mesh.uv[edge].x(), model.mesh.uv[rim].x());
    EXPECT_EQ(edgeOf(model, state, 1)[i], model.bowels.rim[1][i]) << "the other wall is whole";
  }
}

TEST_F(BitesAcross, GoFromMucosaToMucosaBehindBothEdges) {
  burn(0, 2e-3, 3, 5);
  burn(1, 1e-3, 3, 5);
  BitePlan whole, cut;
  ASSERT_TRUE(planPlaces(model, bite, whole));
  ASSERT_TRUE(planPlaces(model, bite, cut, &state));
  EXPECT_NEAR(depthOf(whole.entry), bite.depth, 1e-9);
  EXPECT_NEAR(depthOf(cut.entry), bite.depth + 2e-3, 1e-9);
  EXPECT_NEAR(depthOf(cut.exit), bite.depth + 1e-3, 1e-9);
  for (const TissuePlace* place : {&cut.entry, &cut.exit}) EXPECT_EQ(model.mesh.triangleLayer[place->triangle], kMucosa);
  const Vec3 in = positionOf(model, state, cut.entry), out = positionOf(model, state, cut.exit);
  EXPECT_NEAR(in.head<2>().norm(), anatomy.radius, 0.01 * anatomy.radius);
  EXPECT_NEAR(out.head<2>().norm(), anatomy.radius - 2.0 * anatomy.wall - anatomy.gap, 0.01 * anatomy.radius);
}

/// Entry on the outer wall's mucosa; exit beside it on the mucosa again, or through the wall on the serosa.
TEST_F(BitesAcross, ABiteThatComesOutWhereItWentInIsPartial) {
  const auto hole = [&](double angle, int layer, HoleRole role) {   // [deg]
    const TissuePlace place = placeOnWall(model, {0, angle, 4e-3, layer});
    Hole h;
    h.tet = model.surface.triangleTet[place.triangle];
    for (int c = 0; c < 4; ++c)
      for (int k = 0; k < 3; ++k)
        if (model.tissue.tets[h.tet][c] == model.surface.triangles[place.triangle][k]) h.weight[c] = place.weight[k];
    h.role = static_cast<std::int32_t>(role);
    h.bite = 0;
    return h;
  };
  StepOutput out;
  state.strand.holeCount = 2;
  state.strand.holes[0] = hole(40.0, kMucosa, HoleRole::kEntry);
  state.strand.holes[1] = hole(50.0, kMucosa, HoleRole::kPassed);
  measure(model, {}, state, out);
  EXPECT_EQ(out.seen[static_cast<int>(Quantity::kPartialThickness)], 1.0);
  state.strand.holes[1] = hole(40.0, kSerosa, HoleRole::kPassed);
  measure(model, {}, state, out);
  EXPECT_EQ(out.seen[static_cast<int>(Quantity::kPartialThickness)], 0.0);
}

/// The needle dips below the places and comes up again: it passes under both edges.
TEST_F(BitesAcross, SwingUnderTheEdges) {
  BitePlan plan;
  ASSERT_TRUE(planPlaces(model, bite, plan, &state));
  planCircle(model, state, bite, 0.0, plan);
  EXPECT_GT(plan.out.z(), 0.9);
  EXPECT_LT(plan.entryAngle, 0.0);
  const Vec3 deepest = plan.centre - model.strand.needle.radius * plan.out;    // [m]
  EXPECT_LT(deepest.z(), positionOf(model, state, plan.entry).z());
}

}  // namespace
}  // namespace halsted::scenes
