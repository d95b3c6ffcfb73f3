#pragma once
/// Free stretches of a banded matrix, eliminated in place (LDL^T) between the blocks that stay: the part of CoupledSolve that runs along the
/// thread. Same bits with and without AVX2. Physics thread; no heap.
#include "sim/lane_math.h"
#include "sim/strand/banded.h"

namespace halsted {

/// Block rows, inclusive. Before it stand two blocks that stay, unless it begins the thread.
struct Stretch {
  int first, last;
  bool bordered() const { return first >= 2; }
};

/// The arrays are the caller's; BandedMatrix::kHalf rows of zeros follow the last, also in every x.
struct StretchBand {
  static constexpr int kBorder = 6;            // scalars of the two blocks before a stretch
  double* rows = nullptr;                      // [N/m] of BandedMatrix::kStride, from the diagonal on
  double* border = nullptr;                    // [N/m] kBorder a row: its coupling with the blocks before its stretch
};

/// The trailing updates land in the blocks behind the stretch. False when a pivot is not positive.
bool eliminate(const StretchBand&, const Stretch&, double* x, LanePath = widestLanes());   // [N]
/// The same elimination's effect on the two blocks before the stretch.
void reduceBorder(const StretchBand&, const Stretch&, double* x, LanePath = widestLanes());   // [N]
/// Once the blocks that stay are solved for.
void substitute(const StretchBand&, const Stretch&, double* x);   // [N] then [m]

}  // namespace halsted
