#pragma once
/// Closest points between the primitives that touch each other. Pure; + - * / sqrt only.
#include <array>

#include "sim/exchange.h"
#include "sim/types.h"

namespace halsted {

/// Closest point of a segment to p, as the fraction along it in [0, 1].
double closestOnSegment(const Vec3& p, const Vec3& a, const Vec3& b);

/// Barycentric weights of the point of triangle abc closest to p (Ericson 2005, 5.1.5).
std::array<double, 3> closestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Closest points of two segments, as fractions [1] along each.
std::array<double, 2> closestSegments(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

/// Closest pair between a segment and a triangle.
struct SegmentTriangle {
  double fraction = 0.0;                       // [1] along the segment
  std::array<double, 3> weight{};              // [1] barycentric in the triangle
  double squaredDistance = 0.0;                // [m^2]
};
SegmentTriangle closestSegmentTriangle(const Vec3& s0, const Vec3& s1, const Vec3& a, const Vec3& b, const Vec3& c);

inline Vec3 mix(const std::array<double, 3>& w, const Vec3& a, const Vec3& b, const Vec3& c) { return w[0] * a + w[1] * b + w[2] * c; }

}  // namespace halsted
