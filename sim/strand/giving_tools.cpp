#include "sim/strand/giving_tools.h"

#include <Eigen/Dense>
#include <algorithm>

#include "sim/strand/banded.h"

namespace halsted {
namespace {

constexpr int kBorder = 3 * kHands;            // unknowns
using Border = Eigen::Matrix<double, kBorder, 1>;
using BorderMatrix = Eigen::Matrix<double, kBorder, kBorder>;

/// What is left for the hands when the strand has been eliminated.
void reduce(const ToolBorder& b, const std::vector<double>& x, BorderMatrix& matrix, Border& rhs) {
  for (int h = 0; h < kHands; ++h) {
    if (!b.touched[h]) continue;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Lanes4 c = b.column[h][i];
      if (c[0] == 0.0 && c[1] == 0.0 && c[2] == 0.0) continue;
      for (int r = 0; r < 3; ++r) rhs[3 * h + r] -= c[r] * x[i];
      for (int other = 0; other < kHands; ++other) {
        if (!b.touched[other]) continue;
        const Lanes4 z = b.solved[other][i];
        for (int r = 0; r < 3; ++r)
          for (int k = 0; k < 3; ++k) matrix(3 * h + r, 3 * other + k) -= c[r] * z[k];
      }
    }
  }
}

}  // namespace

void resizeBorder(int unknowns, ToolBorder& b) {
  for (int hand = 0; hand < kHands; ++hand) {
    b.column[hand].assign(unknowns + BandedMatrix::kHalf, zeroLanes<Lanes4>());
    b.solved[hand] = b.column[hand];
  }
}

std::span<Lanes4* const> copyColumns(ToolBorder& b) {
  std::size_t count = 0;
  for (int hand = 0; hand < kHands; ++hand) {
    if (!b.touched[hand]) continue;
    b.solved[hand] = b.column[hand];
    b.toSolve[count++] = b.solved[hand].data();
  }
  return std::span<Lanes4* const>(b.toSolve).first(count);
}

void beginBorder(ToolBorder& b) {
  for (GivingTool& t : b.tool) t.shift = t.correction = Vec3::Zero();
}

void clearBorder(ToolBorder& b) {
  for (int hand = 0; hand < kHands; ++hand) {
    if (b.touched[hand]) std::fill(b.column[hand].begin(), b.column[hand].end(), zeroLanes<Lanes4>());
    b.touched[hand] = false;
    const GivingTool& t = b.tool[hand];
    b.stiffness[hand] = t.spring * Mat3::Identity();
    b.force[hand] = -t.spring * (t.offset + t.shift);
  }
}

void addToBorder(int hand, const CurveWeights& sample, const Vec3& force, const Mat3& stiffness, ToolBorder& b) {
  if (b.tool[hand].spring <= 0.0) return;
  b.touched[hand] = true;
  b.stiffness[hand] += stiffness;
  b.force[hand] -= force;
  for (int a = 0; a < 3; ++a)
    for (int r = 0; r < 3; ++r)
      for (int k = 0; k < 3; ++k) b.column[hand][3 * (sample.node + a) + r][k] -= sample.weight[a] * stiffness(r, k);
}

void moveHands(ToolBorder& b, std::vector<double>& x) {
  BorderMatrix matrix = BorderMatrix::Identity();
  Border rhs = Border::Zero();
  for (int h = 0; h < kHands; ++h) {
    if (b.tool[h].spring <= 0.0) continue;
    matrix.block<3, 3>(3 * h, 3 * h) = b.stiffness[h];
    rhs.segment<3>(3 * h) = b.force[h];
  }
  reduce(b, x, matrix, rhs);
  const Border moved = matrix.ldlt().solve(rhs);   // [m]
  b.moved = 0.0;
  for (int h = 0; h < kHands; ++h) {
    b.tool[h].correction = moved.segment<3>(3 * h);
    if (!b.touched[h]) continue;
    b.moved = std::max(b.moved, moved.segment<3>(3 * h).norm());
    for (std::size_t i = 0; i < x.size(); ++i)
      for (int k = 0; k < 3; ++k) x[i] -= b.solved[h][i][k] * moved[3 * h + k];
  }
}

void shiftHands(double share, ToolBorder& b) {   // [1]
  for (GivingTool& t : b.tool) t.shift += share * t.correction;
}

void settleBorder(ToolBorder& b) {
  for (GivingTool& t : b.tool) {
    t.offset += t.shift;
    t.shift.setZero();
  }
}

}  // namespace halsted
