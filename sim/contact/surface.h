#pragma once
/// The tissue's surface as neighbours and owners, and the search for the surface point nearest to a moving sample.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/mesh.h"
#include "sim/types.h"

namespace halsted {

/// First the boundary's triangles, as in the mesh; then, for every interior face of a tet that can be cut, one for each side.
struct SurfaceModel {
  std::vector<std::array<int, 3>> triangles;       // outward, counter-clockwise
  std::vector<int> vertices;                       // vertices that lie on the surface, ascending
  std::vector<int> triangleTet;                    // owner tet of each triangle
  std::vector<int> triangleBehind;                 // tet on its other side, -1 outside: it is bare only once that one is gone
  std::vector<int> triangleStart, triangleOf;      // triangles at each vertex (prefix sums, items)
  std::vector<int> neighbourStart, neighbour;      // vertices joined to each vertex by a surface edge
  std::vector<double> cell;                        // [m^2] per vertex: its third of the boundary's triangles at rest, 0 inside
  std::vector<std::array<int, 4>> tetNeighbour;    // per tet and corner: tet behind the opposite face, -1 outside
};

SurfaceModel buildSurface(const TetMesh&);

/// Can a triangle be touched? `gone` as in TissueState: per tet, empty where nothing can be cut.
inline bool exposed(const SurfaceModel& s, std::span<const std::uint8_t> gone, int triangle) {
  const int behind = s.triangleBehind[triangle];
  if (gone.empty()) return behind < 0;
  return !gone[s.triangleTet[triangle]] && (behind < 0 || gone[behind]);
}
/// A vertex of such a triangle.
bool exposedVertex(const SurfaceModel&, std::span<const std::uint8_t> gone, int vertex);

struct SurfacePoint {
  int triangle = -1;
  std::array<double, 3> weight{};                  // [1]
  Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ();   // [m]; [1] outward, averaged where the nearest feature is an edge or corner
  double distance = 1e300;                         // [m] positive outside the material
};

/// The surface as it lies: its particles, and what of it is gone (per tet; empty where nothing can be cut).
struct SurfaceNow {
  std::span<const Vec3> position;                  // [m]
  std::span<const std::uint8_t> gone;

  SurfaceNow(std::span<const Vec3> x, std::span<const std::uint8_t> g = {}) : position(x), gone(g) {}
  SurfaceNow(const std::vector<Vec3>& x, std::span<const std::uint8_t> g = {}) : position(x), gone(g) {}
};

/// Is the vertex bare? Where nothing can be cut every one is, and none is asked.
inline bool canBeNear(const SurfaceModel& s, const SurfaceNow& now, int vertex) { return now.gone.empty() || exposedVertex(s, now.gone, vertex); }

/// Walks from `vertex` downhill to the nearest surface vertex, and from there over the triangles to the point nearest to p. What it finds inside the
/// material it looks for from `vertex`, too: the far side of a thin wall may have the nearer vertex, but not the nearer face. Leaves in `vertex` the corner
/// nearest to that point. Farther than `reach` [m] from the nearest vertex nothing is examined and `triangle` stays -1.
SurfacePoint nearestSurface(const SurfaceModel&, const SurfaceNow&, const Vec3& p, double reach, int& vertex);

/// The nearest point of all the surface, whatever side it is on: exhaustive. `vertex`: any to begin with, then the corner nearest to that point.
/// Where `pieceOf` tells which piece of the surface each vertex belongs to, of the piece of the one begun with: pieces may overlap.
SurfacePoint nearestTriangle(const SurfaceModel&, const SurfaceNow&, const Vec3& p, int& vertex, std::span<const int> pieceOf = {});

/// Exhaustive search for the nearest surface vertex: to start or repair a walk.
int nearestVertex(const SurfaceModel&, const SurfaceNow&, const Vec3& p);

inline Vec3 pointOn(const SurfaceModel& s, std::span<const Vec3> x, int triangle, const std::array<double, 3>& w) {
  const auto& t = s.triangles[triangle];
  return w[0] * x[t[0]] + w[1] * x[t[1]] + w[2] * x[t[2]];
}

}  // namespace halsted
