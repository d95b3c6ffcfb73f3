/// Tubes of known shape through the reader of real anatomy: what is measured is what was made, and what is no tube is refused.
#include "scenes/tube.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/centreline.h"
#include "scenes/scene.h"
#include "scenes/tube_segment.h"
#include "tests/scenes/surface_makers.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

using scenes::Surface;
using testing::expectRefused;
using testing::TubeShape;

AnatomyParams at(const std::string& segment) {
  AnatomyParams params;
  params.segment = segment;
  return params;
}

/// Distance of every outer vertex from a straight axis through the rim's centre.
void expectOuterRadius(const TetMesh& mesh, double radius, double tolerance) {  // [m]
  for (std::size_t v = 0; v < mesh.vertices.size(); v += 2) EXPECT_NEAR(mesh.vertices[v].head<2>().norm(), radius, tolerance);
}

class TubeSegments : public ::testing::TestWithParam<const char*> {};

TEST_P(TubeSegments, OfAStraightTubeAreThatTube) {
  const TetMesh mesh = scenes::tubeSegment(testing::tubeSurface({}), at(GetParam()));
  testing::expectWholeWall(mesh);
  EXPECT_EQ(mesh.vertices.size(), 1224u);
  expectOuterRadius(mesh, 20e-3, 0.4e-3);
  EXPECT_GT(testing::worstQuality(mesh), 0.3);
  EXPECT_GT(testing::leastDistanceToOuterLayer(mesh), 1.8e-3);
  EXPECT_LT(testing::largestDistanceToOuterLayer(mesh), 2.05e-3);
}

INSTANTIATE_TEST_SUITE_P(All, TubeSegments, ::testing::Values("", "start", "end", "0.35", "0.1:0.5", "0.9:0.5"));

TEST(Tube, IsAnatomyLengthLong) {
  AnatomyParams params = at("0.2");
  params.length = 45e-3;
  const TetMesh mesh = scenes::tubeSegment(testing::tubeSurface({}), params);
  EXPECT_NEAR(mesh.vertices[mesh.fixed[0]].z(), -45e-3, 1e-3);
  EXPECT_NEAR(mesh.uv[mesh.fixed[0]].y(), 45e-3, 1e-3);
}

TEST(Tube, MayBend) {
  TubeShape shape;
  shape.bendRadius = 80e-3;
  const TetMesh mesh = scenes::tubeSegment(testing::tubeSurface(shape), at(""));
  testing::expectWholeWall(mesh);
  EXPECT_GT(testing::worstQuality(mesh), 0.15);
}

TEST(Tube, IsMovedButNotDeformedByWhereItLies) {
  const Surface straight = testing::tubeSurface({});
  Surface moved = straight;
  const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, -1).normalized());
  for (Vec3& v : moved.vertices) v = turn * v + Vec3(0.3, -0.2, 0.5);
  const TetMesh a = scenes::tubeSegment(straight, at("0.3")), b = scenes::tubeSegment(moved, at("0.3"));
  EXPECT_NEAR(volume(a), volume(b), 0.01 * volume(a));
  expectOuterRadius(b, 20e-3, 0.4e-3);
}

TEST(Tube, GivesTheSameBytesTwice) {
  TubeShape shape;
  shape.bendRadius = 90e-3;
  const Surface surface = testing::tubeSurface(shape);
  EXPECT_EQ(testing::bitsOf(scenes::tubeSegment(surface, at(""))), testing::bitsOf(scenes::tubeSegment(surface, at(""))));
}

TEST(Tube, TakesTheOuterFaceOfADoubleWall) {
  expectOuterRadius(scenes::tubeSegment(testing::doubleTube({}, 2e-3), at("0.3")), 20e-3, 0.4e-3);
}

TEST(Tube, ClosesSmallHoles) {
  const auto hole = [](const Vec3& p) { return p.x() > 16e-3 && std::abs(p.z() - 75e-3) < 6e-3; };
  const TetMesh mesh = scenes::tubeSegment(testing::without(testing::tubeSurface({}), hole), at("0.3"));
  testing::expectWholeWall(mesh);
  expectOuterRadius(mesh, 20e-3, 0.5e-3);
}

