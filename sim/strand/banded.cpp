#include "sim/strand/banded.h"

#include "sim/lane_math.h"
#include "sim/strand/eliminate_row.h"

namespace halsted {
namespace {

constexpr int kStride = BandedMatrix::kStride;

/// From the last row back: a chain of dependent differences, in which what the next row waits for stays in a register.
HALSTED_INLINE void substituteBody(const double* a, int size, double* x) {   // [1]
  double next = 0.0;
  for (int j = size - 1; j >= 0; --j) {
    const double* row = a + static_cast<std::size_t>(j) * kStride;
    const int behind = size - 1 - j;
    double sum = x[j];
    if (behind >= BandedMatrix::kHalf) sum = lessRow(row, x + j, next, sum);
    else for (int k = behind; k > 0; --k) sum -= row[k] * x[j + k];
    x[j] = next = sum * row[0];
  }
}

/// The rows below the last are there too, all zeros.
HALSTED_INLINE bool solveBody(double* a, int size, double* x) {   // [1]
  for (int j = 0; j < size; ++j) {
    double* row = a + static_cast<std::size_t>(j) * kStride;
    if (!(row[0] > 0.0)) return false;
    const double inverse = 1.0 / row[0];
    eliminateColumn<0>(row, nullptr, inverse, x[j], x + j);
    row[0] = inverse;
  }
  substituteBody(a, size, x);
  return true;
}

__attribute__((target("avx2"))) bool solveWide(double* a, int size, double* x) { return solveBody(a, size, x); }   // [1]
bool solveNarrow(double* a, int size, double* x) { return solveBody(a, size, x); }                                  // [1]

}  // namespace

bool BandedMatrix::factorAndSolve(double* x) {
  return widestLanes() == LanePath::kWide ? solveWide(entries_.data(), size_, x) : solveNarrow(entries_.data(), size_, x);   // the same bits
}

}  // namespace halsted
