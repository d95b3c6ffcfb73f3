#include "sim/strand/coupled_solve.h"

#include <algorithm>

#include "sim/lanes.h"

namespace halsted {
namespace {

constexpr int kStride = BandedMatrix::kStride, kHalf = BandedMatrix::kHalf, kBorder = StretchBand::kBorder;

}  // namespace

void CoupledSolve::resize(int threadNodes) {
  nodes_ = threadNodes;
  blocks_ = threadNodes + 2;
  inCore_.assign(blocks_, 0);
  place_.assign(blocks_, -1);
  core_.reserve(kMaxCore + 6);
  first_.reserve(kMaxCore + 6);
  offset_.reserve(kMaxCore + 7);
  graph_.assign(static_cast<std::size_t>(kMaxCore) * kMaxCore, 0);
  degree_.reserve(kMaxCore);
  order_.reserve(kMaxCore);
  pairs_.reserve(kMaxPairs);
  stretches_.reserve(kMaxCore + 6);
  band_.assign(static_cast<std::size_t>(3 * blocks_ + kHalf) * kStride, 0.0);
  border_.assign(static_cast<std::size_t>(3 * blocks_ + kHalf) * kBorder, 0.0);
  envelope_.assign(kMaxEnvelope, 0.0);
  values_.assign(kMaxEnvelope, 0.0);
  x_.assign(4 * static_cast<std::size_t>(3 * blocks_ + kHalf), 0.0);
  coreX_.assign(12 * (kMaxCore + 6), 0.0);
  scaled_.assign(9 * (kMaxCore + 6), 0.0);
  inverse_.assign(3 * (kMaxCore + 6), 0.0);
}

void CoupledSolve::clearValues() { std::fill(values_.begin(), values_.begin() + offset_.back(), 0.0); }

void CoupledSolve::add(int nodeI, int nodeJ, const Mat3& block) {
  const int i = std::max(place_[nodeI], place_[nodeJ]), j = std::min(place_[nodeI], place_[nodeJ]);
  double* target = &values_[offset_[i]] + 3 * (j - first_[i]);
  const int wide = width(i);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) target[r * wide + c] += block(r, c);
}

void CoupledSolve::copyBand(const BandedMatrix& band) {
  std::copy(band.rows().begin(), band.rows().end(), band_.begin());
  std::fill(border_.begin(), border_.end(), 0.0);
  for (const Stretch& s : stretches_) {
    if (s.first < 2) continue;
    // Two blocks in general; the last thread nodes couple with both blocks of the needle.
    const int begin = 3 * (s.first - 2), rows = std::min(9, 3 * (s.last - s.first + 1));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < kBorder; ++c) border_[static_cast<std::size_t>(3 * s.first + r) * kBorder + c] = band.at(begin + c, 3 * s.first + r);
  }
}

/// Adds the scalar that couples rows i and j of the strand, both in the core.
void CoupledSolve::addCore(int i, int j, double value) {
  const int a = std::max(place_[i / 3], place_[j / 3]), b = std::min(place_[i / 3], place_[j / 3]);
  const int ra = place_[i / 3] == a ? i % 3 : j % 3, rb = place_[i / 3] == a ? j % 3 : i % 3;
  row(a)[ra * width(a) + 3 * (b - first_[a]) + rb] += value;
}

void CoupledSolve::gatherCore() {
  std::copy(values_.begin(), values_.begin() + offset_.back(), envelope_.begin());
  for (int node : core_)
    for (int i = 3 * node; i < 3 * node + 3; ++i)
      for (int k = 0; k <= kHalf && i + k < 3 * blocks_; ++k) {
        if (!inCore_[(i + k) / 3]) continue;
        const double value = band_[static_cast<std::size_t>(i) * kStride + k];   // [N/m]
        addCore(i + k, i, value);              // within a block only the lower triangle is read
      }
  for (const Stretch& s : stretches_) {
    if (s.first < 2 || s.last + 2 >= blocks_) continue;
    for (int i = 3 * (s.last + 1); i < 3 * (s.last + 1) + 6; ++i)
      for (int j = 0; j < kBorder; ++j) addCore(i, 3 * (s.first - 2) + j, border_[static_cast<std::size_t>(i) * kBorder + j]);
  }
}

StretchBand CoupledSolve::stretchBand() { return {band_.data(), border_.data()}; }

Envelope CoupledSolve::core() { return {coreNodes(), first_.data(), offset_.data(), envelope_.data(), inverse_.data(), scaled_.data()}; }

void CoupledSolve::solveCore(double* x) {
  const int n = 3 * coreNodes();
  for (int i = 0; i < n; ++i) coreX_[i] = x[3 * core_[i / 3] + i % 3];
  solveEnvelope(core(), coreX_.data());
  for (int i = 0; i < n; ++i) x[3 * core_[i / 3] + i % 3] = coreX_[i];
}

void CoupledSolve::solveCoreFour(double* x) {
  const int n = 3 * coreNodes();
  for (int i = 0; i < n; ++i) std::copy_n(x + 4 * (3 * core_[i / 3] + i % 3), 4, &coreX_[4 * i]);
  solveEnvelopeFour(core(), coreX_.data());
  for (int i = 0; i < n; ++i) std::copy_n(&coreX_[4 * i], 4, x + 4 * (3 * core_[i / 3] + i % 3));
}

bool CoupledSolve::solve(const BandedMatrix& band, double* x) {
  const int size = 3 * blocks_;
  double* padded = x_.data();                  // [N] then [m]
  std::copy(x, x + size, padded);
  std::fill(padded + size, padded + size + kHalf, 0.0);
  copyBand(band);
  for (const Stretch& s : stretches_)
    if (!eliminate(stretchBand(), s, padded)) return false;
  for (const Stretch& s : stretches_) reduceBorder(stretchBand(), s, padded);
  gatherCore();
  if (!factorEnvelope(core())) return false;
  solveCore(padded);
  for (const Stretch& s : stretches_) substitute(stretchBand(), s, padded);
  std::copy(padded, padded + size, x);
  return true;
}

void CoupledSolve::solveAgain(Lanes4* x) {
  const int size = 3 * blocks_;
  double* padded = x_.data();                  // [N] then [m], rows of four
  for (int i = 0; i < size; ++i) storeLanes(padded + 4 * i, x[i]);
  std::fill(padded + 4 * size, padded + 4 * (size + kHalf), 0.0);
  for (const Stretch& s : stretches_) forwardFour(stretchBand(), s, padded);
  solveCoreFour(padded);
  for (const Stretch& s : stretches_) substituteFour(stretchBand(), s, padded);
  for (int i = 0; i < size; ++i) x[i] = loadLanes<Lanes4>(padded + 4 * i);
}

}  // namespace halsted
