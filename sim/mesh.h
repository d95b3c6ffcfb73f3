#pragma once
/// Tetrahedral and triangle meshes as arrays. Built at load time, constant afterwards.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted {

struct TriangleMesh {
  std::vector<Vec3> vertices;                      // [m]
  std::vector<std::array<int, 3>> triangles;       // counter-clockwise from outside
};

/// Where a tet that can be cut lies to the line along which it should be cut.
struct CutMark {
  std::int32_t wall = -1;                          // 0 outer, 1 inner; -1: on neither
  std::int32_t bin = 0;                            // part of the circumference, from 0
  double fromLine = 0.0;                           // [m] at rest: negative on the side that stays, positive on the specimen's, 0 where the line runs through it
};
inline constexpr int kCutWalls = 2;
inline constexpr int kCutFace = 3;                 // of triangleLayer

/// The wall of a tube as tetrahedra. Every tet has positive volume: (x1-x0) x (x2-x0) . (x3-x0) > 0.
struct TetMesh {
  std::vector<Vec3> vertices;                      // [m] rest positions
  std::vector<std::array<int, 4>> tets;
  std::vector<std::array<int, 3>> surface;         // boundary triangles, counter-clockwise from outside the material
  std::vector<int> triangleLayer;                  // per surface triangle: 0 outer, 1 inner (lumen), 2 rim and far end; kCutFace: see sim/contact/surface.h
  std::vector<Eigen::Vector2d> uv;                 // per vertex: (angle / 2 pi, length along the tube [m])
  std::vector<int> fixed;                          // vertices held in place (far end), ascending
  std::vector<int> rim;                            // vertices of the open rim's outer edge, in order around the opening
  std::vector<int> bowel;                          // per vertex: which bowel it belongs to; empty: each connected piece is one
  std::vector<char> cuttable;                      // per tet: 1 = heat can take it away; empty: nothing can be cut
  std::vector<CutMark> cutLine;                    // per tet; empty: no line is planned
};

double volume(const TetMesh&, int tet);            // [m^3] of the rest shape
double volume(const TetMesh&);                     // [m^3]

/// Boundary triangles of a set of tets, oriented outward, in deterministic order (by tet, then face).
std::vector<std::array<int, 3>> boundaryTriangles(const std::vector<std::array<int, 4>>& tets);

/// Corners of the face opposite to corner `opposite`, counter-clockwise seen from outside a tet of positive volume.
std::array<int, 3> faceCorners(const std::array<int, 4>& tet, int opposite);

/// neighbours[t][f] = tet that shares the face opposite to corner f of tet t, or -1 on the boundary.
std::vector<std::array<int, 4>> faceNeighbours(const std::vector<std::array<int, 4>>& tets);

/// Structured block of nx x ny x nz cells, six tets a cell (Kuhn), for validation and benchmarks. size [m].
TetMesh blockMesh(int nx, int ny, int nz, const Vec3& size);

}  // namespace halsted
