#include "scenes/two_ends.h"

#include <algorithm>

namespace halsted::scenes {

namespace {

/// Both ends are `one` after a rigid motion each.
template <class Left, class Right> TetMesh pairOf(const TetMesh& one, Left left, Right right) {
  const int first = static_cast<int>(one.vertices.size());
  TetMesh both = one;
  for (Vec3& v : both.vertices) v = left(v);
  for (const Vec3& v : one.vertices) both.vertices.push_back(right(v));
  const auto shifted = [&](auto corners) {
    for (int& v : corners) v += first;
    return corners;
  };
  for (const auto& tet : one.tets) both.tets.push_back(shifted(tet));
  for (const auto& triangle : one.surface) both.surface.push_back(shifted(triangle));
  both.triangleLayer.insert(both.triangleLayer.end(), one.triangleLayer.begin(), one.triangleLayer.end());
  both.uv.insert(both.uv.end(), one.uv.begin(), one.uv.end());
  for (int v : one.fixed) both.fixed.push_back(v + first);
  for (int v : one.rim) both.rim.push_back(v + first);
  return both;
}

}  // namespace

TetMesh twoEnds(const TetMesh& one, double gap) {
  double reach = -1e300;                       // [m] how far the wall bulges toward the other end
  for (const Vec3& v : one.vertices) reach = std::max(reach, v.x());
  const double aside = reach + 0.5 * gap;      // [m]
  return pairOf(one, [&](const Vec3& v) { return Vec3(v.x() - aside, v.y(), v.z()); },
                [&](const Vec3& v) { return Vec3(aside - v.x(), -v.y(), v.z()); });
}

TetMesh endToEnd(const TetMesh& one, double gap) {
  double top = -1e300;                         // [m] of the rim
  for (int v : one.rim) top = std::max(top, one.vertices[v].y());
  const double aside = 0.5 * gap;              // [m]
  return pairOf(one, [&](const Vec3& v) { return Vec3(v.z() - aside, v.y() - top, -v.x()); },
                [&](const Vec3& v) { return Vec3(aside - v.z(), v.y() - top, v.x()); });
}

}  // namespace halsted::scenes
