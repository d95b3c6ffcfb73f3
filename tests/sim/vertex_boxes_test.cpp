/// The search that passes over boxes finds the vertex that a look at each finds.
#include "sim/contact/vertex_boxes.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

struct SearchOfBoxes : ::testing::Test {
  const TetMesh mesh = wallMesh();
  const SurfaceModel surface = buildSurface(mesh);
  std::vector<Vec3> position = mesh.vertices;    // [m]
  VertexBoxes boxes;
  std::mt19937_64 random{7};

  SearchOfBoxes() {
    const std::size_t size = (surface.vertices.size() + VertexBoxes::kVertices - 1) / VertexBoxes::kVertices;
    for (auto* corner : {&boxes.low, &boxes.high}) corner->assign(size, Vec3::Zero());
  }
  double within(double most) { return std::uniform_real_distribution<double>(-most, most)(random); }
  int anyVertex() { return surface.vertices[random() % surface.vertices.size()]; }
  int found(const SurfaceNow& now, const Vec3& p) { return nearestVertex(surface, now, boxes, p, anyVertex()); }   // [m]
};

TEST_F(SearchOfBoxes, FindsWhatALookAtEachFinds) {
  for (Vec3& x : position) x += Vec3(within(1e-3), within(1e-3), within(1e-3));
  const SurfaceNow now(position);
  fillBoxes(surface, now, boxes);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = position[random() % position.size()] + Vec3(within(5e-3), within(5e-3), within(5e-3));
    ASSERT_EQ(found(now, p), nearestVertex(surface, now, p)) << k;
  }
}

/// Half-way between two of a grid, and in the middle of four, the first counts, wherever the search begins.
TEST_F(SearchOfBoxes, TakesTheFirstOfThoseThatAreEquallyNear) {
  const SurfaceNow now(position);
  fillBoxes(surface, now, boxes);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p = 0.5 * (position[anyVertex()] + position[anyVertex()]);
    ASSERT_EQ(found(now, p), nearestVertex(surface, now, p)) << k;
  }
}

}  // namespace
}  // namespace halsted
