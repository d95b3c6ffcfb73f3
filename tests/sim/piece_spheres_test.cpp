/// Which bounding spheres come near one: asked of four at a time, the answer is that of asking each.
#include <gtest/gtest.h>

#include <random>

#include "sim/strand/piece_spheres.h"

namespace halsted {
namespace {

constexpr int kSpheres = 61;

PieceSpheres scattered() {
  std::mt19937 random(3);
  std::uniform_real_distribution<> side(-1.0, 1.0), radius(0.05, 0.2);
  PieceSpheres s;
  s.resize(kSpheres);
  for (int p = 0; p < kSpheres; ++p) s.set(p, Vec3(side(random), side(random), side(random)), radius(random));
  return s;
}

TEST(PieceSpheres, AreFoundFourAtATimeAsOneByOne) {
  if (widestLanes() != LanePath::kWide) GTEST_SKIP() << "no AVX2";
  const PieceSpheres s = scattered();
  int found = 0;
  for (int p = 0; p < kSpheres; ++p)
    for (int begin : {0, 3, 57})
      for (int end : {begin + 1, begin + 2, kSpheres}) {
        int one[kSpheres] = {}, four[kSpheres] = {};
        const int count = spheresNear(s, begin, end, s.centre(p), 0.4, one, LanePath::kSerial);
        ASSERT_EQ(spheresNear(s, begin, end, s.centre(p), 0.4, four, LanePath::kWide), count);
        for (int k = 0; k < count; ++k) EXPECT_EQ(one[k], four[k]);
        found += count;
      }
  EXPECT_GT(found, 500);
  EXPECT_LT(found, 3000);
}

TEST(PieceSpheres, NearIsWhatReachesAcrossTheGapAndNoMore) {
  PieceSpheres s;
  s.resize(2);
  s.set(0, Vec3(1.0, 0.0, 0.0), 0.25);
  s.set(1, Vec3(0.0, 0.0, 2.0), 0.5);
  int found[2];
  EXPECT_EQ(spheresNear(s, 0, 2, Vec3::Zero(), 0.74, found), 0);
  ASSERT_EQ(spheresNear(s, 0, 2, Vec3::Zero(), 0.75, found), 1);
  EXPECT_EQ(found[0], 0);
  EXPECT_EQ(spheresNear(s, 0, 2, Vec3::Zero(), 1.5, found), 2);
}

}  // namespace
}  // namespace halsted
