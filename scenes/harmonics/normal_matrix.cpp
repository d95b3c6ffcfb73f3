#include "scenes/harmonics/normal_matrix.h"

#include <algorithm>
#include <cmath>

namespace halsted::scenes {
namespace {

constexpr int kRows = 64;                      // samples at a time: a block of rows stays in the cache

/// gram(i, j) += sum over the block's rows of row(i) row(j), for j <= i; four rows a pass.
void addBlock(const std::vector<double>& rows, int count, int n, std::vector<double>& gram) {   // [1]
  for (int i = 0; i < n; ++i) {
    double* out = &gram[static_cast<std::size_t>(i) * n];    // [1]
    for (int r = 0; r + 4 <= count; r += 4) {
      const double *a = &rows[static_cast<std::size_t>(r) * n], *b = a + n, *c = b + n, *d = c + n;   // [1]
      const double ai = a[i], bi = b[i], ci = c[i], di = d[i];   // [1]
      for (int j = 0; j <= i; ++j) out[j] += (ai * a[j] + bi * b[j]) + (ci * c[j] + di * d[j]);
    }
  }
}

std::vector<double> gramMatrix(const HarmonicTables& tables, const FitSamples& s) {   // [1]
  const int n = harmonicCount(tables.order), count = static_cast<int>(s.unit.size());
  std::vector<double> gram(static_cast<std::size_t>(n) * n, 0.0), rows(static_cast<std::size_t>(kRows) * n);   // [1]
  for (int first = 0; first < count; first += kRows) {
    std::fill(rows.begin(), rows.end(), 0.0);  // rows beyond the last sample count nothing
    for (int r = 0; r < std::min(kRows, count - first); ++r) {
      const std::span<double> row(&rows[static_cast<std::size_t>(r) * n], n);   // [1]
      harmonics(tables, s.unit[first + r], row);
      const double root = std::sqrt(s.weight[first + r]);   // [1]
      for (double& x : row) x *= root;
    }
    addBlock(rows, kRows, n, gram);
  }
  return gram;
}

/// In place, lower triangle; false when a pivot is not safely positive.
bool cholesky(std::vector<double>& a, int n) {   // [1]
  for (int i = 0; i < n; ++i) {
    double* row = &a[static_cast<std::size_t>(i) * n];       // [1]
    const double diagonal = row[i];            // [1]
    for (int j = 0; j <= i; ++j) {
      const double* other = &a[static_cast<std::size_t>(j) * n];   // [1]
      double sum = row[j];                     // [1]
      for (int k = 0; k < j; ++k) sum -= row[k] * other[k];
      if (j < i) row[j] = sum / other[j];
      else if (!(sum > 1e-10 * diagonal)) return false;
      else row[j] = std::sqrt(sum);
    }
  }
  return true;
}

void solveFactor(const std::vector<double>& f, int n, std::vector<double>& x) {   // [1]
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < i; ++k) x[i] -= f[static_cast<std::size_t>(i) * n + k] * x[k];
    x[i] /= f[static_cast<std::size_t>(i) * n + i];
  }
  for (int i = n - 1; i >= 0; --i) {
    x[i] /= f[static_cast<std::size_t>(i) * n + i];
    for (int k = 0; k < i; ++k) x[k] -= f[static_cast<std::size_t>(i) * n + k] * x[i];
  }
}

double normalised(std::vector<double>& x) {    // [1] returns the length it had
  double sum = 0.0;                            // [1]
  for (double v : x) sum += v * v;
  const double length = std::sqrt(sum);        // [1]
  for (double& v : x) v /= length;
  return length;
}

std::vector<double> multiply(const std::vector<double>& gram, int n, const std::vector<double>& x) {   // [1]
  std::vector<double> y(n, 0.0);               // [1]
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) {
      y[i] += gram[static_cast<std::size_t>(i) * n + j] * x[j];
      if (j < i) y[j] += gram[static_cast<std::size_t>(i) * n + j] * x[i];
    }
  return y;
}

/// Largest eigenvalue by powers, smallest by inverse powers; good to a percent, which is what a condition number is read to.
double conditionOf(const std::vector<double>& gram, const std::vector<double>& factor, int n) {   // [1]
  constexpr int kPowers = 60;
  std::vector<double> high(n), low(n);         // [1]
  for (int i = 0; i < n; ++i) high[i] = low[i] = 1.0 + 0.5 * ((i * 7919) % 101) / 101.0;
  double largest = 1.0, smallest = 1.0;        // [1]
  for (int k = 0; k < kPowers; ++k) {
    normalised(high);
    high = multiply(gram, n, high);
    std::vector<double> copy = high;           // [1]
    largest = normalised(copy);
    normalised(low);
    solveFactor(factor, n, low);
    copy = low;
    smallest = 1.0 / normalised(copy);
  }
  return std::sqrt(largest / smallest);
}

}  // namespace

bool factorNormal(const HarmonicTables& tables, const FitSamples& samples, NormalMatrix& matrix) {
  matrix.size = harmonicCount(tables.order);
  const std::vector<double> gram = gramMatrix(tables, samples);   // [1]
  matrix.factor = gram;
  if (!cholesky(matrix.factor, matrix.size)) return false;
  matrix.condition = conditionOf(gram, matrix.factor, matrix.size);
  return true;
}

std::vector<Vec3> normalSide(const HarmonicTables& tables, const FitSamples& s, const std::vector<Vec3>& c) {
  std::vector<double> values(c.size());        // [1]
  std::vector<Vec3> side(c.size(), Vec3::Zero());
  for (std::size_t v = 0; v < s.unit.size(); ++v) {
    harmonics(tables, s.unit[v], values);
    Vec3 gap = s.position[v];                  // [m]
    for (std::size_t i = 0; i < values.size(); ++i) gap -= values[i] * c[i];
    for (std::size_t i = 0; i < values.size(); ++i) side[i] += s.weight[v] * values[i] * gap;
  }
  return side;
}

void solveNormal(const NormalMatrix& matrix, std::vector<Vec3>& side) {
  std::vector<double> x(side.size());          // [m]
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < side.size(); ++i) x[i] = side[i][axis];
    solveFactor(matrix.factor, matrix.size, x);
    for (std::size_t i = 0; i < side.size(); ++i) side[i][axis] = x[i];
  }
}

}  // namespace halsted::scenes
