#include "sim/strand/banded.h"

#include "sim/lane_math.h"
#include "sim/strand/eliminate_row.h"

namespace halsted {
namespace {

constexpr int kHalf = BandedMatrix::kHalf, kStride = BandedMatrix::kStride;

/// The rows below the last are there too, all zeros.
HALSTED_INLINE bool solveBody(double* a, int size, double* x) {   // [1]
  for (int j = 0; j < size; ++j) {
    double* row = a + static_cast<std::size_t>(j) * kStride;
    if (!(row[0] > 0.0)) return false;
    const double inverse = 1.0 / row[0];
    eliminateColumn<0>(row, nullptr, inverse, x[j], x + j);
    row[0] = inverse;
  }
  for (int j = size - 1; j >= 0; --j) {
    const double* row = a + static_cast<std::size_t>(j) * kStride;
    const int last = size - 1 - j < kHalf ? size - 1 - j : kHalf;
    double sum = x[j];
    for (int k = 1; k <= last; ++k) sum -= row[k] * x[j + k];
    x[j] = sum * row[0];
  }
  return true;
}

__attribute__((target("avx2"))) bool solveWide(double* a, int size, double* x) { return solveBody(a, size, x); }   // [1]
bool solveNarrow(double* a, int size, double* x) { return solveBody(a, size, x); }                                  // [1]

}  // namespace

bool BandedMatrix::factorAndSolve(double* x) {
  static const bool wide = widestLanes() == LanePath::kWide;   // the bits are the same without
  return wide ? solveWide(entries_.data(), size_, x) : solveNarrow(entries_.data(), size_, x);
}

void BandedMatrix::solveAgain(Lanes4* x) const {
  for (int j = 0; j < size_; ++j) {
    const double* row = &entries_[static_cast<std::size_t>(j) * kStride];
    const Lanes4 scaled = x[j] * row[0];
    const int last = size_ - 1 - j < kHalf ? size_ - 1 - j : kHalf;
    for (int i = 1; i <= last; ++i) x[j + i] -= row[i] * scaled;
  }
  for (int j = size_ - 1; j >= 0; --j) {
    const double* row = &entries_[static_cast<std::size_t>(j) * kStride];
    const int last = size_ - 1 - j < kHalf ? size_ - 1 - j : kHalf;
    Lanes4 sum = x[j];
    for (int k = 1; k <= last; ++k) sum -= row[k] * x[j + k];
    x[j] = sum * row[0];
  }
}

}  // namespace halsted
