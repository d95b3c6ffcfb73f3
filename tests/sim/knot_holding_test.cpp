/// Knots that hold, or do not, by friction and geometry alone: 3-0 braided thread, laced loosely, tightened, its loop pulled apart.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "sim/strand/knot_diagram.h"
#include "tests/sim/knot_tie.h"

namespace halsted {
namespace {

constexpr double kSlow = 0.03;                 // [m/s] slow enough that drag plays no part

TiedKnot::Loading pulled(const std::vector<int>& throws, double pretension, double force, double friction) {   // [N], [N], [1]
  ThreadContactParams contact;
  contact.friction = friction;
  TiedKnot knot(throws, contact);
  knot.tighten(pretension, 0.06);
  const TiedKnot::Loading r = knot.load(force, kSlow);
  EXPECT_TRUE(knot.rig.finite());
  EXPECT_EQ(knot.rig.contacts.dropped, 0);
  if (std::getenv("KNOT_VERBOSE"))
    std::printf("%zu throws, pretension %.1f N, friction %.2f: most %.2f N, loop opened %.2f mm, %s\n", throws.size(), pretension, friction, r.most,
                1e3 * r.gained, r.held ? "holds" : "slips");
  return r;
}

const double kBraid = ThreadContactParams{}.friction;   // [1]

TEST(TiedKnots, ASquareKnotHoldsFiveNewtons) {
  const TiedKnot::Loading r = pulled({3, -3}, 4.0, 5.0, kBraid);
  EXPECT_TRUE(r.held);
  EXPECT_LT(r.gained, 2e-3) << "what its loops give way until they are tight";
}

TEST(TiedKnots, ASingleThrowSlipsWhereASquareHolds) {
  const TiedKnot::Loading r = pulled({3}, 4.0, 5.0, kBraid);
  EXPECT_TRUE(r.slipped());
  EXPECT_LT(r.most, 1.0);
}

TEST(TiedKnots, AGrannySlipsBeforeASquare) {
  const TiedKnot::Loading granny = pulled({3, 3}, 4.0, 5.0, kBraid);
  EXPECT_TRUE(granny.slipped());
  EXPECT_LT(granny.most, 2.5);
}

TEST(TiedKnots, AThirdThrowHoldsWhereSmootherThreadLetsTwoSlip) {
  EXPECT_TRUE(pulled({3, -3}, 4.0, 5.0, 0.25).slipped());
  EXPECT_TRUE(pulled({3, -3, 3}, 4.0, 5.0, 0.30).held);
}

/// Published for an elasto-plastic filament: 1.6 (Johanns et al. 2023). This thread is elastic: what remains of the pretension once the
/// ends are let go is held by friction only, and the exponent is about a half.
TEST(TiedKnots, TheForceThatAGrannyHoldsRisesAsAPowerOfItsPretension) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, last = 0.0;   // of logarithms
  for (double pretension : {1.0, 2.0, 4.0, 8.0}) {               // [N]
    ThreadContactParams contact;
    TiedKnot knot(std::vector<int>{3, 3}, contact);
    knot.tighten(pretension, 0.06);
    const double most = knot.load(5.0, kSlow, 0.05).most;        // [N]
    EXPECT_GT(most, last);
    last = most;
    const double x = std::log(pretension), y = std::log(most);
    sx += x; sy += y; sxx += x * x; sxy += x * y;
  }
  const double exponent = (4.0 * sxy - sx * sy) / (4.0 * sxx - sx * sx);   // [1]
  RecordProperty("exponent", std::to_string(exponent));
  if (std::getenv("KNOT_VERBOSE")) std::printf("exponent %.3f\n", exponent);
  EXPECT_GT(exponent, 0.35);
  EXPECT_LT(exponent, 0.75);
}

TEST(TiedKnots, TightenedKnotsAreStillReadAsWhatTheyAre) {
  for (const auto& [throws, name] : {std::pair(std::vector<int>{3, -3}, "square"), std::pair(std::vector<int>{3, 3}, "granny"),
                                     std::pair(std::vector<int>{5, -3, 3}, "surgeon's")}) {
    TiedKnot knot(throws);
    knot.tighten(2.0, 0.05);
    EXPECT_EQ(knotName(readKnot(knot.rig.state.position)), name);
  }
}

}  // namespace
}  // namespace halsted
