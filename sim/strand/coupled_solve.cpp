#include "sim/strand/coupled_solve.h"

#include <algorithm>

#include "sim/lanes.h"

namespace halsted {
namespace {

constexpr int kStride = BandedMatrix::kStride, kHalf = BandedMatrix::kHalf;

/// Four partial sums in a fixed order: the same bits on every machine, and no chain of dependent additions.
double dot(const double* a, const double* b, int n) {
  Lanes4 sum{0.0, 0.0, 0.0, 0.0};
  int k = 0;
  for (; k + 4 <= n; k += 4) {
    const Lanes4 x{a[k], a[k + 1], a[k + 2], a[k + 3]}, y{b[k], b[k + 1], b[k + 2], b[k + 3]};
    sum += x * y;
  }
  double total = (sum[0] + sum[1]) + (sum[2] + sum[3]);
  for (; k < n; ++k) total += a[k] * b[k];
  return total;
}

}  // namespace

void CoupledSolve::resize(int threadNodes) {
  nodes_ = threadNodes;
  blocks_ = threadNodes + 2;
  inCore_.assign(blocks_, 0);
  place_.assign(blocks_, -1);
  core_.reserve(kMaxCore + 6);
  first_.reserve(kMaxCore + 6);
  offset_.reserve(kMaxCore + 7);
  pairs_.reserve(8192);
  stretches_.reserve(kMaxCore + 6);
  band_.assign(static_cast<std::size_t>(3 * blocks_ + kHalf) * kStride, 0.0);
  border_.assign(static_cast<std::size_t>(3 * blocks_ + kHalf) * kBorder, 0.0);
  envelope_.assign(kMaxEnvelope, 0.0);
  values_.assign(kMaxEnvelope, 0.0);
  coreX_.assign(3 * (kMaxCore + 6), 0.0);
  scaled_.assign(3 * (kMaxCore + 6), 0.0);
  inverse_.assign(3 * (kMaxCore + 6), 0.0);
}

void CoupledSolve::clearStructure() {
  std::fill(inCore_.begin(), inCore_.end(), 0);
  core_.clear();
  pairs_.clear();
  stretches_.clear();
}

bool CoupledSolve::couple(int nodeA, int nodeB) {
  if (!pairs_.empty() && pairs_.back() == std::pair(nodeA, nodeB)) return true;
  if (pairs_.size() == pairs_.capacity()) return false;
  int fresh = 0;
  for (int k = 0; k < 3; ++k) fresh += (inCore_[nodeA + k] ? 0 : 1) + (inCore_[nodeB + k] ? 0 : 1);
  if (static_cast<int>(core_.size()) + fresh > kMaxCore) return false;
  for (int node : {nodeA, nodeB})
    for (int k = 0; k < 3; ++k) {
      if (!inCore_[node + k]) core_.push_back(node + k);
      inCore_[node + k] = 1;
    }
  pairs_.emplace_back(nodeA, nodeB);
  return true;
}

void CoupledSolve::findStretches() {
  for (int b = 0; b < blocks_;) {
    if (inCore_[b]) { ++b; continue; }
    int last = b;
    while (last + 1 < blocks_ && !inCore_[last + 1]) ++last;
    stretches_.push_back({b, last});
    b = last + 1;
  }
}

void CoupledSolve::extend(int nodeI, int nodeJ) {
  int &a = first_[place_[nodeI]], &b = first_[place_[nodeJ]];
  a = std::min(a, place_[nodeJ]);
  b = std::min(b, place_[nodeI]);
}

/// What each core row couples with to its left: neighbours within the band, the far side of a free stretch, contacts.
void CoupledSolve::boundEnvelope() {
  for (int c = 0; c < coreNodes(); ++c) {
    first_.push_back(c);
    for (int back = 1; back <= 3 && core_[c] - back >= 0; ++back)
      if (inCore_[core_[c] - back]) first_[c] = std::min(first_[c], place_[core_[c] - back]);
  }
  for (const Stretch& s : stretches_) {
    if (s.first < 2 || s.last + 2 >= blocks_) continue;
    for (int i = 1; i <= 2; ++i)
      for (int j = 1; j <= 2; ++j) extend(s.last + i, s.first - j);
  }
  for (const auto& [a, b] : pairs_)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) extend(a + i, b + j);
}

