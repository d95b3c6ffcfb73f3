#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "sim/strand/knot_diagram.h"

namespace halsted {
namespace {

constexpr long long kPrime = 2147483629;       // arithmetic modulo a prime: no rounding; determinants of interest are far smaller

long long power(long long base, long long exponent) {
  long long result = 1;
  for (base %= kPrime; exponent > 0; exponent /= 2, base = base * base % kPrime)
    if (exponent % 2) result = result * base % kPrime;
  return result;
}

/// Determinant modulo kPrime of an n x n matrix in rows.
long long determinantOf(std::vector<long long>& a, int n) {
  long long det = 1;
  for (int c = 0; c < n; ++c) {
    int pivot = c;
    while (pivot < n && a[pivot * n + c] == 0) ++pivot;
    if (pivot == n) return 0;
    if (pivot != c) {
      for (int k = 0; k < n; ++k) std::swap(a[pivot * n + k], a[c * n + k]);
      det = (kPrime - det) % kPrime;
    }
    det = det * a[c * n + c] % kPrime;
    const long long inverse = power(a[c * n + c], kPrime - 2);
    for (int r = c + 1; r < n; ++r) {
      const long long factor = a[r * n + c] * inverse % kPrime;
      for (int k = c; k < n && factor; ++k) a[r * n + k] = (a[r * n + k] + (kPrime - factor) * a[c * n + k]) % kPrime;
    }
  }
  return det;
}

}  // namespace

/// Fox's colouring matrix: at each crossing twice the arc above equals the sum of the two arcs below.
long long knotDeterminant(const KnotDiagram& d) {
  const int n = d.crossings();
  if (n == 0) return 1;
  if (n > 60) return 0;
  std::vector<int> name(d.sign.size(), -1), over(n, 0), in(n, 0), out(n, 0);
  int arc = 0, next = 0;
  for (const CrossingVisit& v : d.code) {
    if (name[v.crossing] < 0) name[v.crossing] = next++;
    const int c = name[v.crossing];
    if (v.over) { over[c] = arc; continue; }
    in[c] = arc;
    arc = (arc + 1) % n;                       // the last arc leads over infinity into the first
    out[c] = arc;
  }
  const int m = n - 1;
  std::vector<long long> a(static_cast<std::size_t>(m) * m + 1, 0);
  const auto put = [&](int row, int column, long long value) {
    if (row < m && column < m) a[row * m + column] = (a[row * m + column] + value + kPrime) % kPrime;
  };
  for (int c = 0; c < n; ++c) {
    put(c, over[c], 2);
    put(c, in[c], -1);
    put(c, out[c], -1);
  }
  const long long det = determinantOf(a, m);
  return std::min(det, kPrime - det);
}

}  // namespace halsted
