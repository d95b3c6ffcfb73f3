#include "sim/strand/banded.h"

namespace halsted {

bool BandedMatrix::factorAndSolve(double* x) {
  double* a = entries_.data();
  for (int j = 0; j < size_; ++j) {
    double* row = a + static_cast<std::size_t>(j) * kStride;
    if (!(row[0] > 0.0)) return false;
    const double inverse = 1.0 / row[0];
    const int last = size_ - 1 - j < kHalf ? size_ - 1 - j : kHalf;
    const double xj = x[j];
    for (int i = 1; i <= last; ++i) {
      if (row[i] == 0.0) continue;
      const double factor = row[i] * inverse;
      double* target = a + static_cast<std::size_t>(j + i) * kStride - i;
      for (int k = i; k <= kHalf; ++k) target[k] -= factor * row[k];
      x[j + i] -= factor * xj;
    }
    row[0] = inverse;
  }
  for (int j = size_ - 1; j >= 0; --j) {
    const double* row = a + static_cast<std::size_t>(j) * kStride;
    const int last = size_ - 1 - j < kHalf ? size_ - 1 - j : kHalf;
    double sum = x[j];
    for (int k = 1; k <= last; ++k) sum -= row[k] * x[j + k];
    x[j] = sum * row[0];
  }
  return true;
}

}  // namespace halsted
