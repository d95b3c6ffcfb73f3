#include "sim/harmonics/surface.h"

#include <cmath>
#include <stdexcept>

namespace halsted {
namespace {

using Six = std::array<double, 6>;             // [m] x, y, z of the cosine part, then of the sine part

/// Value and derivatives with respect to x, y, z of the formula in basis.h, which is defined off the sphere too.
struct Jet {
  Vec3 value = Vec3::Zero();                   // [m]
  Vec3 dx = Vec3::Zero(), dy = Vec3::Zero(), dz = Vec3::Zero();   // [m]
  Vec3 xx = Vec3::Zero(), xy = Vec3::Zero(), xz = Vec3::Zero(), yz = Vec3::Zero(), zz = Vec3::Zero();   // [m]; yy = -xx
};

/// One column's sums over l: sum p c, sum p' c, sum p'' c.
struct ColumnSum { Six value{}, first{}, second{}; };

void add(double factor, const Six& c, Six& sum) { for (int i = 0; i < 6; ++i) sum[i] += factor * c[i]; }   // factor [1]

template <int kDerivatives>
void sumColumn(const HarmonicSurface& s, int m, double z, int& at, ColumnSum& sum) {   // z [1]
  const HarmonicTables& t = s.tables;
  double p = t.first[m], before = 0.0;         // [1] p_lm, p_(l-1)m, and the same for its derivatives
  double d = 0.0, dBefore = 0.0, e = 0.0, eBefore = 0.0;   // [1]
  for (int l = m; l <= t.order; ++l, ++at) {
    if (l > m) {
      const double a = t.a[at], b = t.b[at];   // [1]
      const double pNext = a * (z * p - b * before);                       // [1]
      const double dNext = a * (p + z * d - b * dBefore);                  // [1]
      const double eNext = a * (2.0 * d + z * e - b * eBefore);            // [1]
      before = p; p = pNext;
      dBefore = d; d = dNext;
      eBefore = e; e = eNext;
    }
    add(p, s.coefficient[at], sum.value);
    if constexpr (kDerivatives > 0) add(d, s.coefficient[at], sum.first);
    if constexpr (kDerivatives > 1) add(e, s.coefficient[at], sum.second);
  }
}

/// c times the cosine part plus s times the sine part.
Vec3 mix(double c, double s, const Six& sum) {   // c, s [1]
  return {c * sum[0] + s * sum[3], c * sum[1] + s * sum[4], c * sum[2] + s * sum[5]};
}

template <int kDerivatives> Jet jetAt(const HarmonicSurface& s, const Vec3& unit) {
  const double x = unit.x(), y = unit.y(), z = unit.z();   // [1]
  double c = 1.0, sn = 0.0, c1 = 0.0, s1 = 0.0, c2 = 0.0, s2 = 0.0;   // [1] C_m, S_m, then of m - 1 and m - 2
  Jet jet;
  for (int m = 0, at = 0; m <= s.tables.order; ++m) {
    ColumnSum sum;
    sumColumn<kDerivatives>(s, m, z, at, sum);
    jet.value += mix(c, sn, sum.value);
    if constexpr (kDerivatives > 0) {
      jet.dx += mix(m * c1, m * s1, sum.value);
      jet.dy += mix(-m * s1, m * c1, sum.value);
      jet.dz += mix(c, sn, sum.first);
    }
    if constexpr (kDerivatives > 1) {
      const double k = m * (m - 1.0);          // [1]
      jet.xx += mix(k * c2, k * s2, sum.value);
      jet.xy += mix(-k * s2, k * c2, sum.value);
      jet.xz += mix(m * c1, m * s1, sum.first);
      jet.yz += mix(-m * s1, m * c1, sum.first);
      jet.zz += mix(c, sn, sum.second);
    }
    c2 = c1; s2 = s1;
    c1 = c; s1 = sn;
    c = x * c1 - y * s1;
    sn = x * s1 + y * c1;
  }
  return jet;
}

/// The second derivative's form: a' H b.
Vec3 bilinear(const Jet& j, const Vec3& a, const Vec3& b) {
  return (a.x() * b.x() - a.y() * b.y()) * j.xx + a.z() * b.z() * j.zz + (a.x() * b.y() + a.y() * b.x()) * j.xy +
         (a.x() * b.z() + a.z() * b.x()) * j.xz + (a.y() * b.z() + a.z() * b.y()) * j.yz;
}

/// A step (a, b) along e1, e2, kept shorter than a third of a radian.
Vec3 moved(const SurfaceFrame& f, double a, double b) {   // a, b [rad]
  const double length = std::sqrt(a * a + b * b), limit = 0.3;   // [rad]
  const double scale = length > limit ? limit / length : 1.0;    // [1]
  return (f.unit + scale * (a * f.direction1 + b * f.direction2)).normalized();
}

}  // namespace

HarmonicSurface harmonicSurface(int order, const std::vector<Vec3>& c) {
  HarmonicSurface s{harmonicTables(order), {}};
  if (static_cast<int>(c.size()) != harmonicCount(order)) throw std::invalid_argument("a harmonic surface needs (order + 1)^2 coefficients");
  for (int m = 0; m <= order; ++m)
    for (int l = m; l <= order; ++l) {
      const Vec3& even = c[harmonicIndex(l, m)];
      const Vec3 odd = m > 0 ? c[harmonicIndex(l, -m)] : Vec3::Zero().eval();
      s.coefficient.push_back({even.x(), even.y(), even.z(), odd.x(), odd.y(), odd.z()});
    }
  return s;
}

std::vector<Vec3> coefficients(const HarmonicSurface& s) {
  const int order = s.tables.order;
  std::vector<Vec3> c(harmonicCount(order));
  for (int m = 0; m <= order; ++m)
    for (int l = m; l <= order; ++l) {
      const Six& six = s.coefficient[harmonicColumn(order, l, m)];
      c[harmonicIndex(l, m)] = Vec3(six[0], six[1], six[2]);
      if (m > 0) c[harmonicIndex(l, -m)] = Vec3(six[3], six[4], six[5]);
    }
  return c;
}

Vec3 positionAt(const HarmonicSurface& s, const Vec3& unit) { return jetAt<0>(s, unit).value; }

std::array<Vec3, 2> directionsAt(const Vec3& u) {
  // Duff et al. 2017: an orthonormal basis without a branch at the pole.
  const double sign = u.z() < 0.0 ? -1.0 : 1.0;              // [1]
  const double a = -1.0 / (sign + u.z()), b = u.x() * u.y() * a;   // [1]
  return {Vec3(1.0 + sign * u.x() * u.x() * a, sign * b, -sign * u.x()), Vec3(b, sign + u.y() * u.y() * a, -u.y())};
}

SurfaceFrame frameAt(const HarmonicSurface& s, const Vec3& unit) {
  const Jet j = jetAt<1>(s, unit);
  SurfaceFrame f;
  f.unit = unit;
  const auto [e1, e2] = directionsAt(unit);
  f.direction1 = e1;
  f.direction2 = e2;
  f.position = j.value;
  f.tangent1 = e1.x() * j.dx + e1.y() * j.dy + e1.z() * j.dz;
  f.tangent2 = e2.x() * j.dx + e2.y() * j.dy + e2.z() * j.dz;
  const Vec3 across = f.tangent1.cross(f.tangent2);          // [m^2]
  const double length = std::sqrt(across.squaredNorm());     // [m^2]
  f.normal = length > 0.0 ? Vec3(across / length) : unit;
  return f;
}

SurfaceBend bendAt(const HarmonicSurface& s, const SurfaceFrame& f) {
  const Jet j = jetAt<2>(s, f.unit);
  // Along a great circle u'' = -u: the second derivative on the sphere is e'He minus the derivative along u.
  const Vec3 radial = f.unit.x() * j.dx + f.unit.y() * j.dy + f.unit.z() * j.dz;   // [m]
  return {bilinear(j, f.direction1, f.direction1) - radial, bilinear(j, f.direction1, f.direction2),
          bilinear(j, f.direction2, f.direction2) - radial};
}

SurfaceFrame nearestPoint(const HarmonicSurface& s, const Vec3& point, const Vec3& start, int steps) {
  SurfaceFrame f = frameAt(s, start);
  for (int k = 0; k < steps; ++k) {
    const Vec3 gap = point - f.position;       // [m]
    const double a = f.tangent1.squaredNorm(), b = f.tangent1.dot(f.tangent2), c = f.tangent2.squaredNorm();   // [m^2]
    const double g = f.tangent1.dot(gap), h = f.tangent2.dot(gap), det = a * c - b * b;   // [m^2], [m^4]
    if (!(det > 1e-12 * a * c)) break;
    f = frameAt(s, moved(f, (c * g - b * h) / det, (a * h - b * g) / det));
  }
  return f;
}

LineHit meetLine(const HarmonicSurface& s, const Line& line, const Vec3& start) {
  constexpr int kSteps = 12;
  LineHit hit;
  SurfaceFrame& f = hit.frame;
  f = frameAt(s, start);
  for (int k = 0; k < kSteps; ++k) {
    // position + a tangent1 + b tangent2 = origin + distance direction, by Cramer's rule.
    const Vec3 gap = line.origin - f.position;                              // [m]
    const Vec3 cross = f.tangent2.cross(line.direction);                    // [m]
    const double det = f.tangent1.dot(cross);                               // [m^2]
    if (!(det * det > 1e-12 * f.tangent1.squaredNorm() * f.tangent2.squaredNorm())) return hit;   // the line runs along the surface
    const double a = gap.dot(cross) / det, b = f.tangent1.dot(gap.cross(line.direction)) / det;   // [rad]
    f = frameAt(s, moved(f, a, b));
    if (a * a + b * b < 1e-18) break;
  }
  hit.distance = (f.position - line.origin).dot(line.direction);
  const Vec3 miss = line.origin + hit.distance * line.direction - f.position;   // [m]
  hit.found = miss.squaredNorm() < 1e-12;
  return hit;
}

}  // namespace halsted
