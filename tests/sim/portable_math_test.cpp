#include "sim/portable_math.h"

#include <gtest/gtest.h>

#include <cmath>

namespace halsted {
namespace {

constexpr double kClose = 1e-15;               // [1] some units in the last place of 1

TEST(PortableMath, SineAndCosineAreThoseOfTheLibrary) {
  for (double x = -60.0; x <= 60.0; x += 1.37e-3) {
    EXPECT_NEAR(sine(x), std::sin(x), 1e-14);
    EXPECT_NEAR(cosine(x), std::cos(x), 1e-14);
  }
  for (double x = -0.25 * kPi; x <= 0.25 * kPi; x += 1e-3) {
    EXPECT_NEAR(sineNearZero(x), std::sin(x), kClose);
    EXPECT_NEAR(cosineNearZero(x), std::cos(x), kClose);
  }
}

TEST(PortableMath, ArcSineIsThatOfTheLibraryAndStopsAtTheEnds) {
  for (double x = -1.0; x <= 1.0; x += 1e-4) EXPECT_NEAR(arcSine(x), std::asin(x), kClose) << x;
  EXPECT_DOUBLE_EQ(arcSine(1.5), 0.5 * kPi);
  EXPECT_DOUBLE_EQ(arcSine(-1.5), -0.5 * kPi);
}

TEST(PortableMath, SmoothStepJoinsItsEndsWithTwoDerivatives) {
  EXPECT_EQ(smoothStep(-1.0), 0.0);
  EXPECT_EQ(smoothStep(2.0), 1.0);
  EXPECT_DOUBLE_EQ(smoothStep(0.5), 0.5);
  constexpr double kSmall = 1e-4;              // [1]
  EXPECT_LT(smoothStep(kSmall), 11.0 * kSmall * kSmall * kSmall);   // rises with the cube, so slope and curvature start at 0
  EXPECT_LT(1.0 - smoothStep(1.0 - kSmall), 11.0 * kSmall * kSmall * kSmall);
}

}  // namespace
}  // namespace halsted
