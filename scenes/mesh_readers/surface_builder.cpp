#include "scenes/mesh_readers/surface_builder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

constexpr double kFarthest = 1e4;         // [m] no anatomy lies farther from its origin
constexpr double kWeldFraction = 1e-6;    // [1] of the bounding box's diagonal
constexpr std::size_t kMostGroups = 10'000;

std::string millions(std::size_t count) { return plainNumber(static_cast<double>(count) * 1e-6) + " million"; }

/// Old index -> new index; equal cells of a fine lattice are one vertex, the lowest index stands for them.
std::vector<int> weldMap(const std::vector<Vec3>& vertices) {
  Vec3 low = vertices.front(), high = vertices.front();
  for (const Vec3& v : vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const double cell = std::max((high - low).norm() * kWeldFraction, 1e-12);  // [m]
  std::vector<std::array<long long, 3>> keys;
  keys.reserve(vertices.size());
  for (const Vec3& v : vertices) {
    const Vec3 lattice = (v - low) / cell;
    keys.push_back({std::llround(lattice.x()), std::llround(lattice.y()), std::llround(lattice.z())});
  }
  std::vector<int> order(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return keys[a] != keys[b] ? keys[a] < keys[b] : a < b; });
  std::vector<int> map(vertices.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    map[order[i]] = i > 0 && keys[order[i]] == keys[order[i - 1]] ? map[order[i - 1]] : order[i];
  return map;
}

}  // namespace

void weld(Surface& surface) {
  if (surface.vertices.empty()) return;
  const std::vector<int> map = weldMap(surface.vertices);
  std::vector<int> compact(surface.vertices.size(), -1);
  std::vector<Vec3> vertices;
  std::size_t kept = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::array<int, 3> corners = surface.triangles[t];
    for (int& corner : corners) corner = map[corner];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (int& corner : corners) {
      if (compact[corner] < 0) {
        compact[corner] = static_cast<int>(vertices.size());
        vertices.push_back(surface.vertices[corner]);
      }
      corner = compact[corner];
    }
    surface.triangles[kept] = corners;
    surface.triangleGroup[kept++] = surface.triangleGroup[t];
  }
  surface.triangles.resize(kept);
  surface.triangleGroup.resize(kept);
  surface.vertices = std::move(vertices);
}

void SurfaceBuilder::fail(const std::string& message) const { throw InputError(where_() + ": " + message); }

void SurfaceBuilder::announceVertices(long long count) const {
  if (count < 0) fail("a negative number of vertices");
  if (static_cast<unsigned long long>(count) > mostVertices_)
    fail("too many vertices: " + std::to_string(count) + ", at most " + millions(mostVertices_) + " are read");
}

void SurfaceBuilder::announceTriangles(long long count) const {
  if (count < 0) fail("a negative number of triangles");
  if (static_cast<unsigned long long>(count) > kMostTriangles)
    fail("too many triangles: " + std::to_string(count) + ", at most " + millions(kMostTriangles) + " are read");
}

void SurfaceBuilder::addVertex(const Vec3& position) {
  if (surface_.vertices.size() == mostVertices_) fail("too many vertices: at most " + millions(mostVertices_) + " are read");
  const Vec3 metres = scale_ * position;
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(metres[i])) fail("a coordinate is not a finite number");
    if (std::abs(metres[i]) > kFarthest) fail("a coordinate is " + plainNumber(metres[i]) + " m at this scale");
  }
  surface_.vertices.push_back(metres);
}

void SurfaceBuilder::addCorner(long long vertex) {
  if (vertex < 0 || static_cast<unsigned long long>(vertex) >= surface_.vertices.size())
    fail("vertex index out of range: the file has " + std::to_string(surface_.vertices.size()) + " vertices up to here");
  const int corner = static_cast<int>(vertex);
  if (++corners_ == 1) first_ = corner;
  if (corners_ >= 3) {
    if (surface_.triangles.size() == kMostTriangles) fail("too many triangles: at most " + millions(kMostTriangles) + " are read");
    if (surface_.groups.empty()) surface_.groups.emplace_back();
    surface_.triangles.push_back({first_, previous_, corner});
    surface_.triangleGroup.push_back(static_cast<int>(surface_.groups.size()) - 1);
  }
  previous_ = corner;
}

void SurfaceBuilder::endPolygon() const {
  if (corners_ < 3) fail("a face with fewer than three corners");
}

void SurfaceBuilder::beginGroup(const std::string& name) {
  if (surface_.groups.size() == kMostGroups) fail("too many named parts");
  surface_.groups.push_back(name);
}

Surface SurfaceBuilder::finish() {
  if (surface_.triangles.empty()) fail("has no triangles");
  weld(surface_);
  if (surface_.triangles.empty()) fail("has no triangles with an area");
  return std::move(surface_);
}

}  // namespace halsted::scenes
