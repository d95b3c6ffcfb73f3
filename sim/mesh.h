#pragma once
/// Tetrahedral and triangle meshes as arrays. Built at load time, constant afterwards.
#include <array>
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted {

struct TriangleMesh {
  std::vector<Vec3> vertices;                      // [m]
  std::vector<std::array<int, 3>> triangles;       // counter-clockwise from outside
};

/// The wall of a tube as tetrahedra. Every tet has positive volume: (x1-x0) x (x2-x0) . (x3-x0) > 0.
struct TetMesh {
  std::vector<Vec3> vertices;                      // [m] rest positions
  std::vector<std::array<int, 4>> tets;
  std::vector<std::array<int, 3>> surface;         // boundary triangles, counter-clockwise from outside the material
  std::vector<int> triangleLayer;                  // per surface triangle: 0 outer, 1 inner (lumen), 2 rim and far end
  std::vector<Eigen::Vector2d> uv;                 // per vertex: (angle / 2 pi, length along the tube [m])
  std::vector<int> fixed;                          // vertices held in place (far end), ascending
  std::vector<int> rim;                            // vertices of the open rim's outer edge, in order around the opening
  std::vector<int> bowel;                          // per vertex: which bowel it belongs to; empty: each connected piece is one
};

double volume(const TetMesh&, int tet);            // [m^3] of the rest shape
double volume(const TetMesh&);                     // [m^3]

/// Boundary triangles of a set of tets, oriented outward, in deterministic order (by tet, then face).
std::vector<std::array<int, 3>> boundaryTriangles(const std::vector<std::array<int, 4>>& tets);

/// neighbours[t][f] = tet that shares the face opposite to corner f of tet t, or -1 on the boundary.
std::vector<std::array<int, 4>> faceNeighbours(const std::vector<std::array<int, 4>>& tets);

/// Structured block of nx x ny x nz cells, six tets a cell (Kuhn), for validation and benchmarks. size [m].
TetMesh blockMesh(int nx, int ny, int nz, const Vec3& size);

}  // namespace halsted
