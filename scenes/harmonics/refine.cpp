#include <algorithm>
#include <cmath>

#include "scenes/harmonics/sphere_map.h"

namespace halsted::scenes {
namespace {

using Edge = std::array<int, 2>;

Edge edgeOf(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Long edges, sorted, so that the midpoint of the i-th becomes vertex first + i.
std::vector<Edge> longEdges(const Surface& s, double longest) {   // longest [m]
  std::vector<Edge> edges;
  for (const auto& t : s.triangles)
    for (int k = 0; k < 3; ++k)
      if ((s.vertices[t[k]] - s.vertices[t[(k + 1) % 3]]).norm() > longest) edges.push_back(edgeOf(t[k], t[(k + 1) % 3]));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Splits one triangle by the midpoints of its sides (-1: that side stays whole): into one, two, three or four.
void splitTriangle(const std::array<int, 3>& t, const std::array<int, 3>& middle, std::vector<std::array<int, 3>>& out) {
  const int count = (middle[0] >= 0) + (middle[1] >= 0) + (middle[2] >= 0);
  if (count == 0) { out.push_back(t); return; }
  if (count == 3) {
    const auto [p, q, r] = middle;
    out.insert(out.end(), {{t[0], p, r}, {p, t[1], q}, {r, q, t[2]}, {p, q, r}});
    return;
  }
  int k = 0;                                   // turn it so that side 0 is split, and with two, side 2 is the whole one
  while (middle[k] < 0 || (count == 2 && middle[(k + 1) % 3] < 0)) ++k;
  const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3], p = middle[k], q = middle[(k + 1) % 3];
  if (count == 1) out.insert(out.end(), {{a, p, c}, {p, b, c}});
  else out.insert(out.end(), {{a, p, c}, {p, q, c}, {p, b, q}});
}

void splitOnce(Surface& s, const std::vector<Edge>& edges) {
  const int first = static_cast<int>(s.vertices.size());
  for (const auto& [a, b] : edges) s.vertices.push_back(0.5 * (s.vertices[a] + s.vertices[b]));
  const auto middleOf = [&](int a, int b) {
    const auto at = std::lower_bound(edges.begin(), edges.end(), edgeOf(a, b));
    return at != edges.end() && *at == edgeOf(a, b) ? first + static_cast<int>(at - edges.begin()) : -1;
  };
  std::vector<std::array<int, 3>> triangles;
  for (const auto& t : s.triangles) splitTriangle(t, {middleOf(t[0], t[1]), middleOf(t[1], t[2]), middleOf(t[2], t[0])}, triangles);
  s.triangles = std::move(triangles);
}

}  // namespace

Surface refined(const Surface& surface) {
  constexpr double kLongest = 1.7;             // [1] of the side of an equilateral triangle of average area
  constexpr int kMostPasses = 8;
  double total = 0.0;                          // [m^2]
  for (double a : vertexAreas(surface)) total += a;
  const double side = std::sqrt(4.0 * total / (std::sqrt(3.0) * static_cast<double>(surface.triangles.size())));   // [m]
  Surface s = surface;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    const std::vector<Edge> edges = longEdges(s, kLongest * side);
    if (edges.empty() || s.triangles.size() + 2 * edges.size() > kMostTriangles) break;
    splitOnce(s, edges);
  }
  s.groups.assign(1, "");
  s.triangleGroup.assign(s.triangles.size(), 0);
  return s;
}

}  // namespace halsted::scenes
