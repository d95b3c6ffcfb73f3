/// Knots that hold, or do not, by friction and geometry alone: 3-0 braided thread, laced loosely, tightened, its loop pulled apart.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "sim/strand/knot_diagram.h"
#include "tests/sim/knot_tie.h"

namespace halsted {
namespace {

constexpr double kSlow = 0.03;                 // [m/s] slow enough that drag plays no part

TiedKnot::Loading pulled(const std::vector<int>& throws, double friction = ThreadContactParams{}.friction) {   // [1]
  constexpr double kPretension = 4.0, kPull = 5.0;   // [N]
  ThreadContactParams contact;
  contact.friction = friction;
  TiedKnot knot(throws, contact);
  knot.tighten(kPretension, 0.06);
  const TiedKnot::Loading r = knot.load(kPull, kSlow);
  EXPECT_TRUE(knot.rig.finite());
  EXPECT_EQ(knot.rig.contacts.dropped, 0);
  if (std::getenv("KNOT_VERBOSE"))
    std::printf("%zu throws, friction %.2f: most %.2f N, loop opened %.2f mm, %s\n", throws.size(), friction, r.most, 1e3 * r.gained,
                r.held ? "holds" : "slips");
  return r;
}

TEST(TiedKnots, ASquareKnotHoldsFiveNewtons) {
  const TiedKnot::Loading r = pulled({3, -3});
  EXPECT_TRUE(r.held);
  EXPECT_LT(r.gained, 2e-3) << "what its loops give way until they are tight";
}

TEST(TiedKnots, ASingleThrowSlipsWhereASquareDoes) {
  const TiedKnot::Loading r = pulled({3});
  EXPECT_TRUE(r.slipped());
  EXPECT_LT(r.most, 1.0);
}

TEST(TiedKnots, AGrannySlipsBeforeASquare) {
  const TiedKnot::Loading granny = pulled({3, 3});
  EXPECT_TRUE(granny.slipped());
  EXPECT_LT(granny.most, 4.0) << "a fifth less than a square bears without slipping";
}

TEST(TiedKnots, AThirdThrowDoesWhereSmootherThreadLetsTwoSlip) {
  EXPECT_TRUE(pulled({3, -3}, 0.20).slipped());
  EXPECT_TRUE(pulled({3, -3, 3}, 0.20).held);
}

/// 3-0 monofilament (PDS, physics.md D): stiff, smooth, and takes a set where it is bent beyond a tenth of strain (design).
SimParams monofilament() {
  SimParams p = knotThread();
  p.thread.bendingStiffness = 1.7e-7;
  p.thread.yieldMoment = 0.1 * p.thread.bendingStiffness / p.thread.radius;
  return p;
}

const std::array<double, 4> kPretensions{1.0, 2.0, 4.0, 8.0};   // [N]

/// What a granny in monofilament, drawn with each of them, bears before it slips, the thread solved in steps of `dt`.  [N]
std::array<double, 4> grannyBears(double dt) {   // [s]
  std::array<double, 4> most{};                // [N]
  for (std::size_t i = 0; i < most.size(); ++i) {
    ThreadContactParams contact;
    contact.friction = 0.20;
    TiedKnot knot(std::vector<int>{3, 3}, contact, monofilament());
    knot.rig.dt = dt;
    knot.tighten(kPretensions[i], 0.06);
    most[i] = knot.load(10.0, kSlow, 0.3).most;
    if (std::getenv("KNOT_VERBOSE")) std::printf("monofilament, step %.4f ms, pretension %.1f N: %.2f N\n", 1e3 * dt, kPretensions[i], most[i]);
  }
  return most;
}

/// The first of a surgeon's knot, on two ends that nothing else holds.  [N]
double doubleThrowBears(double dt) {   // [s]
  TiedKnot knot(std::vector<int>{5});
  knot.rig.dt = dt;
  knot.tighten(2.8, 0.06);
  const double most = knot.load(5.0, kSlow, 0.3).most;   // [N]
  if (std::getenv("KNOT_VERBOSE")) std::printf("double throw, step %.4f ms: %.3f N\n", 1e3 * dt, most);
  return most;
}

/// What a step leaves unsettled acts as friction: without a line search (step_share.h) the coarse one bears 0.18 N.
TEST(TiedKnots, WhatADoubleThrowBearsIsNotThatOfTheStep) {
  const double coarse = doubleThrowBears(0.25e-3), fine = doubleThrowBears(0.0625e-3);   // [N]
  EXPECT_NEAR(coarse, fine, 0.25 * fine);
  if (std::getenv("KNOT_VERBOSE")) doubleThrowBears(0.5e-3);   // half as many substeps, to be seen: it bears half as much again
}

double exponentOf(const std::array<double, 4>& force) {   // [1], [N]
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;   // of logarithms
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double x = std::log(kPretensions[i]), y = std::log(force[i]);
    sx += x; sy += y; sxx += x * x; sxy += x * y;
  }
  return (4.0 * sxy - sx * sy) / (4.0 * sxx - sx * sx);
}

/// Published for an elasto-plastic filament: a power of 1.6 (Johanns et al. 2023). Ours is far lower. Steps that end unsettled (no line search)
/// let a knot drawn with little force slip, at 0.4 N instead of 2.6, and make it seem 1.2.
TEST(TiedKnots, TheForceThatAGrannyHoldsRisesWithItsPretensionAndIsNotThatOfTheStep) {
  const auto coarse = grannyBears(0.25e-3), fine = grannyBears(0.0625e-3);   // [N]
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    EXPECT_GT(coarse[i], 0.7 * fine[i]);
    EXPECT_LT(coarse[i], 1.45 * fine[i]);
    if (i == 0) continue;
    EXPECT_GT(coarse[i], coarse[i - 1]);
    EXPECT_GT(fine[i], fine[i - 1]);
  }
  RecordProperty("exponent", std::to_string(exponentOf(coarse)));
  if (std::getenv("KNOT_VERBOSE")) std::printf("exponent %.2f, in the finer steps %.2f\n", exponentOf(coarse), exponentOf(fine));
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
