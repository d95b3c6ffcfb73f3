/// Tetrahedral meshes as arrays.
#include "sim/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace halsted {
namespace {

TEST(BlockMesh, FillsItsBoxWithPositiveTets) {
  const TetMesh mesh = blockMesh(3, 4, 5, Vec3(0.3, 0.2, 0.1));
  EXPECT_EQ(mesh.vertices.size(), 4u * 5u * 6u);
  EXPECT_EQ(mesh.tets.size(), 3u * 4u * 5u * 6u);
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) EXPECT_NEAR(volume(mesh, t), 0.3 * 0.2 * 0.1 / 360.0, 1e-12);
  EXPECT_NEAR(volume(mesh), 0.3 * 0.2 * 0.1, 1e-12);
}

TEST(BlockMesh, HasTwoTrianglesPerBoundarySquare) {
  EXPECT_EQ(blockMesh(3, 4, 5, Vec3::Ones()).surface.size(), 2u * 2u * (3u * 4u + 4u * 5u + 5u * 3u));
}

TEST(BlockMesh, RefusesAnEmptyBlock) {
  EXPECT_THROW(blockMesh(0, 1, 1, Vec3::Ones()), std::invalid_argument);
  EXPECT_THROW(blockMesh(1, 1, 1, Vec3(1, 0, 1)), std::invalid_argument);
}

TEST(BoundaryTriangles, PointOutward) {
  const TetMesh mesh = blockMesh(2, 2, 2, Vec3::Ones());
  const Vec3 middle = Vec3::Constant(0.5);
  for (const auto& [a, b, c] : mesh.surface) {
    const Vec3 normal = (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
    EXPECT_GT(normal.dot(mesh.vertices[a] - middle), 0.0);
  }
}

TEST(FaceNeighbours, AreMutualAndLieAcrossTheFace) {
  const TetMesh mesh = blockMesh(3, 2, 2, Vec3::Ones());
  const auto neighbours = faceNeighbours(mesh.tets);
  int open = 0;
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
    for (int f = 0; f < 4; ++f) {
      const int other = neighbours[t][f];
      if (other < 0) {
        ++open;
        continue;
      }
      int shared = 0;
      for (int a : mesh.tets[t])
        for (int b : mesh.tets[other]) shared += a == b;
      EXPECT_EQ(shared, 3);
      EXPECT_EQ(std::count(neighbours[other].begin(), neighbours[other].end(), t), 1);
    }
  }
  EXPECT_EQ(open, static_cast<int>(mesh.surface.size()));
}

TEST(FaceNeighbours, RefuseThreeTetsOnOneFace) {
  EXPECT_THROW(faceNeighbours({{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}}), std::invalid_argument);
}

}  // namespace
}  // namespace halsted
