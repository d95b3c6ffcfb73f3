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

/// The nearest point found so far, and the faces that meet there.
struct Nearest {
  int triangle = -1;
  std::array<double, 3> weight{};              // [1]
  double squared = 1e300;                      // [m^2]
  Vec3 on = Vec3::Zero(), away = Vec3::Zero(), normals = Vec3::Zero();   // [m] the point, and from it; [1] sum of outward normals

  bool inside() const { return away.dot(normals) < 0.0; }
  SurfacePoint point() const {
    SurfacePoint q;
    if (triangle < 0) return q;                // round a vertex that nothing has laid bare
    const double distance = std::sqrt(squared), sign = inside() ? -1.0 : 1.0;
    q.triangle = triangle;
    q.weight = weight;
    q.point = on;
    q.distance = sign * distance;
    q.normal = distance > 1e-6 ? Vec3(sign / distance * away) : Vec3(normals.normalized());
    return q;
  }
};

void offer(const SurfaceModel& s, const SurfaceNow& now, const Vec3& p, int f, Nearest& best) {
  constexpr double kSame = 1e-14;              // [m^2]
  const Vec3 &a = now.position[s.triangles[f][0]], &b = now.position[s.triangles[f][1]], &c = now.position[s.triangles[f][2]];
  const auto w = closestOnTriangle(p, a, b, c);
  const Vec3 on = mix(w, a, b, c), away = p - on;
  const double squared = away.squaredNorm();
  if (squared > best.squared + kSame) return;
  const Vec3 normal = (b - a).cross(c - a).normalized();
  if (squared >= best.squared - kSame) {
    best.normals += normal;
    return;
  }
  best = {f, w, squared, on, away, normal};
}

Nearest roundVertex(const SurfaceModel& s, const SurfaceNow& now, const Vec3& p, int vertex) {
  Nearest best;
  for (int e = s.triangleStart[vertex]; e < s.triangleStart[vertex + 1]; ++e)
    if (exposed(s, now.gone, s.triangleOf[e])) offer(s, now, p, s.triangleOf[e], best);
  return best;
}

int heaviest(const std::array<double, 3>& w) { return w[0] >= w[1] && w[0] >= w[2] ? 0 : w[1] >= w[2] ? 1 : 2; }

/// From the triangles round a vertex to those round the corner nearest to the point found, until it is the vertex itself.
Nearest descend(const SurfaceModel& s, const SurfaceNow& now, const Vec3& p, int& vertex) {
  constexpr int kMostLooks = 16;               // where two corners are as near as each other it would not end
  Nearest best = roundVertex(s, now, p, vertex);
  for (int look = 0; look < kMostLooks && best.triangle >= 0; ++look) {
    const int corner = s.triangles[best.triangle][heaviest(best.weight)];
    if (corner == vertex) break;
    vertex = corner;
    best = roundVertex(s, now, p, vertex);     // the same triangle is among them: no farther
  }
  return best;
}

/// Downhill along the surface's edges to a vertex of which no neighbour is nearer.  [m] -> [m^2]
double walkToVertex(const SurfaceModel& s, const SurfaceNow& now, const Vec3& p, int& vertex) {
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
  return least;
}

/// Is all of a triangle's box farther away?
bool fartherThan(double squared, const std::array<int, 3>& v, std::span<const Vec3> x, const Vec3& p) {   // [m^2], [m]
  double out = 0.0;                            // [m^2]
  for (int axis = 0; axis < 3; ++axis) {
    const double a = x[v[0]][axis], b = x[v[1]][axis], c = x[v[2]][axis];
    const double miss = std::max({0.0, std::min({a, b, c}) - p[axis], p[axis] - std::max({a, b, c})});
    out += miss * miss;
  }
  return out > squared;
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
  s.cell.assign(mesh.vertices.size(), 0.0);
  for (const auto& t : mesh.surface) {
    const double area = 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();   // [m^2]
    for (const int v : t) s.cell[v] += area / 3.0;
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
  const int known = vertex;
  if (walkToVertex(s, now, p, vertex) > reach * reach) return {};
  const bool strayed = vertex != known;
  Nearest best = descend(s, now, p, vertex);
  if (!strayed || !best.inside()) return best.point();
  int kept = known;                            // in thin walls a vertex of the far side may be nearer than any of the face that is
  const Nearest back = descend(s, now, p, kept);
  if (back.squared >= best.squared) return best.point();
  vertex = kept;
  return back.point();
}

SurfacePoint nearestTriangle(const SurfaceModel& s, const SurfaceNow& now, const Vec3& p, int& vertex, std::span<const int> pieceOf) {
  const auto ofPiece = [&, begin = vertex](int f) { return pieceOf.empty() || pieceOf[s.triangles[f][0]] == pieceOf[begin]; };
  Nearest best = roundVertex(s, now, p, vertex);
  for (int f = 0; f < static_cast<int>(s.triangles.size()); ++f)
    if (ofPiece(f) && !fartherThan(best.squared, s.triangles[f], now.position, p) && exposed(s, now.gone, f)) offer(s, now, p, f, best);
  if (best.triangle < 0) return {};
  vertex = s.triangles[best.triangle][heaviest(best.weight)];
  return descend(s, now, p, vertex).point();   // with every triangle that meets there
}

}  // namespace halsted
