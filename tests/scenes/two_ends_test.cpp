/// Two bowel ends made of one.
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/procedural_colon.h"
#include "scenes/two_ends.h"
#include "sim/bowels.h"
#include "sim/contact/surface.h"
#include "sim/join.h"
#include "sim/portable_math.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

AnatomyParams endOfThePaper() {
  AnatomyParams params;
  params.around = 33;
  params.along = 18;
  return params;
}

TEST(TwoEnds, HaveThePublishedNumberOfParticlesEach) {
  const TetMesh both = scenes::twoEnds(scenes::proceduralColon(endOfThePaper()), 8e-3);
  EXPECT_NEAR(static_cast<double>(both.vertices.size()) / 2.0, 1185.0, 0.02 * 1185.0);
}

TEST(TwoEnds, AreEachTheSameWall) {
  const TetMesh one = scenes::proceduralColon(endOfThePaper());
  for (const TetMesh& both : {scenes::twoEnds(one, 8e-3), scenes::endToEnd(one, 8e-3)}) {
    EXPECT_NEAR(volume(both), 2.0 * volume(one), 1e-12);
    for (int t = 0; t < static_cast<int>(both.tets.size()); ++t) ASSERT_GT(volume(both, t), 0.0) << t;
    const Bowels b = findBowels(both);
    ASSERT_EQ(b.count, 2);
    EXPECT_EQ(b.rim[0].size(), one.rim.size());
    EXPECT_EQ(b.rim[1].size(), one.rim.size());
    EXPECT_NEAR(enclosedArea(b.rim[1], both.vertices), enclosedArea(one.rim, one.vertices), 1e-12);
  }
}

TEST(TwoEnds, LieSideBySideAsFarApartAsAsked) {
  const TetMesh both = scenes::twoEnds(scenes::proceduralColon(endOfThePaper()), 8e-3);
  const Bowels b = findBowels(both);
  EXPECT_LT((b.opening[0].axis - Vec3::UnitZ()).norm(), 1e-9);
  EXPECT_LT((b.opening[1].axis - Vec3::UnitZ()).norm(), 1e-9);
  const double gap = buildJoin(both, b, buildSurface(both)).restGap;
  EXPECT_GE(gap, 8e-3 - 1e-9);
  EXPECT_LT(gap, 11e-3);                       // the haustra bulge less at the rim than below
}

TEST(EndToEnd, FaceEachOtherAsFarApartAsAsked) {
  const TetMesh both = scenes::endToEnd(scenes::proceduralColon(endOfThePaper()), 6e-3);
  const Bowels b = findBowels(both);
  EXPECT_LT((b.opening[0].axis - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((b.opening[1].axis + Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((b.opening[0].up - Vec3::UnitY()).norm(), 1e-9);
  double nearest = 1e300, radius = 0.0;        // [m]
  for (const Vec3& a : both.vertices)
    for (int r : b.rim[0]) nearest = std::min(nearest, a.x() > 0.0 ? a.x() - both.vertices[r].x() : 1e300);
  EXPECT_NEAR(nearest, 6e-3, 1e-12);           // from the plane of the one edge to that of the other
  // An odd number of vertices round: seen along the axis, those of the one end lie opposite to the middles of the other's chords, outside
  // these by the sagitta r (1 - cos(pi / n)). The way from a vertex to the other end is the hypotenuse of that and the gap.
  const Vec3 middle = 0.5 * (b.opening[0].centre + b.opening[1].centre);   // [m]
  for (int r : b.rim[0]) radius = std::max(radius, std::hypot(both.vertices[r].y() - middle.y(), both.vertices[r].z() - middle.z()));
  const double sagitta = radius * (1.0 - std::cos(kPi / endOfThePaper().around));   // [m]
  const double gap = buildJoin(both, b, buildSurface(both)).restGap;
  EXPECT_GE(gap, 6e-3 - 1e-12);
  EXPECT_LE(gap, std::hypot(6e-3, sagitta) + 1e-12);
}

TEST(Bowels, OneTubeIsOneBowelRoundTheWorldsAxes) {
  const Bowels b = findBowels(scenes::proceduralColon({}));
  EXPECT_EQ(b.count, 1);
  EXPECT_EQ(b.opening[0].centre, Vec3(Vec3::Zero()));
  for (std::size_t v = 0; v < b.wallDepth.size(); ++v) EXPECT_EQ(b.wallDepth[v], static_cast<double>(v & 1)) << v;
}

}  // namespace
}  // namespace halsted
