#pragma once
/// One column of LDL^T in a band of fixed half width: the step that BandedMatrix and the stretches of CoupledSolve share. Physics thread.
#include <utility>

#include "sim/lanes.h"
#include "sim/strand/banded.h"

namespace halsted {

/// A row that goes no farther than bending does, as all but those beside the needle's block.
HALSTED_INLINE bool staysNear(const double* row) {   // [any]
  static_assert(BandedMatrix::kHalf == BandedMatrix::kBending + 3);
  return row[BandedMatrix::kBending + 1] == 0.0 && row[BandedMatrix::kBending + 2] == 0.0 && row[BandedMatrix::kBending + 3] == 0.0;
}

/// Takes column 0 of `row` out of the row that lies I below it; its length is known to the compiler, which does several at once. `border`:
/// Border more columns of each row, if there are any.
template <int I, int Reach, int Border> HALSTED_INLINE void eliminateRow(double* row, double* border, double inverse, double xj, double* x) {   // [1]
  if (row[I] == 0.0) return;
  const double factor = row[I] * inverse;      // [1]
  double* target = row + I * BandedMatrix::kStride;   // [N/m]
  for (int k = I; k <= Reach; ++k) target[k - I] -= factor * row[k];
  x[I] -= factor * xj;
  for (int c = 0; c < Border; ++c) border[I * Border + c] -= factor * border[c];
}

template <int Reach, int Border, int... I>
HALSTED_INLINE void eliminateRows(double* row, double* border, double inverse, double xj, double* x, std::integer_sequence<int, I...>) {   // [1]
  (eliminateRow<I + 1, Reach, Border>(row, border, inverse, xj, x), ...);
}

/// Out of all the rows below that it reaches; those behind the last row are there too, all zeros.
template <int Border> HALSTED_INLINE void eliminateColumn(double* row, double* border, double inverse, double xj, double* x) {   // [1]
  constexpr int kNear = BandedMatrix::kBending, kFar = BandedMatrix::kHalf;
  if (staysNear(row)) eliminateRows<kNear, Border>(row, border, inverse, xj, x, std::make_integer_sequence<int, kNear>());
  else eliminateRows<kFar, Border>(row, border, inverse, xj, x, std::make_integer_sequence<int, kFar>());
}

template <int Reach> HALSTED_INLINE double lessEntries(const double* row, const double* x, double next, double sum) {   // [any]
  for (int k = Reach; k > 1; --k) sum -= row[k] * x[k];
  return sum - row[1] * next;
}

/// `sum` less what the row's entries behind the diagonal take of `x`, which begins at the diagonal. `next` is what stands in the next row of
/// `x`: it is just being made, and is taken last.
HALSTED_INLINE double lessRow(const double* row, const double* x, double next, double sum) {   // [any]
  return staysNear(row) ? lessEntries<BandedMatrix::kBending>(row, x, next, sum) : lessEntries<BandedMatrix::kHalf>(row, x, next, sum);
}

}  // namespace halsted
