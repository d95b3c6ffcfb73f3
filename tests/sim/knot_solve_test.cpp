/// The direct solve of a band with couplings between far-apart nodes, against a dense solve of the same matrix.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "sim/strand/coupled_solve.h"

namespace halsted {
namespace {

struct Problem {
  int nodes;
  BandedMatrix band;
  CoupledSolve coupled;
  Eigen::MatrixXd dense;
  std::mt19937 random{7};

  explicit Problem(int n) : nodes(n), dense(Eigen::MatrixXd::Zero(3 * n + 6, 3 * n + 6)) {
    band.resize(3 * n + 6);
    band.setZero();
    coupled.resize(n);
    coupled.clearStructure();
    // A band like the strand's: nodes two apart, the needle with the last two.
    for (int b = 0; b < n; ++b) spread(3 * b, b + 2 < n ? 9 : 3 * (n - b) + 6);
  }
  double number() { return std::uniform_real_distribution<>(-1.0, 1.0)(random); }
  /// Adds v v^T over a window: positive definite, within the band.
  void spread(int begin, int wide) {
    const int size = 3 * nodes + 6;
    wide = std::min({wide, size - begin, 12});
    for (int k = 0; k < 4; ++k) {
      Eigen::VectorXd v(wide);
      for (int i = 0; i < wide; ++i) v[i] = number();
      for (int i = 0; i < wide; ++i) {
        band.add(begin + i, begin + i, 0.3);
        dense(begin + i, begin + i) += 0.3;
        for (int j = 0; j < wide; ++j) {
          if (j >= i) band.add(begin + i, begin + j, v[i] * v[j]);
          dense(begin + i, begin + j) += v[i] * v[j];
        }
      }
    }
  }
  /// A spring between two groups of three nodes.
  void spring(int a, int b) {
    const double w[3] = {0.2, 0.7, 0.1};
    const Mat3 k = 5.0 * (Mat3::Identity() + Vec3(1, 2, 3) * Vec3(1, 2, 3).transpose());
    const int node[6] = {a, a + 1, a + 2, b, b + 1, b + 2};
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j) {
        const double c = (i < 3 ? w[i] : -w[i - 3]) * (j < 3 ? w[j] : -w[j - 3]);
        dense.block<3, 3>(3 * node[i], 3 * node[j]) += c * k;
        if (i >= j) coupled.add(node[i], node[j], c * k);
      }
  }
  double worstError(const std::vector<std::pair<int, int>>& pairs) {
    for (const auto& [a, b] : pairs) EXPECT_TRUE(coupled.couple(a, b));
    EXPECT_TRUE(coupled.closeStructure());
    coupled.clearValues();
    for (const auto& [a, b] : pairs) spring(a, b);
    Eigen::VectorXd rhs(3 * nodes + 6);
    for (int i = 0; i < rhs.size(); ++i) rhs[i] = number();
    const Eigen::VectorXd exact = dense.ldlt().solve(rhs);
    Eigen::VectorXd alone = rhs;
    BandedMatrix used = band;
    EXPECT_TRUE(coupled.solve(used, alone.data()));
    double worst = (alone - exact).lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>();   // [1]
    for (int columns : {1, 2}) worst = std::max(worst, worstOfMore(columns, rhs, alone));
    return worst;
  }
  /// The same with three more right-hand sides in each of `columns`; what x is does not depend on these.
  double worstOfMore(int columns, Eigen::VectorXd rhs, const Eigen::VectorXd& alone) {   // [N], [m]
    Eigen::MatrixXd more(rhs.size(), 3 * columns);
    std::vector<std::vector<Lanes4>> column(columns, std::vector<Lanes4>(rhs.size() + BandedMatrix::kHalf, Lanes4{0.0, 0.0, 0.0, 0.0}));
    for (int i = 0; i < more.rows(); ++i)
      for (int k = 0; k < more.cols(); ++k) column[k / 3][i][k % 3] = more(i, k) = number();
    const Eigen::MatrixXd exact = dense.ldlt().solve(more);
    std::vector<Lanes4*> pointers;
    for (auto& c : column) pointers.push_back(c.data());
    BandedMatrix used = band;
    EXPECT_TRUE(coupled.solve(used, rhs.data(), pointers));
    EXPECT_EQ(rhs, alone) << "to the bit";
    double worst = 0.0;                        // [1]
    for (int i = 0; i < more.rows(); ++i)
      for (int k = 0; k < more.cols(); ++k) worst = std::max(worst, std::fabs(column[k / 3][i][k % 3] - exact(i, k)));
    return worst / exact.lpNorm<Eigen::Infinity>();
  }
};

TEST(CoupledSolve, IsTheDenseSolve) {
  EXPECT_LT(Problem(60).worstError({{5, 40}, {6, 39}, {20, 50}}), 1e-10);
}
TEST(CoupledSolve, TakesContactsAtBothEndsOfTheThread) { EXPECT_LT(Problem(40).worstError({{0, 37}, {10, 18}}), 1e-10); }
TEST(CoupledSolve, TakesFreeStretchesOfOneAndTwoNodes) { EXPECT_LT(Problem(40).worstError({{3, 7}, {12, 15}, {20, 36}}), 1e-10); }
TEST(CoupledSolve, TakesACoreWithoutAnyFreeNode) { EXPECT_LT(Problem(9).worstError({{0, 3}, {0, 6}, {3, 6}}), 1e-10); }

TEST(CoupledSolve, TakesStrandsThatLieAlongEachOther) {
  std::vector<std::pair<int, int>> pairs;
  for (int k = 0; k < 15; ++k) pairs.emplace_back(4 + k, 50 - k);
  EXPECT_LT(Problem(60).worstError(pairs), 1e-9);
}

TEST(CoupledSolve, RefusesMoreThanItsRoom) {
  CoupledSolve solve;
  solve.resize(2000);
  solve.clearStructure();
  bool accepted = true;
  for (int k = 0; k < 300 && accepted; ++k) accepted = solve.couple(3 * k, 1000 + 3 * k);
  EXPECT_FALSE(accepted);
  EXPECT_LE(solve.coreNodes(), CoupledSolve::kMaxCore);
}

}  // namespace
}  // namespace halsted
