#pragma once
/// The normal equations of a harmonic fit, in a fixed order of operations: the same bits on every machine, unlike a library's blocked
/// products, whose order follows the size of the cache.
#include "scenes/harmonics/fit.h"

namespace halsted::scenes {

struct NormalMatrix {
  int size = 0;
  std::vector<double> factor;                  // [1] lower Cholesky factor, rows
  double condition = 0.0;                      // [1] of the weighted matrix itself: the root of that of its normal matrix
};

/// False when the samples leave a combination of coefficients undetermined.
bool factorNormal(const HarmonicTables&, const FitSamples&, NormalMatrix&);

/// A' W (position - A c) for the given coefficients.  [m]
std::vector<Vec3> normalSide(const HarmonicTables&, const FitSamples&, const std::vector<Vec3>& coefficients);

void solveNormal(const NormalMatrix&, std::vector<Vec3>& side);   // in place

}  // namespace halsted::scenes
