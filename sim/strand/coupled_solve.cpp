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

Lanes4 dot(const double* a, const Lanes4* b, int n) {
  Lanes4 sum{0.0, 0.0, 0.0, 0.0};
  for (int k = 0; k < n; ++k) sum += a[k] * b[k];
  return sum;
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
  graph_.assign(static_cast<std::size_t>(kMaxCore) * kMaxCore, 0);
  degree_.reserve(kMaxCore);
  order_.reserve(kMaxCore);
  pairs_.reserve(kMaxPairs);
  stretches_.reserve(kMaxCore + 6);
  band_.assign(static_cast<std::size_t>(3 * blocks_ + kHalf) * kStride, 0.0);
  border_.assign(static_cast<std::size_t>(3 * blocks_ + kHalf) * kBorder, 0.0);
  envelope_.assign(kMaxEnvelope, 0.0);
  values_.assign(kMaxEnvelope, 0.0);
  coreX_.assign(3 * (kMaxCore + 6), 0.0);
  coreAgain_.assign(3 * (kMaxCore + 6), Lanes4{0.0, 0.0, 0.0, 0.0});
  scaled_.assign(3 * (kMaxCore + 6), 0.0);
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

template <typename T> void CoupledSolve::solveCore(T* x, std::vector<T>& core) {
  const int n = 3 * coreNodes();
  for (int i = 0; i < n; ++i) core[i] = x[3 * core_[i / 3] + i % 3];
  for (int i = 0; i < n; ++i) {
    const int begin = 3 * first_[i / 3];
    core[i] -= dot(row(i / 3) + (i % 3) * width(i / 3), &core[begin], i - begin);
  }
  for (int i = 0; i < n; ++i) core[i] *= inverse_[i];
  for (int i = n - 1; i >= 0; --i) {
    const int begin = 3 * first_[i / 3];
    const double* l = row(i / 3) + (i % 3) * width(i / 3);
    for (int j = begin; j < i; ++j) core[j] -= l[j - begin] * core[i];
  }
  for (int i = 0; i < n; ++i) x[3 * core_[i / 3] + i % 3] = core[i];
}

template <typename T> void CoupledSolve::substitute(const Stretch& s, T* x) const {
  const int size = 3 * blocks_;
  for (int j = 3 * (s.last + 1) - 1; j >= 3 * s.first; --j) {
    const double* row = &band_[static_cast<std::size_t>(j) * kStride];
    const double* border = &border_[static_cast<std::size_t>(j) * kBorder];
    const int last = std::min(kHalf, size - 1 - j);
    T sum = x[j];
    for (int k = 1; k <= last; ++k) sum -= row[k] * x[j + k];
    if (s.first >= 2)
      for (int c = 0; c < kBorder; ++c) sum -= border[c] * x[3 * (s.first - 2) + c];
    x[j] = sum * row[0];
  }
}

/// What `eliminate` and `reduceBorder` do to a right-hand side.
void CoupledSolve::forward(const Stretch& s, Lanes4* x) const {
  const int size = 3 * blocks_;
  for (int j = 3 * s.first; j < 3 * (s.last + 1); ++j) {
    const double* row = &band_[static_cast<std::size_t>(j) * kStride];
    const double* border = &border_[static_cast<std::size_t>(j) * kBorder];
    const Lanes4 scaled = x[j] * row[0];
    for (int i = 1; i <= std::min(kHalf, size - 1 - j); ++i) x[j + i] -= row[i] * scaled;
    if (s.first >= 2)
      for (int c = 0; c < kBorder; ++c) x[3 * (s.first - 2) + c] -= border[c] * scaled;
  }
}

bool CoupledSolve::solve(const BandedMatrix& band, double* x) {
  copyBand(band);
  for (const Stretch& s : stretches_)
    if (!eliminate(s, x)) return false;
  for (const Stretch& s : stretches_) reduceBorder(s, x);
  gatherCore();
  if (!factorCore()) return false;
  solveCore(x, coreX_);
  for (const Stretch& s : stretches_) substitute(s, x);
  return true;
}

void CoupledSolve::solveAgain(Lanes4* x) {
  for (const Stretch& s : stretches_) forward(s, x);
  solveCore(x, coreAgain_);
  for (const Stretch& s : stretches_) substitute(s, x);
}

}  // namespace halsted
