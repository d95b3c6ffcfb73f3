/// The way out over the edge of a wall of 4 mm, against the distances that one reads off it.
#include "sim/suture/edge_exit.h"

#include <gtest/gtest.h>

#include "tests/sim/wall_faces.h"

namespace halsted {
namespace {

struct EdgeExit : ::testing::Test {
  const TetMesh mesh = wallMesh();
  const SurfaceModel surface = buildSurface(mesh);
  const SurfaceNow now{mesh.vertices, {}};
  const std::vector<int> layer = wallFaces(mesh, surface);
  int vertex = 0;

  /// A point of thread that goes straight through the wall, so far from its face and below its top edge.  [m]
  PressedIn through(double fromFace, double below) {
    const Vec3 p(fromFace, 0.5 * kWallY + 0.3e-3, kWallZ - below);
    vertex = nearestVertex(surface, now, p);
    return {p, Vec3::UnitX(), nearestSurface(surface, now, p, 8e-3, vertex), vertex};
  }
};

TEST_F(EdgeExit, LeadsOverTheEdgeThoughAFaceIsNearer) {
  const PressedIn in = through(1.0e-3, 1.7e-3);
  ASSERT_EQ(layer[in.nearest.triangle], 0);
  for (const SurfacePoint& out : {exitOverEdge(surface, layer, now, in, 3e-3), exitAcross(surface, now, in, 3e-3)}) {
    ASSERT_GE(out.triangle, 0);
    EXPECT_EQ(layer[out.triangle], kEdgeFace);
    EXPECT_NEAR(out.distance, -1.7e-3, 1e-12);
    EXPECT_NEAR((out.normal - Vec3::UnitZ()).norm(), 0.0, 1e-12);
    EXPECT_NEAR((out.point - in.point - 1.7e-3 * Vec3::UnitZ()).norm(), 0.0, 1e-12);
  }
}

TEST_F(EdgeExit, IsNoneTooFarBelowIt) {
  const PressedIn in = through(1.0e-3, 1.7e-3);
  EXPECT_LT(exitOverEdge(surface, layer, now, in, 1.6e-3).triangle, 0);
  EXPECT_EQ(exitAcross(surface, now, in, 1.6e-3).triangle, in.nearest.triangle);
}

/// Thread that lies along the face leaves by it; over the edge it still finds its way if it must.
TEST_F(EdgeExit, OfThreadAlongTheFaceIsTheFace) {
  PressedIn in = through(1.0e-3, 1.7e-3);
  in.along = Vec3::UnitY();
  EXPECT_EQ(exitAcross(surface, now, in, 3e-3).triangle, in.nearest.triangle);
  EXPECT_EQ(layer[exitOverEdge(surface, layer, now, in, 3e-3).triangle], kEdgeFace);
}

}  // namespace
}  // namespace halsted