TEST(Tube, SaysHowMuchOfTheWallIsMissing) {
  const auto slot = [](const Vec3& p) { return p.x() > 9e-3 && p.z() > 40e-3 && p.z() < 110e-3; };
  expectRefused([&] { scenes::tubeSegment(testing::without(testing::tubeSurface({}), slot), at("0.3:0.7")); },
                {"% of the segment's wall is missing", "at most 20 %"});
}

TEST(Tube, IsNotASphereNorAPlane) {
  expectRefused([] { scenes::tubeSegment(testing::sphereSurface(25e-3), {}); }, {"is not a tube"});
  expectRefused([] { scenes::tubeSegment(testing::planeSurface(0.1), {}); }, {"is not a tube"});
}

TEST(Tube, IsNotASingleTriangle) {
  Surface surface;
  surface.groups = {""};
  surface.vertices = {Vec3::Zero(), Vec3(0.1, 0, 0), Vec3(0, 0.1, 0)};
  surface.triangles = {{0, 1, 2}};
  surface.triangleGroup = {0};
  expectRefused([&] { scenes::tubeSegment(surface, {}); }, {"is not a tube"});
}

TEST(Tube, NamesTheRadiusWhenTheScaleIsWrong) {
  for (double scale : {1e-3, 20.0}) {  // [1] of the right one
    Surface surface = testing::tubeSurface({});
    for (Vec3& v : surface.vertices) v *= scale;
    expectRefused([&] { scenes::tubeSegment(surface, {}); }, {"the tube's radius is", "wrong scale?"});
  }
}

TEST(Tube, MustBeAsLongAsTheSegmentAsked) {
  AnatomyParams params;
  params.length = 0.3;
  expectRefused([&] { scenes::tubeSegment(testing::tubeSurface({}), params); }, {"anatomy.length asks for 300 mm"});
  expectRefused([&] { scenes::tubeSegment(testing::tubeSurface({}), at("0.9")); }, {"anatomy.segment 0.9 leaves the tube"});
}

/// Three copies of every triangle: each edge joins six.
TEST(Tube, RefusesWhatIsNonManifoldBeyondRepair) {
  Surface surface = testing::tubeSurface({});
  const auto triangles = surface.triangles;
  for (int copy = 0; copy < 2; ++copy) surface.triangles.insert(surface.triangles.end(), triangles.begin(), triangles.end());
  surface.triangleGroup.assign(surface.triangles.size(), 0);
  expectRefused([&] { scenes::tubeSegment(surface, {}); }, {"is non-manifold", "edges join more than two triangles"});
}

TEST(Centreline, OfAStraightTubeIsItsAxis) {
  const scenes::Centreline line = scenes::traceCentreline(testing::tubeSurface({}));
  const double middle = 0.5 * line.length();  // [m]
  EXPECT_LT(line.at(middle).head<2>().norm(), 3e-3);
  EXPECT_GT(std::abs(line.tangent(middle).z()), 0.95);
  EXPECT_NEAR(line.nearest(line.at(middle)), middle, 1e-9);
}

TEST(TubeSegmentText, IsUnderstoodOrRefused) {
  using Kind = scenes::TubeSegment::Kind;
  EXPECT_EQ(scenes::parseSegment("").kind, Kind::kBest);
  EXPECT_EQ(scenes::parseSegment("start").kind, Kind::kStart);
  EXPECT_EQ(scenes::parseSegment("end").kind, Kind::kEnd);
  EXPECT_DOUBLE_EQ(scenes::parseSegment("0.35").rim, 0.35);
  EXPECT_DOUBLE_EQ(scenes::parseSegment("0.35:0.2").farEnd, 0.2);
  for (const char* bad : {"middle", "1.5", "-0.1", "0.2:", ":0.2", "0.2:0.2", "0.2:x", "nan", "0.1 ", "0,5"})
    expectRefused([&] { scenes::parseSegment(bad); }, {bad});
}

}  // namespace
}  // namespace halsted
