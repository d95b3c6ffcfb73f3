/// What a leak test says of seams (physics.md C6): more stitches and deeper bites hold more.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

/// Faster than at the table: what opens is quasi-static either way.
double burstPressure(const Seam& seam) {       // [mmHg]
  SewnEnds ends(seam);
  ends.tighten();
  const Outcome o = testOutcome(ends.model, ends.state, {.rate = 10.0});
  EXPECT_TRUE(o.tested);
  return o.leakPressure;
}

TEST(BurstPressure, FallsWithTheSpacingOfStitches) {
  const double close = burstPressure({.stitches = 7, .spacing = 3e-3}), middle = burstPressure({.stitches = 4, .spacing = 6e-3}),
               wide = burstPressure({.stitches = 3, .spacing = 9e-3});
  EXPECT_GT(close, middle);
  EXPECT_GT(middle, wide);
}

/// Stitches that nobody has drawn: the walls stand apart, and no pressure at all is held.
TEST(BurstPressure, IsNoneWhereTheWallsStandApart) {
  SewnEnds ends({.stitches = 3, .spacing = 6e-3});
  const Outcome o = testOutcome(ends.model, ends.state);
  EXPECT_TRUE(o.tested);
  EXPECT_EQ(o.end, LeakEnd::kOpen);
  EXPECT_EQ(o.leakPressure, 0.0);
}

/// The mean of five spacings: which of two depths holds more at one of them, a rounding decides. Past 5 mm it does not rise further here:
/// the lip beyond the stitch opens.
double meanBurstPressure(double depth) {       // [mmHg], [m]
  double sum = 0.0;                            // [mmHg]
  for (double spacing : {4e-3, 5e-3, 6e-3, 7e-3, 8e-3}) sum += burstPressure({.stitches = 4, .spacing = spacing, .depth = depth});
  return sum / 5.0;
}

TEST(BurstPressure, RisesWithTheDepthOfBites) {
  const double shallow = meanBurstPressure(3e-3), middle = meanBurstPressure(4e-3), deep = meanBurstPressure(5e-3);   // [mmHg]
  std::printf("bites 3, 4, 5 mm deep: %.2f, %.2f, %.2f mmHg\n", shallow, middle, deep);
  EXPECT_GT(middle, shallow);
  EXPECT_GT(deep, middle);
}

}  // namespace
}  // namespace halsted
