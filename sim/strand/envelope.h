#pragma once
/// A symmetric positive definite matrix of 3 x 3 blocks, each row kept from its first block to the diagonal (an envelope), factored
/// as LDL^T without fill outside. Same bits with and without AVX2. Physics thread; no heap.
#include "sim/lane_math.h"

namespace halsted {

/// Whose arrays they are, the caller says; nothing is owned.
struct Envelope {
  int blocks = 0;                              // rows of blocks
  const int* first = nullptr;                  // per block row: its first block
  const int* offset = nullptr;                 // per block row: where its three rows, of equal length, begin in `values`
  double* values = nullptr;                    // [N/m] only the lower triangle is read; factored in place, L below the diagonal
  double* inverse = nullptr;                   // [m/N] of the pivots: 3 a block row
  double* scaled = nullptr;                    // [N/m] work: 12 a block row
};

/// False when a pivot is not positive.
bool factorEnvelope(const Envelope&, LanePath = widestLanes());
/// x := A^-1 x, once factored.
void solveEnvelope(const Envelope&, double* x);   // [N] then [m]

}  // namespace halsted
