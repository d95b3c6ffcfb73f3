#include "sim/contact/geometry.h"

namespace halsted {
namespace {

double clamp01(double x) { return x < 0.0 ? 0.0 : (x > 1.0 ? 1.0 : x); }

}  // namespace

double closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double length2 = d.squaredNorm();      // [m^2]
  return length2 > 0.0 ? clamp01((p - a).dot(d) / length2) : 0.0;
}

std::array<double, 3> closestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {1.0, 0.0, 0.0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {0.0, 1.0, 0.0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 > d3 ? d1 / (d1 - d3) : 0.0;
    return {1.0 - v, v, 0.0};
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0, 0.0, 1.0};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 > d6 ? d2 / (d2 - d6) : 0.0;
    return {1.0 - w, 0.0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double sum = (d4 - d3) + (d5 - d6);
    const double w = sum > 0.0 ? (d4 - d3) / sum : 0.0;
    return {0.0, 1.0 - w, w};
  }
  const double inverse = 1.0 / (va + vb + vc);
  const double v = vb * inverse, w = vc * inverse;
  return {1.0 - v - w, v, w};
}

std::array<double, 2> closestSegments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Vec3 u = a1 - a0, v = b1 - b0, w = a0 - b0;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double uw = u.dot(w), vw = v.dot(w);
  const double det = uu * vv - uv * uv;        // [m^4]
  double s = det > 1e-12 * uu * vv ? clamp01((uv * vw - vv * uw) / det) : 0.0;
  double t = vv > 0.0 ? (uv * s + vw) / vv : 0.0;
  if (t < 0.0) { t = 0.0; s = uu > 0.0 ? clamp01(-uw / uu) : 0.0; }
  if (t > 1.0) { t = 1.0; s = uu > 0.0 ? clamp01((uv - uw) / uu) : 0.0; }
  return {s, t};
}

SegmentTriangle closestSegmentTriangle(const Vec3& s0, const Vec3& s1, const Vec3& a, const Vec3& b, const Vec3& c) {
  SegmentTriangle best;
  best.squaredDistance = 1e300;
  const auto offer = [&](double fraction, const std::array<double, 3>& w) {
    const double d2 = (s0 + fraction * (s1 - s0) - mix(w, a, b, c)).squaredNorm();
    if (d2 < best.squaredDistance) best = {fraction, w, d2};
  };
  const Vec3 normal = (b - a).cross(c - a);
  const double h0 = normal.dot(s0 - a), h1 = normal.dot(s1 - a);
  if (h0 * h1 < 0.0) {                         // the segment crosses the plane: it may pass through the triangle
    const double f = h0 / (h0 - h1);
    const Vec3 p = s0 + f * (s1 - s0);
    offer(f, closestOnTriangle(p, a, b, c));
  }
  offer(0.0, closestOnTriangle(s0, a, b, c));
  offer(1.0, closestOnTriangle(s1, a, b, c));
  const auto e0 = closestSegments(s0, s1, a, b);
  offer(e0[0], {1.0 - e0[1], e0[1], 0.0});
  const auto e1 = closestSegments(s0, s1, b, c);
  offer(e1[0], {0.0, 1.0 - e1[1], e1[1]});
  const auto e2 = closestSegments(s0, s1, c, a);
  offer(e2[0], {e2[1], 0.0, 1.0 - e2[1]});
  return best;
}

}  // namespace halsted
