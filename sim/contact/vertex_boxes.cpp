#include "sim/contact/vertex_boxes.h"

#include <algorithm>

namespace halsted {
namespace {

constexpr std::size_t kVertices = VertexBoxes::kVertices;

/// No more than the squared distance of anything in the box, in floating point, too: the same operations in the same order on numbers that are no larger.
double atLeast(const Vec3& low, const Vec3& high, const Vec3& p) {   // [m] -> [m^2]
  Vec3 out;                                    // [m]
  for (int axis = 0; axis < 3; ++axis) out[axis] = std::max(0.0, std::max(low[axis] - p[axis], p[axis] - high[axis]));
  return out.squaredNorm();
}

}  // namespace

void fillBoxes(const SurfaceModel& s, const SurfaceNow& now, VertexBoxes& boxes) {
  for (std::size_t b = 0; b < boxes.low.size(); ++b) {
    const std::size_t first = b * kVertices, last = std::min(first + kVertices, s.vertices.size());
    Vec3 low = now.position[s.vertices[first]], high = low;            // [m]
    for (std::size_t i = first + 1; i < last; ++i) {
      low = low.cwiseMin(now.position[s.vertices[i]]);
      high = high.cwiseMax(now.position[s.vertices[i]]);
    }
    boxes.low[b] = low;
    boxes.high[b] = high;
  }
  boxes.filled = true;
}

int nearestVertex(const SurfaceModel& s, const SurfaceNow& now, const VertexBoxes& boxes, const Vec3& p, int near) {   // p [m]
  int best = s.vertices.front();
  double least = 1e300;                        // [m^2]
  if (canBeNear(s, now, near)) {
    best = near;
    least = (now.position[near] - p).squaredNorm();
  }
  for (std::size_t b = 0; b < boxes.low.size(); ++b) {
    if (atLeast(boxes.low[b], boxes.high[b], p) > least) continue;
    const std::size_t last = std::min((b + 1) * kVertices, s.vertices.size());
    for (std::size_t i = b * kVertices; i < last; ++i) {
      const int v = s.vertices[i];
      const double d2 = (now.position[v] - p).squaredNorm();           // [m^2]
      const bool nearer = d2 < least || (d2 == least && v < best);     // of two that are equally near the first
      if (nearer && canBeNear(s, now, v)) { least = d2; best = v; }
    }
  }
  return best;
}

}  // namespace halsted
