/// The nearest point of a thin wall with wide triangles, where the far side's vertices are nearer than those of the face that a point lies on.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/contact/geometry.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

constexpr double kReach = 8e-3;                // [m]

struct NearestOnThinWall : ::testing::Test {
  const TetMesh mesh = wallMesh();
  const SurfaceModel surface = buildSurface(mesh);
  std::vector<Vec3> position = mesh.vertices;    // [m]
  std::mt19937_64 random{11};

  /// Half as thick as its triangles are wide, those of the far side shifted by half their width.
  NearestOnThinWall() {
    for (Vec3& x : position) {
      if (x.x() > 0.75 * kWallX) x += Vec3(0.0, 1e-3, 1e-3);
      x.x() *= 0.25;
    }
  }
  double within(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  int faceVertexNear(const Vec3& p) {          // of the face at x = 0, no farther than thread goes in a few steps
    int v = 0;
    do v = surface.vertices[random() % surface.vertices.size()];
    while (mesh.vertices[v].x() > 1e-9 || (position[v] - p).norm() > 4e-3);
    return v;
  }
  double lookAtEach(const Vec3& p) const {     // [m] unsigned
    double least = 1e300;
    for (const auto& t : surface.triangles) {
      const Vec3 &a = position[t[0]], &b = position[t[1]], &c = position[t[2]];
      least = std::min(least, (p - mix(closestOnTriangle(p, a, b, c), a, b, c)).norm());
    }
    return least;
  }
};

TEST_F(NearestOnThinWall, APointAtAFaceIsFoundAtThatFaceFromItsVertices) {
  const SurfaceNow now(position);
  int farVertexNearer = 0;
  for (int k = 0; k < 2000; ++k) {
    const double z = within(2e-3, kWallZ - 2e-3), y = within(2e-3, kWallY - 2e-3), x = within(-0.4e-3, 0.3e-3);   // [m]
    const Vec3 p(x, y, z);
    farVertexNearer += mesh.vertices[nearestVertex(surface, now, p)].x() > 1e-9;
    int vertex = faceVertexNear(p);
    const SurfacePoint found = nearestSurface(surface, now, p, 1.0, vertex);
    ASSERT_NEAR(found.distance, -p.x(), 1e-12) << k;
    ASSERT_NEAR((found.normal + Vec3::UnitX()).norm(), 0.0, 1e-6) << k;
    ASSERT_LT(mesh.vertices[vertex].x(), 1e-9) << k;
  }
  EXPECT_GT(farVertexNearer, 100);             // else the wall is not thin enough to tell
}

TEST_F(NearestOnThinWall, TheNearestTriangleIsThatOfALookAtEach) {
  for (Vec3& x : position) x.y() += within(-1e-3, 1e-3);
  const SurfaceNow now(position);
  for (int k = 0; k < 2000; ++k) {
    const double z = within(-3e-3, kWallZ + 3e-3), y = within(-3e-3, kWallY + 3e-3), x = within(-5e-3, 5e-3);   // [m]
    const Vec3 p(x, y, z);
    int vertex = surface.vertices[random() % surface.vertices.size()];
    const SurfacePoint found = nearestTriangle(surface, now, p, vertex);
    ASSERT_NEAR(std::fabs(found.distance), lookAtEach(p), 1e-12) << k;
    const auto& corners = surface.triangles[found.triangle];
    ASSERT_TRUE(std::find(corners.begin(), corners.end(), vertex) != corners.end()) << k;
  }
}

/// Farther than the reach from the nearest vertex nothing is examined.
TEST_F(NearestOnThinWall, NothingIsFoundOutOfReach) {
  const SurfaceNow now(position);
  const Vec3 p(-2.0 * kReach, 0.5 * kWallY, 0.5 * kWallZ);
  int vertex = surface.vertices.front();
  EXPECT_LT(nearestSurface(surface, now, p, kReach, vertex).triangle, 0);
}

}  // namespace
}  // namespace halsted
