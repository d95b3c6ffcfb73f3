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

  explicit Problem(int n) : nodes(n), dense(Eigen::MatrixXd::Zero(3 * n + 6 + 3 * kHands, 3 * n + 6 + 3 * kHands)) {
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
  /// Between a hand and three nodes.
  void handSpring(int hand, int node) {
    const int block = coupled.handBlock(hand), at = 3 * (nodes + 2 + hand);
    const Mat3 k = 4.0 * (Mat3::Identity() + Vec3(3, 1, 2) * Vec3(3, 1, 2).transpose());
    const double w[3] = {0.3, 0.6, 0.1};       // [1]
    dense.block<3, 3>(at, at) += k;
    coupled.add(block, block, k);
    for (int i = 0; i < 3; ++i) {
      dense.block<3, 3>(at, 3 * (node + i)) -= w[i] * k;
      dense.block<3, 3>(3 * (node + i), at) -= w[i] * k;
      coupled.add(block, node + i, -w[i] * k);
      for (int j = 0; j < 3; ++j) {
        dense.block<3, 3>(3 * (node + i), 3 * (node + j)) += w[i] * w[j] * k;
        if (i >= j) coupled.add(node + i, node + j, w[i] * w[j] * k);
      }
    }
  }
  /// `hands`: a hand and the first of the nodes that it touches.
  double worstError(const std::vector<std::pair<int, int>>& pairs, const std::vector<std::pair<int, int>>& hands = {}) {
    for (const auto& [a, b] : pairs) EXPECT_TRUE(coupled.couple(a, b));
    for (const auto& [hand, node] : hands) EXPECT_TRUE(coupled.coupleHand(hand, node));
    EXPECT_TRUE(coupled.closeStructure());
    coupled.clearValues();
    for (const auto& [a, b] : pairs) spring(a, b);
    for (const auto& [hand, node] : hands) handSpring(hand, node);
    for (int hand = 0; hand < kHands; ++hand) {
      dense.block<3, 3>(3 * (nodes + 2 + hand), 3 * (nodes + 2 + hand)) += Mat3::Identity();   // its own spring
      if (coupled.holdsHand(hand)) coupled.add(coupled.handBlock(hand), coupled.handBlock(hand), Mat3::Identity());
    }
    Eigen::VectorXd rhs(dense.rows());
    for (int i = 0; i < rhs.size(); ++i) rhs[i] = number();
    const Eigen::VectorXd exact = dense.ldlt().solve(rhs);
    Eigen::VectorXd alone = rhs;
    BandedMatrix used = band;
    EXPECT_TRUE(coupled.solve(used, alone.data()));
    return (alone - exact).lpNorm<Eigen::Infinity>() / exact.lpNorm<Eigen::Infinity>();
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

TEST(CoupledSolve, TakesHandsThatLieAgainstTheThread) {
  EXPECT_LT(Problem(60).worstError({{5, 40}, {6, 39}, {20, 50}}, {{0, 5}, {0, 12}, {1, 30}}), 1e-10);
  EXPECT_LT(Problem(40).worstError({{3, 30}}, {{0, 10}, {1, 10}, {1, 11}, {0, 37}}), 1e-10) << "both against one place, and at the end";
}
TEST(CoupledSolve, TakesAHandAloneAndLeavesTheOther) { EXPECT_LT(Problem(40).worstError({}, {{1, 20}, {1, 21}}), 1e-10); }

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