bool CoupledSolve::closeStructure() {
  std::sort(core_.begin(), core_.end());
  std::fill(place_.begin(), place_.end(), -1);
  for (int c = 0; c < coreNodes(); ++c) place_[core_[c]] = c;
  findStretches();
  first_.clear();
  boundEnvelope();
  offset_.assign(1, 0);
  for (int c = 0; c < coreNodes(); ++c) {
    const int next = offset_.back() + 3 * width(c);
    if (next > kMaxEnvelope) return false;
    offset_.push_back(next);
  }
  return true;
}

void CoupledSolve::clearValues() { std::fill(values_.begin(), values_.begin() + offset_.back(), 0.0); }

void CoupledSolve::add(int nodeI, int nodeJ, const Mat3& block) {
  const int i = place_[nodeI], j = place_[nodeJ];
  double* target = &values_[offset_[i]] + 3 * (j - first_[i]);
  const int wide = width(i);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) target[r * wide + c] += block(r, c);
}

void CoupledSolve::copyBand(const BandedMatrix& band) {
  const int size = 3 * blocks_;
  for (int i = 0; i < size; ++i)
    for (int k = 0; k <= kHalf; ++k) band_[static_cast<std::size_t>(i) * kStride + k] = i + k < size ? band.at(i, i + k) : 0.0;
  std::fill(border_.begin(), border_.end(), 0.0);
  for (const Stretch& s : stretches_) {
    if (s.first < 2) continue;
    // Two blocks in general; the last thread nodes couple with both blocks of the needle.
    const int begin = 3 * (s.first - 2), rows = std::min(9, 3 * (s.last - s.first + 1));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < kBorder; ++c) border_[static_cast<std::size_t>(3 * s.first + r) * kBorder + c] = band.at(begin + c, 3 * s.first + r);
  }
}

/// LDL^T along the band for the rows of a free stretch; the trailing updates land in the rows of the core behind it.
bool CoupledSolve::eliminate(const Stretch& s, double* x) {
  const int end = 3 * (s.last + 1), size = 3 * blocks_;
  const bool bordered = s.first >= 2;
  for (int j = 3 * s.first; j < end; ++j) {
    double* row = &band_[static_cast<std::size_t>(j) * kStride];
    if (!(row[0] > 0.0)) return false;
    const double inverse = 1.0 / row[0];
    const int last = std::min(kHalf, size - 1 - j);
    for (int i = 1; i <= last; ++i) {
      if (row[i] == 0.0) continue;
      const double factor = row[i] * inverse;
      double* target = &band_[static_cast<std::size_t>(j + i) * kStride] - i;
      for (int k = i; k <= kHalf; ++k) target[k] -= factor * row[k];
      x[j + i] -= factor * x[j];
      if (!bordered) continue;
      for (int c = 0; c < kBorder; ++c)
        border_[static_cast<std::size_t>(j + i) * kBorder + c] -= factor * border_[static_cast<std::size_t>(j) * kBorder + c];
    }
    row[0] = inverse;
  }
  return true;
}

/// The same elimination's effect on the two core nodes before the stretch.
void CoupledSolve::reduceBorder(const Stretch& s, double* x) {
  if (s.first < 2) return;
  const int begin = 3 * (s.first - 2);
  for (int j = 3 * s.first; j < 3 * (s.last + 1); ++j) {
    const double* border = &border_[static_cast<std::size_t>(j) * kBorder];
    const double inverse = band_[static_cast<std::size_t>(j) * kStride];
    for (int a = 0; a < kBorder; ++a) {
      const double factor = border[a] * inverse;
      x[begin + a] -= factor * x[j];
      for (int b = a; b < kBorder; ++b) band_[static_cast<std::size_t>(begin + a) * kStride + b - a] -= factor * border[b];
    }
  }
}

