/// What an inspection looks at: the walls as the knot alone holds them.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

TEST(ReleasedGap, IsTheGapOfTheWallsOnlyWhileNoHandHoldsTheThread) {
  SewnEnds ends({.stitches = 2});
  const auto seen = [&](Quantity q) { return ends.out.seen[static_cast<int>(q)]; };
  ends.tighten();
  EXPECT_EQ(seen(Quantity::kTailsHeld), 2.0);
  EXPECT_TRUE(std::isfinite(seen(Quantity::kWallGap)));
  EXPECT_TRUE(std::isnan(seen(Quantity::kReleasedGap)));   // walls that hands draw together pass nothing
  ends.letGo();
  EXPECT_EQ(seen(Quantity::kTailsHeld), 0.0);
  EXPECT_GT(seen(Quantity::kWallGap), 0.0);
  EXPECT_EQ(seen(Quantity::kReleasedGap), seen(Quantity::kWallGap));
}

}  // namespace
}  // namespace halsted
