/// Laws S1, S2 and S4 of the harmonic basis.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "sim/harmonics/basis.h"
#include "sim/portable_math.h"

namespace halsted {
namespace {

struct Rule { std::vector<double> node, weight; };   // [1]

/// Gauss-Legendre on [-1, 1], by Newton on the Legendre recurrence.
Rule gaussLegendre(int n) {
  Rule rule;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(kPi * (i + 0.75) / (n + 0.5)), slope = 0.0;   // [1]
    for (int k = 0; k < 50; ++k) {
      double p = 1.0, before = 0.0;            // [1]
      for (int l = 1; l <= n; ++l) { const double next = ((2 * l - 1) * x * p - (l - 1) * before) / l; before = p; p = next; }
      slope = n * (x * p - before) / (x * x - 1.0);
      x -= p / slope;
    }
    rule.node.push_back(x);
    rule.weight.push_back(2.0 / ((1.0 - x * x) * slope * slope));
  }
  return rule;
}

Vec3 unitAt(double z, double phi) {
  const double s = std::sqrt(1.0 - z * z);     // [1]
  return {s * std::cos(phi), s * std::sin(phi), z};
}

/// Largest departure of the Gram matrix from the identity, by Gauss-Legendre x trapezoid, which is exact for this order.
double gramError(int order) {
  const HarmonicTables tables = harmonicTables(order);
  const int count = harmonicCount(order), around = 2 * order + 2;
  std::vector<double> values(count), gram(count * count, 0.0);   // [1]
  const Rule rule = gaussLegendre(order + 1);
  for (std::size_t i = 0; i < rule.node.size(); ++i)
    for (int k = 0; k < around; ++k) {
      harmonics(tables, unitAt(rule.node[i], 2.0 * kPi * k / around), values);
      const double weight = rule.weight[i] * 2.0 * kPi / around;   // [1]
      for (int a = 0; a < count; ++a)
        for (int b = 0; b <= a; ++b) gram[a * count + b] += weight * values[a] * values[b];
    }
  double worst = 0.0;                          // [1]
  for (int a = 0; a < count; ++a)
    for (int b = 0; b <= a; ++b) worst = std::max(worst, std::abs(gram[a * count + b] - (a == b ? 1.0 : 0.0)));
  return worst;
}

TEST(Harmonics, AreOrthonormal) {
  for (int order : {0, 1, 4, 15, 30}) EXPECT_LT(gramError(order), 1e-12) << "order " << order;
}

TEST(Harmonics, AddUpToTheSameEverywhere) {   // sum over m of Y_lm^2 = (2 l + 1) / 4 pi
  const HarmonicTables tables = harmonicTables(kMaxHarmonicOrder);
  std::vector<double> values(harmonicCount(kMaxHarmonicOrder));   // [1]
  for (const Vec3& u : {Vec3(0, 0, 1), Vec3(0, 0, -1), unitAt(0.3, 1.1), unitAt(-0.999999, 4.0), unitAt(1e-9, 2.0)}) {
    harmonics(tables, u, values);
    for (int l = 0; l <= kMaxHarmonicOrder; ++l) {
      double sum = 0.0;                        // [1]
      for (int m = -l; m <= l; ++m) sum += values[harmonicIndex(l, m)] * values[harmonicIndex(l, m)];
      const double expected = (2.0 * l + 1.0) / (4.0 * kPi);   // [1]
      EXPECT_NEAR(sum / expected, 1.0, 2e-12) << "l = " << l << " at " << u.transpose();
    }
  }
}

/// The textbook function, eqs. 1 and 2 of the paper, from the C++ library's associated Legendre function (no sign (-1)^m).
std::complex<double> textbook(int l, int m, double z, double phi) {
  const double factor = std::exp(0.5 * (std::lgamma(l - m + 1.0) - std::lgamma(l + m + 1.0))) * std::sqrt((2.0 * l + 1.0) / (4.0 * kPi));
  return (m % 2 ? -1.0 : 1.0) * factor * std::assoc_legendre(l, m, z) * std::polar(1.0, m * phi);
}

TEST(Harmonics, AreTheComplexOnesMadeReal) {
  constexpr int kOrder = 12;
  const HarmonicTables tables = harmonicTables(kOrder);
  std::vector<double> values(harmonicCount(kOrder));   // [1]
  for (double z : {-0.95, -0.2, 0.0, 0.6, 0.99})
    for (double phi : {0.1, 2.0, 5.5}) {
      harmonics(tables, unitAt(z, phi), values);
      for (int l = 0; l <= kOrder; ++l)
        for (int m = 0; m <= l; ++m) {
          const double sign = m % 2 ? -1.0 : 1.0, scale = sign * (m > 0 ? std::sqrt(2.0) : 1.0);   // [1]
          EXPECT_NEAR(values[harmonicIndex(l, m)], scale * textbook(l, m, z, phi).real(), 1e-12);
          if (m == 0) continue;
          EXPECT_NEAR(values[harmonicIndex(l, -m)], scale * textbook(l, m, z, phi).imag(), 1e-12);
        }
    }
}

TEST(Harmonics, SpanTheSameSpaceAsTheComplexOnes) {   // the Gram matrix between the two bases is unitary within each l
  constexpr int kL = 3;
  const HarmonicTables tables = harmonicTables(kL);
  std::vector<double> values(harmonicCount(kL));   // [1]
  const Rule rule = gaussLegendre(kL + 1);
  for (int m = -kL; m <= kL; ++m) {
    double projected = 0.0;                    // [1] squared length of the complex function within the real ones of the same l
    for (int n = -kL; n <= kL; ++n) {
      std::complex<double> product = 0.0;
      for (std::size_t i = 0; i < rule.node.size(); ++i)
        for (int k = 0; k < 2 * kL + 2; ++k) {
          const double phi = 2.0 * kPi * k / (2 * kL + 2);   // [rad]
          harmonics(tables, unitAt(rule.node[i], phi), values);
          const std::complex<double> y = m >= 0 ? textbook(kL, m, rule.node[i], phi) : std::conj(textbook(kL, -m, rule.node[i], phi));
          product += rule.weight[i] * 2.0 * kPi / (2 * kL + 2) * y * values[harmonicIndex(kL, n)];
        }
      projected += std::norm(product);
    }
    EXPECT_NEAR(projected, 1.0, 1e-12) << "m = " << m;
  }
}

TEST(Harmonics, RefuseAnOrderBeyondTheirRange) {
  EXPECT_THROW(harmonicTables(-1), std::invalid_argument);
  EXPECT_THROW(harmonicTables(kMaxHarmonicOrder + 1), std::invalid_argument);
}

}  // namespace
}  // namespace halsted
