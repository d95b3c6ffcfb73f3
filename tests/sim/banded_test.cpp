/// The banded direct solve against a dense one.
#include "sim/strand/banded.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>

namespace halsted {
namespace {

/// Random symmetric matrix inside the band, made positive definite by its diagonal. `mixed`: most rows go no farther than bending does.
struct Pair {
  BandedMatrix banded;
  Eigen::MatrixXd dense;

  Pair(int size, unsigned seed, bool mixed = false) : dense(Eigen::MatrixXd::Zero(size, size)) {
    banded.resize(size);
    std::srand(seed);
    const Eigen::MatrixXd r = Eigen::MatrixXd::Random(size, size);
    for (int i = 0; i < size; ++i) {
      const int reach = mixed && i % 40 < 25 ? BandedMatrix::kBending : BandedMatrix::kHalf;
      for (int j = i + 1; j < size && j <= i + reach; ++j) {
        put(i, j, r(i, j));
        put(i, i, std::fabs(r(i, j)));
        put(j, j, std::fabs(r(i, j)));
      }
    }
    for (int i = 0; i < size; ++i) put(i, i, 0.01 + std::fabs(r(i, i)));
  }
  void put(int i, int j, double value) {       // [any]
    banded.add(i, j, value);
    dense(i, j) += value;
    if (i != j) dense(j, i) += value;
  }
};

TEST(BandedMatrix, SolvesAsADenseFactorisationDoes) {
  for (int size : {1, 5, 12, 13, 30, 66, -66, 180, -180, 531}) {         // negative: mixed
    Pair a(std::abs(size), static_cast<unsigned>(size), size < 0);
    size = std::abs(size);
    const Eigen::VectorXd rhs = Eigen::VectorXd::Random(size);
    Eigen::VectorXd x = rhs;
    ASSERT_TRUE(a.banded.factorAndSolve(x.data())) << size;
    const Eigen::VectorXd expected = a.dense.ldlt().solve(rhs);
    EXPECT_LT((x - expected).norm(), 1e-10 * expected.norm()) << size;
  }
}

TEST(BandedMatrix, ReadsBackBothTrianglesAndNothingOutsideTheBand) {
  const Pair a(40, 7);
  for (int i = 0; i < 40; ++i)
    for (int j = 0; j < 40; ++j) EXPECT_EQ(a.banded.at(i, j), a.dense(i, j)) << i << ", " << j;
}

TEST(BandedMatrix, RefusesWhatIsNotPositiveDefinite) {
  for (double diagonal : {-1.0, 0.0, std::numeric_limits<double>::quiet_NaN()}) {   // [any]
    BandedMatrix a;
    a.resize(20);
    for (int i = 0; i < 20; ++i) a.add(i, i, i == 11 ? diagonal : 1.0);
    std::vector<double> x(20, 1.0);
    EXPECT_FALSE(a.factorAndSolve(x.data())) << diagonal;
  }
  BandedMatrix indefinite;                     // positive diagonal, negative second pivot
  indefinite.resize(2);
  indefinite.add(0, 0, 1.0);
  indefinite.add(0, 1, 2.0);
  indefinite.add(1, 1, 1.0);
  double x[2] = {1.0, 1.0};
  EXPECT_FALSE(indefinite.factorAndSolve(x));
}

}  // namespace
}  // namespace halsted
