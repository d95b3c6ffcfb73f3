/// Laws that every material keeps, written once.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/materials/corotated.h"
#include "sim/materials/matrix_calculus.h"
#include "sim/materials/stable_neo_hookean.h"

namespace halsted {
namespace {

constexpr double kMu = 41.4e3, kLambda = 372.4e3;        // [Pa] E = 120 kPa, nu = 0.45

/// Deterministic spread of matrices around the identity, from mild to inverted.
Mat3 sample(int n, double size) {                        // size [1]
  Mat3 m;
  for (int i = 0; i < 9; ++i) m(i / 3, i % 3) = size * std::sin(1.7 * n + 2.3 * i + 0.4 * i * n);
  return m;
}

Mat3 turn(int n) { return Quat(Eigen::AngleAxisd(0.9 * n, Vec3(1, 0.3 * n, -0.7).normalized())).toRotationMatrix(); }

template <class M> class MaterialLaws : public testing::Test {
 protected:
  const M material{kMu, kLambda};
};
struct StiffeningCorotated : Corotated {
  StiffeningCorotated(double shear, double bulk) : Corotated{shear, bulk, 5.0, 0.2} {}           // [Pa] Lame parameters
};
using AllMaterials = testing::Types<Corotated, StiffeningCorotated, StableNeoHookean>;
TYPED_TEST_SUITE(MaterialLaws, AllMaterials);

TYPED_TEST(MaterialLaws, ZeroAtRest) {
  EXPECT_NEAR(energyDensity(this->material, Mat3::Identity()), 0.0, 1e-9);
  EXPECT_LT(stress(this->material, Mat3::Identity()).norm(), 1e-9);
}

TYPED_TEST(MaterialLaws, RestIsTheMinimum) {
  for (int n = 0; n < 20; ++n) EXPECT_GT(energyDensity(this->material, Mat3::Identity() + sample(n, 0.1)), 0.0);
}

TYPED_TEST(MaterialLaws, StressIsDerivativeOfEnergy) {
  for (int n = 0; n < 20; ++n) {
    const Mat3 F = turn(n) * (Mat3::Identity() + sample(n, 0.3)), P = stress(this->material, F);
    for (int i = 0; i < 9; ++i) {
      Mat3 d = Mat3::Zero();
      d(i / 3, i % 3) = 1e-6;
      const double slope = (energyDensity(this->material, F + d) - energyDensity(this->material, F - d)) / 2e-6;   // [Pa]
      EXPECT_NEAR(P(i / 3, i % 3), slope, 1e-6 * kLambda);
    }
  }
}

TYPED_TEST(MaterialLaws, DifferentialIsDerivativeOfStress) {
  for (int n = 0; n < 20; ++n) {
    const Mat3 F = turn(n) * (Mat3::Identity() + sample(n, 0.3)), dF = sample(n + 50, 1.0);
    const Mat3 slope = (stress(this->material, F + 1e-6 * dF) - stress(this->material, F - 1e-6 * dF)) / 2e-6;     // [Pa]
    EXPECT_LT((stressDifferential(this->material, F, dF) - slope).norm(), 1e-6 * kLambda);
  }
}

TYPED_TEST(MaterialLaws, DifferentialIsSymmetric) {
  for (int n = 0; n < 20; ++n) {
    const Mat3 F = turn(n) * (Mat3::Identity() + sample(n, 0.3)), a = sample(n + 50, 1.0), b = sample(n + 90, 1.0);
    EXPECT_NEAR(contract(a, stressDifferential(this->material, F, b)), contract(b, stressDifferential(this->material, F, a)),
                1e-9 * kLambda);
  }
}

TYPED_TEST(MaterialLaws, InvariantUnderRotation) {
  for (int n = 0; n < 20; ++n) {
    const Mat3 F = Mat3::Identity() + sample(n, 0.3), Q = turn(n);
    EXPECT_NEAR(energyDensity(this->material, Q * F), energyDensity(this->material, F), 1e-10 * kLambda);
    EXPECT_NEAR(energyDensity(this->material, F * Q), energyDensity(this->material, F), 1e-10 * kLambda);   // isotropy
    EXPECT_LT((stress(this->material, Q * F) - Q * stress(this->material, F)).norm(), 1e-10 * kLambda);
  }
}

TYPED_TEST(MaterialLaws, SmallStrainsFollowHooke) {
  for (int n = 0; n < 20; ++n) {
    const Mat3 e = sample(n, 1e-6), strain = 0.5 * (e + e.transpose());
    const Mat3 hooke = 2.0 * kMu * strain + kLambda * strain.trace() * Mat3::Identity();                  // [Pa]
    EXPECT_LT((stress(this->material, Mat3::Identity() + e) - hooke).norm(), 2e-5 * hooke.norm());
  }
}

TYPED_TEST(MaterialLaws, AngularMomentumIsConserved) {   // P F^T is symmetric
  for (int n = 0; n < 20; ++n) {
    const Mat3 F = turn(n) * (Mat3::Identity() + sample(n, 0.3)), tau = stress(this->material, F) * F.transpose();
    EXPECT_LT((tau - tau.transpose()).norm(), 1e-10 * kLambda);
  }
}

TYPED_TEST(MaterialLaws, FiniteWhenFlatCollapsedOrInverted) {
  const Mat3 shapes[] = {Mat3::Zero(), Vec3(1, 1, 0).asDiagonal(), Vec3(1, 0, 0).asDiagonal(), Vec3(1, 1, -1).asDiagonal(),
                         Vec3(-1, -1, -1).asDiagonal()};
  for (const Mat3& F : shapes) {
    EXPECT_TRUE(std::isfinite(energyDensity(this->material, F)));
    EXPECT_TRUE(stress(this->material, F).allFinite());
    EXPECT_TRUE(stressDifferential(this->material, F, sample(3, 1.0)).allFinite());
  }
}

/// J-shaped: pulled with nu = 0 the slope is E within the toe and k E past it, and stress does not jump between.
TEST(Corotated, StiffensPastItsToe) {
  const Corotated wall{kMu, 0.0, 5.0, 0.2};
  const auto pulled = [&](double strain) { return stress(wall, Vec3(1.0 + strain, 1.0, 1.0).asDiagonal())(0, 0); };   // [Pa]
  EXPECT_NEAR((pulled(0.19) - pulled(0.01)) / 0.18, 2.0 * kMu, 1e-6 * kMu);
  EXPECT_NEAR((pulled(0.40) - pulled(0.21)) / 0.19, 10.0 * kMu, 1e-6 * kMu);
  EXPECT_NEAR(pulled(0.2 + 1e-9), pulled(0.2 - 1e-9), 1e-6 * kMu);
}

TYPED_TEST(MaterialLaws, AnInvertedShapeIsPushedBack) {
  const Mat3 F = Vec3(1.0, 1.0, -0.5).asDiagonal();
  EXPECT_LT(stress(this->material, F)(2, 2), 0.0);       // energy falls as the third axis grows
}

}  // namespace
}  // namespace halsted
