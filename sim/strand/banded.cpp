#include "sim/strand/banded.h"

#include "sim/lane_math.h"
#include "sim/strand/eliminate_row.h"

namespace halsted {
namespace {

constexpr int kStride = BandedMatrix::kStride;

/// Right-hand sides, one or four, in `x` from the row's own on.
template <typename L> HALSTED_INLINE void substituteRow(const double* row, int behind, double* x) {   // [1]
  constexpr int kCount = LaneCount<L>::value;
  L sum = loadLanes<L>(x);
  const int last = reachOf(row, behind);
  for (int k = 1; k <= last; ++k) sum = sum - row[k] * loadLanes<L>(x + kCount * k);
  storeLanes(x, sum * row[0]);
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
  for (int j = size - 1; j >= 0; --j) substituteRow<double>(a + static_cast<std::size_t>(j) * kStride, size - 1 - j, x + j);
  return true;
}

HALSTED_INLINE void againBody(const double* a, int size, double* x) {   // [1]
  for (int j = 0; j < size; ++j) {
    const double* row = a + static_cast<std::size_t>(j) * kStride;
    const Lanes4 scaled = loadLanes<Lanes4>(x + 4 * j) * row[0];
    const int last = reachOf(row, size - 1 - j);
    for (int i = 1; i <= last; ++i) storeLanes(x + 4 * (j + i), loadLanes<Lanes4>(x + 4 * (j + i)) - row[i] * scaled);
  }
  for (int j = size - 1; j >= 0; --j) substituteRow<Lanes4>(a + static_cast<std::size_t>(j) * kStride, size - 1 - j, x + 4 * j);
}

__attribute__((target("avx2"))) bool solveWide(double* a, int size, double* x) { return solveBody(a, size, x); }   // [1]
bool solveNarrow(double* a, int size, double* x) { return solveBody(a, size, x); }                                  // [1]
__attribute__((target("avx2"))) void againWide(const double* a, int size, double* x) { againBody(a, size, x); }     // [1]
void againNarrow(const double* a, int size, double* x) { againBody(a, size, x); }                                   // [1]

}  // namespace

bool BandedMatrix::factorAndSolve(double* x) {
  const bool wide = widestLanes() == LanePath::kWide;   // the bits are the same without
  return wide ? solveWide(entries_.data(), size_, x) : solveNarrow(entries_.data(), size_, x);
}

void BandedMatrix::solveAgain(Lanes4* x) const {
  double* lanes = reinterpret_cast<double*>(x);        // loaded one by one: a vector of Lanes4 need not begin at 32 bytes
  if (widestLanes() == LanePath::kWide) againWide(entries_.data(), size_, lanes);
  else againNarrow(entries_.data(), size_, lanes);
}

}  // namespace halsted
