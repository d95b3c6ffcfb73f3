#include <algorithm>
#include <numeric>

#include "scenes/harmonics/sphere_map.h"
#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

struct EdgeCount { int edges = 0, open = 0, crowded = 0, turned = 0; };

/// Edges by sorting: each must belong to two triangles that run through it in opposite directions.
EdgeCount countEdges(const Surface& s) {
  std::vector<std::array<int, 3>> sides;       // lower vertex, higher vertex, +1 or -1
  for (const auto& t : s.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(sides.begin(), sides.end());
  EdgeCount count;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    int sum = 0;
    while (end < sides.size() && sides[end][0] == sides[i][0] && sides[end][1] == sides[i][1]) sum += sides[end++][2];
    ++count.edges;
    count.open += end - i == 1;
    count.crowded += end - i > 2;
    count.turned += end - i == 2 && sum != 0;
    i = end;
  }
  return count;
}

/// Connected pieces, and how many vertices belong to any triangle.
std::array<int, 2> piecesAndVertices(const Surface& s) {
  std::vector<int> parent(s.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<char> used(s.vertices.size(), 0);
  for (const auto& t : s.triangles)
    for (int k = 0; k < 3; ++k) {
      used[t[k]] = 1;
      parent[root(t[k])] = root(t[(k + 1) % 3]);
    }
  int pieces = 0, vertices = 0;
  for (int v = 0; v < static_cast<int>(parent.size()); ++v) {
    vertices += used[v];
    pieces += used[v] && root(v) == v;
  }
  return {pieces, vertices};
}

}  // namespace

void requireSphereLike(const Surface& s, const std::string& origin) {
  const auto fail = [&](const std::string& what) { throw InputError(origin + ": " + what); };
  if (s.triangles.size() < 4) fail("too few triangles for a closed surface");
  const EdgeCount count = countEdges(s);
  if (count.open > 0) fail("the surface is open: " + std::to_string(count.open) + " edges belong to one triangle only");
  if (count.crowded > 0) fail(std::to_string(count.crowded) + " edges belong to more than two triangles");
  if (count.turned > 0) fail("neighbouring triangles face opposite ways at " + std::to_string(count.turned) + " edges");
  const auto [pieces, vertices] = piecesAndVertices(s);
  if (pieces > 1) fail("the surface is in " + std::to_string(pieces) + " pieces; harmonics need one");
  const int euler = vertices - count.edges + static_cast<int>(s.triangles.size());
  if (euler != 2) fail("the surface has " + std::to_string((2 - euler) / 2) + " handles (Euler characteristic " + std::to_string(euler) +
                       "); harmonics need a surface like a sphere");
  if (vertices != static_cast<int>(s.vertices.size())) fail("vertices that belong to no triangle");
}

std::vector<double> vertexAreas(const Surface& s) {
  std::vector<double> area(s.vertices.size(), 0.0);   // [m^2]
  for (const auto& [a, b, c] : s.triangles) {
    const double third = (s.vertices[b] - s.vertices[a]).cross(s.vertices[c] - s.vertices[a]).norm() / 6.0;   // [m^2]
    for (int v : {a, b, c}) area[v] += third;
  }
  return area;
}

}  // namespace halsted::scenes