void CoupledSolve::gatherCore() {
  std::copy(values_.begin(), values_.begin() + offset_.back(), envelope_.begin());
  for (int c = 0; c < coreNodes(); ++c)
    for (int back = 0; back <= 3 && core_[c] - back >= 0; ++back) {
      const int other = core_[c] - back;
      if (!inCore_[other]) continue;
      double* target = row(c) + 3 * (place_[other] - first_[c]);
      for (int r = 0; r < 3; ++r)
        for (int k = 0; k < 3; ++k) {
          const int i = 3 * core_[c] + r, j = 3 * other + k;
          const int low = std::min(i, j), apart = std::max(i, j) - low;
          if (apart <= kHalf) target[r * width(c) + k] += band_[static_cast<std::size_t>(low) * kStride + apart];
        }
    }
  for (const Stretch& s : stretches_) {
    if (s.first < 2 || s.last + 2 >= blocks_) continue;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < kBorder; ++j) {
        const int right = place_[s.last + 1 + i / 3], left = place_[s.first - 2 + j / 3];
        row(right)[(i % 3) * width(right) + 3 * (left - first_[right]) + j % 3] +=
            border_[static_cast<std::size_t>(3 * (s.last + 1) + i) * kBorder + j];
      }
  }
}

/// LDL^T by rows over the envelope: row i of L times the pivots stands in `scaled_` while it is being made.
bool CoupledSolve::factorCore() {
  for (int c = 0; c < coreNodes(); ++c) {
    const int begin = 3 * first_[c], wide = width(c);
    for (int r = 0; r < 3; ++r) {
      double* a = row(c) + r * wide;
      const int i = 3 * c + r;
      for (int j = begin; j < i; ++j) {
        const int blockJ = j / 3, beginJ = 3 * first_[blockJ], from = std::max(begin, beginJ);
        const double* b = row(blockJ) + (j % 3) * width(blockJ) - beginJ;
        scaled_[j] = a[j - begin] - dot(&scaled_[from], b + from, j - from);
      }
      double pivot = a[i - begin];
      for (int j = begin; j < i; ++j) {
        const double l = scaled_[j] * inverse_[j];
        pivot -= l * scaled_[j];
        a[j - begin] = l;
      }
      if (!(pivot > 0.0)) return false;
      inverse_[i] = 1.0 / pivot;
    }
  }
  return true;
}

void CoupledSolve::solveCore(double* x) {
  const int n = 3 * coreNodes();
  for (int i = 0; i < n; ++i) coreX_[i] = x[3 * core_[i / 3] + i % 3];
  for (int i = 0; i < n; ++i) {
    const int begin = 3 * first_[i / 3];
    coreX_[i] -= dot(row(i / 3) + (i % 3) * width(i / 3), &coreX_[begin], i - begin);
  }
  for (int i = 0; i < n; ++i) coreX_[i] *= inverse_[i];
  for (int i = n - 1; i >= 0; --i) {
    const int begin = 3 * first_[i / 3];
    const double* l = row(i / 3) + (i % 3) * width(i / 3);
    for (int j = begin; j < i; ++j) coreX_[j] -= l[j - begin] * coreX_[i];
  }
  for (int i = 0; i < n; ++i) x[3 * core_[i / 3] + i % 3] = coreX_[i];
}

void CoupledSolve::substitute(const Stretch& s, double* x) const {
  const int size = 3 * blocks_;
  for (int j = 3 * (s.last + 1) - 1; j >= 3 * s.first; --j) {
    const double* row = &band_[static_cast<std::size_t>(j) * kStride];
    const double* border = &border_[static_cast<std::size_t>(j) * kBorder];
    const int last = std::min(kHalf, size - 1 - j);
    double sum = x[j];
    for (int k = 1; k <= last; ++k) sum -= row[k] * x[j + k];
    if (s.first >= 2)
      for (int c = 0; c < kBorder; ++c) sum -= border[c] * x[3 * (s.first - 2) + c];
    x[j] = sum * row[0];
  }
}

bool CoupledSolve::solve(const BandedMatrix& band, double* x) {
  copyBand(band);
  for (const Stretch& s : stretches_)
    if (!eliminate(s, x)) return false;
  for (const Stretch& s : stretches_) reduceBorder(s, x);
  gatherCore();
  if (!factorCore()) return false;
  solveCore(x);
  for (const Stretch& s : stretches_) substitute(s, x);
  return true;
}

}  // namespace halsted
