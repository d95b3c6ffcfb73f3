#include "sim/strand/coupled_solve.h"

#include <algorithm>

namespace halsted {
namespace {

constexpr int kStride = BandedMatrix::kStride, kHalf = BandedMatrix::kHalf, kBorder = StretchBand::kBorder;

}  // namespace

void CoupledSolve::resize(int threadNodes) {
  blocks_ = threadNodes + 2;
  inCore_.assign(blocks_ + kHands, 0);
  place_.assign(blocks_ + kHands, -1);
  core_.reserve(kMaxCore + 6);
  first_.reserve(kMaxCore + 6);
  offset_.reserve(kMaxCore + 7);
  graph_.assign(static_cast<std::size_t>(kMaxCore) * kMaxCore, 0);
  degree_.reserve(kMaxCore);
  order_.reserve(kMaxCore);
  pairs_.reserve(kMaxPairs);
  handPairs_.reserve(kMaxPairs);
  stretches_.reserve(kMaxCore + 6);
  border_.assign(static_cast<std::size_t>(3 * blocks_ + kHalf) * kBorder, 0.0);
  envelope_.assign(kMaxEnvelope, 0.0);
  values_.assign(kMaxEnvelope, 0.0);
  x_.assign(3 * blocks_ + kHalf, 0.0);
  coreX_.assign(3 * (kMaxCore + 6), 0.0);
  scaled_.assign(12 * (kMaxCore + 6), 0.0);
  inverse_.assign(3 * (kMaxCore + 6), 0.0);
}

void CoupledSolve::clearValues() { std::fill(values_.begin(), values_.begin() + offset_.back(), 0.0); }

/// Where the block of rows of node i and columns of node j stands among the envelope's entries, if the rows come later; else it stands there
/// transposed.
CoupledSolve::CoreBlock CoupledSolve::coreBlock(std::vector<double>& entries, int nodeI, int nodeJ) const {   // [N/m]
  const int i = place_[nodeI], j = place_[nodeJ], late = std::max(i, j), early = std::min(i, j);
  double* begin = &entries[offset_[late]] + 3 * (early - first_[late]);
  return i == late ? CoreBlock{begin, width(late), 1} : CoreBlock{begin, 1, width(late)};
}

void CoupledSolve::add(int nodeI, int nodeJ, const Mat3& block) {
  const CoreBlock target = coreBlock(values_, nodeI, nodeJ);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) target.at(r, c) += block(r, c);
}

StretchBand CoupledSolve::beginBorders(BandedMatrix& band) {
  std::fill(border_.begin(), border_.end(), 0.0);
  for (const Stretch& s : stretches_) {
    if (s.first < 2) continue;
    // Two blocks in general; the last thread nodes couple with both blocks of the needle.
    const int begin = 3 * (s.first - 2), rows = std::min(9, 3 * (s.last - s.first + 1));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < kBorder; ++c) border_[static_cast<std::size_t>(3 * s.first + r) * kBorder + c] = band.at(begin + c, 3 * s.first + r);
  }
  return {band.rows(), border_.data()};
}

void CoupledSolve::gatherCore(const StretchBand& band) {
  constexpr int kReach = kHalf / 3;            // blocks
  std::copy(values_.begin(), values_.begin() + offset_.back(), envelope_.begin());
  for (int node : core_)
    for (int next = node; next <= std::min(node + kReach, blocks_ - 1); ++next) {
      if (!inCore_[next]) continue;
      const CoreBlock block = coreBlock(envelope_, next, node);
      for (int c = 0; c < 3; ++c)              // within a block only the lower triangle is read
        for (int r = next == node ? c : 0; r < 3; ++r)
          if (const int k = 3 * (next - node) + r - c; k <= kHalf) block.at(r, c) += band.rows[static_cast<std::size_t>(3 * node + c) * kStride + k];
    }
  for (const Stretch& s : stretches_) {
    if (s.first < 2 || s.last + 2 >= blocks_) continue;
    for (int after : {s.last + 1, s.last + 2})
      for (int before : {s.first - 2, s.first - 1}) {
        const CoreBlock block = coreBlock(envelope_, after, before);
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 3; ++c) block.at(r, c) += band.border[static_cast<std::size_t>(3 * after + r) * kBorder + 3 * (before - s.first + 2) + c];
      }
  }
}

Envelope CoupledSolve::core() { return {coreNodes(), first_.data(), offset_.data(), envelope_.data(), inverse_.data(), scaled_.data()}; }

void CoupledSolve::solveCore(double* x, double* hands) {   // [N] then [m]
  const auto rows = [&](int block) { return block < blocks_ ? x + 3 * block : hands + 3 * (block - blocks_); };
  const int n = coreNodes();
  for (int i = 0; i < n; ++i) std::copy_n(rows(core_[i]), 3, &coreX_[3 * i]);
  solveEnvelope(core(), coreX_.data());
  for (int i = 0; i < n; ++i) std::copy_n(&coreX_[3 * i], 3, rows(core_[i]));
}

bool CoupledSolve::solve(BandedMatrix& matrix, double* x) {   // [N] then [m]
  const int size = 3 * blocks_;
  double* padded = x_.data();                  // [N] then [m]
  std::copy(x, x + size, padded);
  std::fill(padded + size, padded + size + kHalf, 0.0);
  const StretchBand band = beginBorders(matrix);
  for (const Stretch& s : stretches_)
    if (!eliminate(band, s, padded)) return false;
  for (const Stretch& s : stretches_) reduceBorder(band, s, padded);
  gatherCore(band);
  if (!factorEnvelope(core())) return false;
  solveCore(padded, x + size);
  for (const Stretch& s : stretches_) substitute(band, s, padded);
  std::copy(padded, padded + size, x);
  return true;
}

}  // namespace halsted
