/// Euler and Eytelwein: T_out / T_in = exp(mu phi).
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/suture/holes.h"

namespace halsted {
namespace {

TEST(Capstan, ExcessIsTheExponentialOfFrictionTimesTurn) {
  double worst = 0.0;                            // [1]
  std::string where;
  for (double friction : {0.05, 0.15, 0.3}) {    // [1]
    for (int degrees = 1; degrees <= 120; ++degrees) {
      const double phi = degrees * 3.14159265358979312 / 180.0;                // [rad]
      const double exact = std::exp(friction * phi) - 1.0;                     // [1]
      const double found = capstanExcess(Vec3::UnitX(), Vec3(std::cos(phi), std::sin(phi), 0.0), friction);
      const double error = std::fabs(found / exact - 1.0);                     // [1]
      if (error <= worst) continue;
      worst = error;
      where = std::to_string(degrees) + " degrees, friction " + std::to_string(friction);
    }
  }
  EXPECT_LT(worst, 1e-3) << where;
  RecordProperty("relative_error", std::to_string(worst));
}

TEST(Capstan, AStraightThreadHasNone) { EXPECT_EQ(capstanExcess(Vec3::UnitZ(), Vec3::UnitZ(), 0.3), 0.0); }

TEST(Capstan, GrowsWithTheTurnUpToAHairpin) {
  double last = 0.0;                             // [1]
  for (int degrees = 1; degrees <= 180; ++degrees) {
    const double phi = degrees * 3.14159265358979312 / 180.0;                  // [rad]
    const double found = capstanExcess(Vec3::UnitX(), Vec3(std::cos(phi), std::sin(phi), 0.0), 0.15);
    EXPECT_GT(found, last) << degrees << " degrees";
    last = found;
  }
}

}  // namespace
}  // namespace halsted
