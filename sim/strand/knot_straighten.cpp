#include <algorithm>

#include "sim/strand/knot_diagram.h"
#include "sim/strand/thread_curve.h"

namespace halsted {
namespace {

constexpr int kRounds = 3;                     // of drawing in between two looks

/// Whether segment pq passes through triangle abc (Moeller and Trumbore 1997), touching counted as passing.
bool pierces(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], d = q - p, h = d.cross(e2);
  const double det = e1.dot(h);                // [m^3]
  if (det == 0.0) return false;
  const Vec3 s = p - t[0], k = s.cross(e1);
  const double slack = 1e-9;                   // [1]
  const double u = s.dot(h) / det, v = d.dot(k) / det, f = e2.dot(k) / det;   // [1]
  return u >= -slack && v >= -slack && u + v <= 1.0 + slack && f >= -slack && f <= 1.0 + slack;
}

/// Whether nothing passes through a triangle but the pieces from `first` to `last`, which are its own sides or hang on them.
bool isClear(const std::vector<Vec3>& x, const std::array<Vec3, 3>& triangle, int first, int last) {
  const Vec3 centre = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
  double reach = 0.0;                          // [m^2]
  for (const Vec3& corner : triangle) reach = std::max(reach, (corner - centre).squaredNorm());
  for (int j = 0; j + 1 < static_cast<int>(x.size()); ++j) {
    if (j >= first && j <= last) continue;
    const Vec3 d = x[j + 1] - x[j];
    const double f = std::clamp((centre - x[j]).dot(d) / d.squaredNorm(), 0.0, 1.0);   // [1]
    if ((x[j] + f * d - centre).squaredNorm() > 1.0001 * reach) continue;
    if (pierces(x[j], x[j + 1], triangle)) return false;
  }
  return true;
}

/// Whether point i may go. The pieces that hang on the two outer corners can cross the new side only by lying in the triangle's plane.
bool isFree(const std::vector<Vec3>& x, int i) { return isClear(x, {x[i - 1], x[i], x[i + 1]}, i - 2, i + 1); }

/// Takes out every point that may go; of those that follow each other every other one first, so that the thread shrinks evenly.
void dropFree(std::vector<Vec3>& x) {
  for (bool changed = true; changed;) {
    changed = false;
    for (int i = 1; i + 1 < static_cast<int>(x.size()); ++i) {
      if (!isFree(x, i)) continue;
      x.erase(x.begin() + i);
      changed = true;
    }
  }
}

/// Draws each point toward its neighbours as far as nothing is in the way; the ends, led away, stand for their direction only.
void moveCorners(std::vector<Vec3>& x) {
  const int last = static_cast<int>(x.size()) - 1;
  for (int i = 1; i < last; ++i) {
    const Vec3 goal = i == 1 ? x[2] : i + 1 == last ? x[i - 1] : Vec3(0.5 * (x[i - 1] + x[i + 1]));
    for (double share : {0.9, 0.5, 0.2}) {     // [1]
      const Vec3 to = x[i] + share * (goal - x[i]);
      if (!isClear(x, {x[i - 1], x[i], to}, i - 2, i) || !isClear(x, {to, x[i], x[i + 1]}, i - 1, i + 1)) continue;
      x[i] = to;
      break;
    }
  }
}

}  // namespace

/// The curve that touches (thread_curve.h), not the polygon of its nodes: in a tight knot the polygon's corners pass through each other.
void KnotReader::sampleCurve(std::span<const Vec3> nodes) {
  straight_.clear();
  const int last = static_cast<int>(nodes.size()) - 1;
  if (last >= 0) straight_.push_back(nodes[0]);
  for (int p = 0; p + 2 <= last; ++p) {
    straight_.push_back(curvePoint(nodes, curveWeights(p, 0.0)));
    straight_.push_back(curvePoint(nodes, curveWeights(p, 0.5)));
  }
  if (last >= 1) straight_.push_back(nodes[last]);
}

void KnotReader::straighten(std::span<const Vec3> nodes) {
  sampleCurve(nodes);
  std::vector<Vec3>& x = straight_;
  if (nodes.size() < 4) return;
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
  dropFree(x);
}

void KnotReader::drawIn() {
  for (int round = 0; round < kRounds && straight_.size() > 3; ++round) {
    moveCorners(straight_);
    dropFree(straight_);
  }
}

std::vector<Vec3> straightened(std::span<const Vec3> nodes) {
  KnotReader reader(static_cast<int>(nodes.size()));
  reader.straighten(nodes);
  return reader.straight_;
}

}  // namespace halsted
