#pragma once
/// One column of LDL^T in a band of fixed half width: the step that BandedMatrix and the stretches of CoupledSolve share. Physics thread.
#include <utility>

#include "sim/lanes.h"
#include "sim/strand/banded.h"

namespace halsted {

/// Takes column 0 of `row` out of the row that lies I below it; its length is known to the compiler, which does several at once. `border`:
/// Border more columns of each row, if there are any.
template <int I, int Border> HALSTED_INLINE void eliminateRow(double* row, double* border, double inverse, double xj, double* x) {   // [1]
  if (row[I] == 0.0) return;
  const double factor = row[I] * inverse;      // [1]
  double* target = row + I * BandedMatrix::kStride;   // [N/m]
  for (int k = I; k <= BandedMatrix::kHalf; ++k) target[k - I] -= factor * row[k];
  x[I] -= factor * xj;
  for (int c = 0; c < Border; ++c) border[I * Border + c] -= factor * border[c];
}

template <int Border, int... I>
HALSTED_INLINE void eliminateRows(double* row, double* border, double inverse, double xj, double* x, std::integer_sequence<int, I...>) {   // [1]
  (eliminateRow<I + 1, Border>(row, border, inverse, xj, x), ...);
}

/// Out of all the rows below that it reaches; those behind the last row are there too, all zeros.
template <int Border> HALSTED_INLINE void eliminateColumn(double* row, double* border, double inverse, double xj, double* x) {   // [1]
  eliminateRows<Border>(row, border, inverse, xj, x, std::make_integer_sequence<int, BandedMatrix::kHalf>());
}

}  // namespace halsted
