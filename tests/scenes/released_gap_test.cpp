/// What an inspection looks at: the walls as the knot alone holds them.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

double lastSeen(const SewnEnds& ends, Quantity q) { return ends.out.seen[static_cast<int>(q)]; }

TEST(ReleasedGap, IsTheGapOfTheWallsOnlyWhileNoHandHoldsTheThread) {
  SewnEnds ends({.stitches = 2, .press = -0.5e-3});   // drawn thread that is longer than where the walls would meet
  const auto seen = [&](Quantity q) { return lastSeen(ends, q); };
  ends.state.knot.cuts = 1;
  ends.tighten();
  EXPECT_EQ(seen(Quantity::kTailsHeld), 2.0);
  EXPECT_TRUE(std::isfinite(seen(Quantity::kWallGap)));
  EXPECT_TRUE(std::isnan(seen(Quantity::kReleasedGap)));   // walls that hands draw together pass nothing
  ends.letGo();
  EXPECT_EQ(seen(Quantity::kTailsHeld), 0.0);
  EXPECT_GT(seen(Quantity::kWallGap), 0.0);
  EXPECT_EQ(seen(Quantity::kReleasedGap), seen(Quantity::kWallGap));
}

/// Ends that lie near to each other from the start have not been sewn: asking for the next thread passes no inspection.
TEST(ReleasedGap, IsOfNoEndsThatNothingJoins) {
  SewnEnds ends({.stitches = 2});
  ends.state.knot.cuts = 1;
  ends.letGo();
  ASSERT_TRUE(std::isfinite(lastSeen(ends, Quantity::kReleasedGap)));
  ends.state.strand.holeCount = 0;
  for (int i = 0; i < 20; ++i) ends.step();
  EXPECT_LT(lastSeen(ends, Quantity::kWallGap), 1.5e-3);
  EXPECT_TRUE(std::isnan(lastSeen(ends, Quantity::kReleasedGap)));
}

/// A fresh thread was asked for before the stitch had passed: its first bite, which pressed the walls on each other, passed for it; and the gap that it
/// found was called an air knot (`altemeier`).
TEST(ReleasedGap, IsOfNoStitchThatIsStillBeingSewn) {
  SewnEnds ends({.stitches = 2});
  ends.letGo();
  EXPECT_EQ(lastSeen(ends, Quantity::kTailsHeld), 0.0);
  EXPECT_TRUE(std::isnan(lastSeen(ends, Quantity::kReleasedGap)));
  ends.state.knot.cuts = 1;
  ends.step();
  EXPECT_EQ(lastSeen(ends, Quantity::kReleasedGap), lastSeen(ends, Quantity::kWallGap));
}

}  // namespace
}  // namespace halsted
