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
  EXPECT_LT(granny.most, 4.0) << "a fifth less than a square bears without slipping";
}

TEST(TiedKnots, AThirdThrowHoldsWhereSmootherThreadLetsTwoSlip) {
  EXPECT_TRUE(pulled({3, -3}, 4.0, 5.0, 0.20).slipped());
  EXPECT_TRUE(pulled({3, -3, 3}, 4.0, 5.0, 0.20).held);
}

/// 3-0 monofilament (PDS, physics.md D): stiff, smooth, and takes a set where it is bent beyond a tenth of strain (design).
SimParams monofilament() {
  SimParams p = knotThread();
  p.thread.bendingStiffness = 1.7e-7;
  p.thread.yieldMoment = 0.1 * p.thread.bendingStiffness / p.thread.radius;
  return p;
}

/// Published for an elasto-plastic filament: 1.6 (Johanns et al. 2023). Thread that is elastic has a half, for what remains of the
/// pretension once the ends are let go is held by friction only; a limp braid, bent into shape by any pull, none.
TEST(TiedKnots, TheForceThatAGrannyHoldsRisesAsAPowerOfItsPretension) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, last = 0.0;   // of logarithms
  for (double pretension : {1.0, 2.0, 4.0, 8.0}) {               // [N]
    ThreadContactParams contact;
    contact.friction = 0.20;
    TiedKnot knot(std::vector<int>{3, 3}, contact, monofilament());
    knot.tighten(pretension, 0.06);
    const double most = knot.load(10.0, kSlow, 0.3).most;        // [N]
    EXPECT_GT(most, last);
    last = most;
    if (std::getenv("KNOT_VERBOSE")) std::printf("monofilament, pretension %.1f N: %.2f N\n", pretension, most);
    const double x = std::log(pretension), y = std::log(most);
    sx += x; sy += y; sxx += x * x; sxy += x * y;
  }
  const double exponent = (4.0 * sxy - sx * sy) / (4.0 * sxx - sx * sx);   // [1]
  RecordProperty("exponent", std::to_string(exponent));
  if (std::getenv("KNOT_VERBOSE")) std::printf("exponent %.3f\n", exponent);
  EXPECT_GT(exponent, 1.1);
  EXPECT_LT(exponent, 2.0);
}

/// From loosely laced to tight, at every look.
TEST(TiedKnots, AreReadAsWhatTheyAreWhileTheyAreTightened) {
  for (const auto& [throws, name] : {std::pair(std::vector<int>{3, -3}, "square"), std::pair(std::vector<int>{3, 3}, "granny"),
                                     std::pair(std::vector<int>{5, -3, 3}, "surgeon's"), std::pair(std::vector<int>{3, -3, 3}, "1=1=1")}) {
    TiedKnot knot(throws);
    knot.tighten(8.0, 0.0);
    for (int look = 0; look < 30; ++look) {
      knot.run(5e-3);
      EXPECT_EQ(knotName(readKnot(knot.rig.state.position)), name) << "look " << look;
    }
  }
}

}  // namespace
}  // namespace halsted
