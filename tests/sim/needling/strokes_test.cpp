/// Strokes to and fro are counted by where they turn back.
#include "sim/needling/strokes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halsted {
namespace {

Strokes follow(double amplitude, int cycles, double tremor) {   // [any] half the stroke; cycles [1]; tremor [any]
  Strokes s;
  for (int k = 0; k <= 1000 * cycles; ++k)
    followStroke({0.5, 2.0, 10.0}, amplitude * std::sin(6.28318530717958648 * k / 1000) + tremor * std::sin(0.7 * k), s);
  return s;
}

TEST(Strokes, CountEachWayOnceWithItsAmplitude) {
  const Strokes s = follow(2.5, 10, 0.0);
  EXPECT_EQ(s.count, 20);                      // the last stroke has not turned back yet, the first came from the middle
  EXPECT_NEAR(s.amplitude, 2.5 + 19 * 5.0, 1e-3);
  EXPECT_EQ(s.counted, 20);
  EXPECT_NEAR(s.trough / s.troughs, -2.5, 1e-3);
}

TEST(Strokes, TremblingIsNoStroke) {
  EXPECT_EQ(follow(0.0, 10, 0.2).count, 0);
  EXPECT_EQ(follow(2.5, 10, 0.2).count, 20);
}

TEST(Strokes, OutsideTheRangeTheyDoNotCount) {
  EXPECT_EQ(follow(0.6, 10, 0.0).counted, 0);
  EXPECT_GT(follow(0.6, 10, 0.0).count, 15);
  EXPECT_LE(follow(8.0, 10, 0.0).counted, 1);  // the first, from the middle
}

}  // namespace
}  // namespace halsted
