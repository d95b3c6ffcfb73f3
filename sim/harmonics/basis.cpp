#include "sim/harmonics/basis.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace halsted {

HarmonicTables harmonicTables(int order) {
  if (order < 0 || order > kMaxHarmonicOrder)
    throw std::invalid_argument("harmonic order " + std::to_string(order) + " is outside 0 to " + std::to_string(kMaxHarmonicOrder));
  constexpr double kFourPi = 12.566370614359172954;   // [1]
  HarmonicTables t;
  t.order = order;
  t.first.push_back(1.0 / std::sqrt(kFourPi));
  for (int m = 1; m <= order; ++m)             // m = 1 brings in the sqrt(2) of the real pair
    t.first.push_back(t.first.back() * (m == 1 ? std::sqrt(3.0) : std::sqrt((2.0 * m + 1.0) / (2.0 * m))));
  for (int m = 0; m <= order; ++m)
    for (int l = m; l <= order; ++l) {
      const double ll = l, mm = m, k = l - 1.0;   // [1]
      t.a.push_back(l == m ? 0.0 : std::sqrt((4.0 * ll * ll - 1.0) / (ll * ll - mm * mm)));
      t.b.push_back(l <= m + 1 ? 0.0 : std::sqrt((k * k - mm * mm) / (4.0 * k * k - 1.0)));
    }
  return t;
}

void harmonics(const HarmonicTables& t, const Vec3& unit, std::span<double> values) {
  const double x = unit.x(), y = unit.y(), z = unit.z();   // [1]
  double cosine = 1.0, sine = 0.0;             // [1] C_m, S_m
  for (int m = 0, at = 0; m <= t.order; ++m) {
    double before = 0.0, p = t.first[m];       // [1]
    for (int l = m; l <= t.order; ++l, ++at) {
      if (l > m) {
        const double next = t.a[at] * (z * p - t.b[at] * before);   // [1]
        before = p;
        p = next;
      }
      values[harmonicIndex(l, m)] = p * cosine;
      if (m > 0) values[harmonicIndex(l, -m)] = p * sine;
    }
    const double next = x * cosine - y * sine;   // [1]
    sine = x * sine + y * cosine;
    cosine = next;
  }
}

}  // namespace halsted
