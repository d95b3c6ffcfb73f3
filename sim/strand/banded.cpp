#include "sim/strand/banded.h"

#include "sim/lane_math.h"
#include "sim/strand/eliminate_row.h"

namespace halsted {
namespace {

constexpr int kStride = BandedMatrix::kStride;

/// Right-hand sides, one or four, from the last row back. What the next row waits for stays in a register.
template <typename L> HALSTED_INLINE void substituteBody(const double* a, int size, double* x) {   // [1]
  constexpr int kCount = LaneCount<L>::value;
  L next = zeroLanes<L>();
  for (int j = size - 1; j >= 0; --j) {
    const double* row = a + static_cast<std::size_t>(j) * kStride;
    double* own = x + kCount * j;
    const int behind = size - 1 - j;
    L sum = loadLanes<L>(own);
    if (behind >= BandedMatrix::kHalf) sum = lessRow(row, own, next, sum);
    else for (int k = 1; k <= behind; ++k) sum = sum - row[k] * loadLanes<L>(own + kCount * k);
    next = sum * row[0];
    storeLanes(own, next);
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
  substituteBody<double>(a, size, x);
  return true;
}

HALSTED_INLINE void againBody(const double* a, int size, double* x) {   // [1]
  for (int j = 0; j < size; ++j) {
    const double* row = a + static_cast<std::size_t>(j) * kStride;
    const Lanes4 scaled = loadLanes<Lanes4>(x + 4 * j) * row[0];
    const int last = reachOf(row, size - 1 - j);
    for (int i = 1; i <= last; ++i) storeLanes(x + 4 * (j + i), loadLanes<Lanes4>(x + 4 * (j + i)) - row[i] * scaled);
  }
  substituteBody<Lanes4>(a, size, x);
}

__attribute__((target("avx2"))) bool solveWide(double* a, int size, double* x) { return solveBody(a, size, x); }   // [1]
bool solveNarrow(double* a, int size, double* x) { return solveBody(a, size, x); }                                  // [1]
__attribute__((target("avx2"))) void againWide(const double* a, int size, double* x) { againBody(a, size, x); }     // [1]
void againNarrow(const double* a, int size, double* x) { againBody(a, size, x); }                                   // [1]

}  // namespace

bool BandedMatrix::factorAndSolve(double* x, std::span<Lanes4* const> more) {
  const bool wide = widestLanes() == LanePath::kWide;   // the bits are the same without
  if (!(wide ? solveWide(entries_.data(), size_, x) : solveNarrow(entries_.data(), size_, x))) return false;
  for (Lanes4* four : more) solveAgain(four);
  return true;
}

void BandedMatrix::solveAgain(Lanes4* x) const {
  double* lanes = reinterpret_cast<double*>(x);        // loaded one by one: a vector of Lanes4 need not begin at 32 bytes
  if (widestLanes() == LanePath::kWide) againWide(entries_.data(), size_, lanes);
  else againNarrow(entries_.data(), size_, lanes);
}

}  // namespace halsted
