/// The colon that needs no data file.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "scenes/procedural_colon.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

TEST(ProceduralColon, HasThePublishedNumberOfParticles) {
  const TetMesh mesh = scenes::proceduralColon({});
  EXPECT_NEAR(static_cast<double>(mesh.vertices.size()), 1228.0, 0.02 * 1228.0);
  EXPECT_EQ(mesh.tets.size(), 34u * 17u * 6u);
}

TEST(ProceduralColon, IsAWholeWall) { testing::expectWholeWall(scenes::proceduralColon({})); }

TEST(ProceduralColon, HasWellShapedTets) { EXPECT_GT(testing::worstQuality(scenes::proceduralColon({})), 0.3); }

TEST(ProceduralColon, IsTwoMillimetresThickEverywhere) {
  const TetMesh mesh = scenes::proceduralColon({});
  EXPECT_GT(testing::leastDistanceToOuterLayer(mesh), 1.8e-3);
  EXPECT_LT(testing::largestDistanceToOuterLayer(mesh), 2.05e-3);
}

TEST(ProceduralColon, IsRoundAtTheRimAndSacculatedBelow) {
  const AnatomyParams params;
  const TetMesh mesh = scenes::proceduralColon(params);
  for (int vertex : mesh.rim) EXPECT_NEAR(mesh.vertices[vertex].norm(), params.radius, 1e-9);
  double least = 1.0, most = 0.0;  // [m]
  for (std::size_t v = 0; v < mesh.vertices.size(); v += 2) {
    const double r = mesh.vertices[v].head<2>().norm();  // [m]
    least = std::min(least, r);
    most = std::max(most, r);
  }
  EXPECT_GT(most - params.radius, 0.8 * params.haustraDepth);
  EXPECT_GT(params.radius - least, 0.3 * params.haustraDepth);
}

TEST(ProceduralColon, FollowsItsParameters) {
  AnatomyParams params;
  params.radius = 25e-3;
  params.length = 80e-3;
  params.wall = 3e-3;
  params.around = 48;
  params.along = 24;
  const TetMesh mesh = scenes::proceduralColon(params);
  testing::expectWholeWall(mesh);
  EXPECT_EQ(mesh.vertices.size(), 2u * 48u * 24u);
  EXPECT_NEAR(mesh.uv.back().y(), 80e-3, 1e-12);
}

TEST(ProceduralColon, GivesTheSameBytesTwice) {
  EXPECT_EQ(testing::bitsOf(scenes::proceduralColon({})), testing::bitsOf(scenes::proceduralColon({})));
}

/// Any change of shape, compiler or processor that moves one bit of the default anatomy shows here.
TEST(ProceduralColon, GivesTheSameBitsOnEveryMachine) {
  EXPECT_EQ(testing::bitsOf(scenes::proceduralColon({})), 0xcfcbdbd648482230ULL);
}

}  // namespace
}  // namespace halsted
