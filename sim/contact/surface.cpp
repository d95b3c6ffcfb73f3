#include "sim/contact/surface.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/geometry.h"

namespace halsted {
namespace {

void flatten(const std::vector<std::vector<int>>& lists, std::vector<int>& start, std::vector<int>& items) {
  start.assign(1, 0);
  for (const auto& list : lists) {
    items.insert(items.end(), list.begin(), list.end());
    start.push_back(static_cast<int>(items.size()));
  }
}

/// Owner tet of each triangle: the one tet whose corners include all three. Vertices' tets are listed once.
std::vector<int> ownerTets(const TetMesh& mesh) {
  std::vector<std::vector<int>> tetsOf(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (int v : mesh.tets[t]) tetsOf[v].push_back(static_cast<int>(t));
  std::vector<int> owner(mesh.surface.size(), -1);
  for (std::size_t f = 0; f < mesh.surface.size(); ++f) {
    const auto& tri = mesh.surface[f];
    for (int t : tetsOf[tri[0]]) {
      const auto& v = mesh.tets[t];
      const auto has = [&](int x) { return std::find(v.begin(), v.end(), x) != v.end(); };
      if (has(tri[1]) && has(tri[2])) { owner[f] = t; break; }
    }
  }
  return owner;
}

/// Every interior face of a tet that can be cut, seen from either side.
void addCutFaces(const TetMesh& mesh, SurfaceModel& s) {
  for (std::size_t t = 0; t < mesh.cuttable.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      const int behind = s.tetNeighbour[t][f];
      if (behind < 0 || !(mesh.cuttable[t] || mesh.cuttable[behind])) continue;
      s.triangles.push_back(faceCorners(mesh.tets[t], f));
      s.triangleTet.push_back(static_cast<int>(t));
      s.triangleBehind.push_back(behind);
    }
  }
}

}  // namespace

bool exposedVertex(const SurfaceModel& s, std::span<const std::uint8_t> gone, int vertex) {
  for (int e = s.triangleStart[vertex]; e < s.triangleStart[vertex + 1]; ++e)
    if (exposed(s, gone, s.triangleOf[e])) return true;
  return false;
}

SurfaceModel buildSurface(const TetMesh& mesh) {
  SurfaceModel s;
  s.triangles = mesh.surface;
  s.triangleTet = ownerTets(mesh);
  s.triangleBehind.assign(mesh.surface.size(), -1);
  s.tetNeighbour = faceNeighbours(mesh.tets);
  addCutFaces(mesh, s);
  std::vector<std::vector<int>> triangles(mesh.vertices.size()), neighbours(mesh.vertices.size());
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int v = s.triangles[f][c], next = s.triangles[f][(c + 1) % 3];
      triangles[v].push_back(static_cast<int>(f));
      neighbours[v].push_back(next);
      neighbours[next].push_back(v);
    }
  }
  for (std::size_t v = 0; v < triangles.size(); ++v) {
    auto& list = neighbours[v];
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    if (!triangles[v].empty()) s.vertices.push_back(static_cast<int>(v));
  }
  flatten(triangles, s.triangleStart, s.triangleOf);
  flatten(neighbours, s.neighbourStart, s.neighbour);
  return s;
}

int nearestVertex(const SurfaceModel& s, const SurfaceNow& now, const Vec3& p) {
  int best = s.vertices.front();
  double least = 1e300;                        // [m^2]
  for (int v : s.vertices) {
    const double d2 = (now.position[v] - p).squaredNorm();
    if (d2 < least && canBeNear(s, now, v)) { least = d2; best = v; }
  }
  return best;
}

SurfacePoint nearestSurface(const SurfaceModel& s, const SurfaceNow& now, const Vec3& p, double reach, int& vertex) {
  const std::span<const Vec3> x = now.position;
  double least = canBeNear(s, now, vertex) ? (x[vertex] - p).squaredNorm() : 1e300;   // [m^2]
  for (bool moved = true; moved;) {
    moved = false;
    const int from = vertex;
    for (int e = s.neighbourStart[from]; e < s.neighbourStart[from + 1]; ++e) {
      const double d2 = (x[s.neighbour[e]] - p).squaredNorm();
      if (d2 < least && canBeNear(s, now, s.neighbour[e])) { least = d2; vertex = s.neighbour[e]; moved = true; }
    }
  }
  SurfacePoint best;
  if (least > reach * reach) return best;
  double nearest = 1e300;                      // [m^2]
  Vec3 normalSum = Vec3::Zero();
  for (int e = s.triangleStart[vertex]; e < s.triangleStart[vertex + 1]; ++e) {
    const int f = s.triangleOf[e];
    if (!exposed(s, now.gone, f)) continue;
    const Vec3 &a = x[s.triangles[f][0]], &b = x[s.triangles[f][1]], &c = x[s.triangles[f][2]];
    const auto w = closestOnTriangle(p, a, b, c);
    const Vec3 q = mix(w, a, b, c);
    const double d2 = (p - q).squaredNorm();
    const Vec3 normal = (b - a).cross(c - a).normalized();
    if (d2 < nearest - 1e-14) {
      nearest = d2;
      normalSum = normal;
      best.triangle = f;
      best.weight = w;
      best.point = q;
    } else if (d2 <= nearest + 1e-14) {
      normalSum += normal;
    }
  }
  if (best.triangle < 0) return best;          // round a vertex that nothing has laid bare
  const Vec3 away = p - best.point;
  const double distance = std::sqrt(nearest);
  const double side = away.dot(normalSum);
  best.distance = side < 0.0 ? -distance : distance;
  best.normal = distance > 1e-6 ? Vec3((side < 0.0 ? -1.0 : 1.0) / distance * away) : Vec3(normalSum.normalized());
  return best;
}

}  // namespace halsted
