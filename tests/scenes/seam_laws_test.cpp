/// What a leak test says of seams (physics.md C6): more stitches and deeper bites hold more.
#include <gtest/gtest.h>

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

/// At equal spacing. Past 5 mm it does not rise further here: the lip beyond the stitch opens.
TEST(BurstPressure, RisesWithTheDepthOfBites) {
  EXPECT_GT(burstPressure({.stitches = 4, .spacing = 6e-3, .depth = 5e-3}), burstPressure({.stitches = 4, .spacing = 6e-3, .depth = 3e-3}));
}

}  // namespace
}  // namespace halsted
