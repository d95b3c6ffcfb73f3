/// Seams at rest and under pressure (physics.md C6): walls that are sewn together lie still; more stitches and deeper bites hold more.
#include <gtest/gtest.h>

#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

/// Contacts with forces that ran ahead of the tissue had the walls of these three seams swing by 0.5, 1.4 and 1.2 mm for ever.
TEST(SeamAtRest, LiesStill) {
  for (const Seam& seam : {Seam{.stitches = 7, .spacing = 3e-3}, Seam{.stitches = 4, .spacing = 6e-3}, Seam{.stitches = 3, .spacing = 9e-3}}) {
    SewnEnds ends(seam);
    ends.tighten();
    for (int k = 0; k < 500; ++k) ends.step();
    std::vector<Vec3> low = ends.state.tissue.position, high = low;   // [m]
    for (int k = 0; k < 300; ++k) {
      ends.step();
      for (std::size_t v = 0; v < low.size(); ++v) {
        low[v] = low[v].cwiseMin(ends.state.tissue.position[v]);
        high[v] = high[v].cwiseMax(ends.state.tissue.position[v]);
      }
    }
    double swing = 0.0;                        // [m]
    for (std::size_t v = 0; v < low.size(); ++v) swing = std::max(swing, (high[v] - low[v]).norm());
    std::printf("%d stitches, %.0f mm apart: swing %.3f mm\n", seam.stitches, 1e3 * seam.spacing, 1e3 * swing);
    EXPECT_LT(swing, 0.1e-3);
  }
}

/// Faster than at the table: what opens is quasi-static either way.
double burstPressure(const Seam& seam) {       // [mmHg]
  SewnEnds ends(seam);
  ends.tighten();
  const Outcome o = testOutcome(ends.model, ends.state, {.rate = 10.0});
  EXPECT_TRUE(o.tested);
  return o.leakPressure;
}

/// In the mean of seams that are drawn loosely, well and tightly: how far a single one opens hangs on how its few vertices happen to lie.
TEST(BurstPressure, FallsWithTheSpacingOfStitches) {
  const auto mean = [](int stitches, double spacing) {   // [m], [mmHg]
    double sum = 0.0;                          // [mmHg]
    for (double press : {0.4e-3, 0.6e-3, 0.8e-3}) sum += burstPressure({.stitches = stitches, .spacing = spacing, .press = press});
    return sum / 3.0;
  };
  const double close = mean(7, 3e-3), middle = mean(4, 6e-3), wide = mean(3, 9e-3);
  std::printf("3, 6, 9 mm apart: %.1f, %.1f, %.1f mmHg\n", close, middle, wide);
  EXPECT_GT(close, middle);
  EXPECT_GT(middle, wide);
  EXPECT_GT(wide, 4.0);                        // the weakest of published hand-sewn seams
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
