#include <algorithm>

#include "sim/strand/knot_diagram.h"

namespace halsted {
namespace {

/// Whether segment pq passes through triangle abc (Moeller and Trumbore 1997), touching counted as passing.
bool pierces(const Vec3& p, const Vec3& q, std::span<const Vec3, 3> t) {
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], d = q - p, h = d.cross(e2);
  const double det = e1.dot(h);                // [m^3]
  if (det == 0.0) return false;
  const Vec3 s = p - t[0], k = s.cross(e1);
  const double slack = 1e-9;                   // [1]
  const double u = s.dot(h) / det, v = d.dot(k) / det, f = e2.dot(k) / det;   // [1]
  return u >= -slack && v >= -slack && u + v <= 1.0 + slack && f >= -slack && f <= 1.0 + slack;
}

/// Whether node i may go: nothing passes through the triangle that it spans with its neighbours.
bool isFree(const std::vector<Vec3>& x, int i) {
  const Vec3 triangle[3] = {x[i - 1], x[i], x[i + 1]};
  const Vec3 centre = (x[i - 1] + x[i] + x[i + 1]) / 3.0;
  double reach = 0.0;                          // [m^2]
  for (const Vec3& corner : triangle) reach = std::max(reach, (corner - centre).squaredNorm());
  const double radius = std::sqrt(reach);      // [m]
  const int last = static_cast<int>(x.size()) - 1;
  for (int j = 0; j < last; ++j) {
    if (j >= i - 2 && j <= i + 1) continue;    // the triangle's own sides and the pieces that hang on them
    const Vec3 d = x[j + 1] - x[j];
    const double f = std::clamp((centre - x[j]).dot(d) / d.squaredNorm(), 0.0, 1.0);   // [1]
    if ((x[j] + f * d - centre).squaredNorm() > 1.0001 * radius * radius) continue;
    if (pierces(x[j], x[j + 1], triangle)) return false;
  }
  // The pieces that hang on the two outer corners can cross the new side only by lying in the triangle's plane.
  return true;
}

}  // namespace

void KnotReader::straighten(std::span<const Vec3> curve) {
  std::vector<Vec3>& x = straight_;
  x.assign(curve.begin(), curve.end());
  node_.clear();
  for (int i = 0; i < static_cast<int>(x.size()); ++i) node_.push_back(i);
  if (x.size() < 4) return;
  Vec3 low = x[0], high = x[0];
  for (const Vec3& p : x) { low = low.cwiseMin(p); high = high.cwiseMax(p); }
  const Vec3 middle = 0.5 * (low + high);
  const double far = 20.0 * (high - low).norm();   // [m]
  const auto led = [&](const Vec3& end, const Vec3& before) -> Vec3 {
    // Away from the middle, and on along the thread.
    const Vec3 away = end - middle, along = end - before;
    const Vec3 d = away / (away.norm() + 1e-12) + along / (along.norm() + 1e-12);
    return end + far * d / (d.norm() + 1e-12);
  };
  const Vec3 tail = led(x.front(), x[1]), tip = led(x.back(), x[x.size() - 2]);
  x.insert(x.begin(), tail);
  x.push_back(tip);
  node_.insert(node_.begin(), 0);
  node_.push_back(node_.back());
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = 1; i + 1 < static_cast<int>(x.size());) {
      if (!isFree(x, i)) { ++i; continue; }
      x.erase(x.begin() + i);
      node_.erase(node_.begin() + i);
      changed = true;
      ++i;                                     // every other node first: the thread shrinks evenly
    }
  }
}

std::vector<Vec3> straightened(std::span<const Vec3> curve) {
  KnotReader reader(static_cast<int>(curve.size()));
  reader.straighten(curve);
  return reader.straight_;
}

}  // namespace halsted
