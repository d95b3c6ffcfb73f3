#pragma once
/// A tube's wall as a structured grid, the common form of the procedural and the real colon, and its tetrahedra.
#include <vector>

#include "sim/mesh.h"

namespace halsted::scenes {

/// Outer wall: row 0 is the open rim, the last row the far end; columns run counter-clockwise seen by the surgeon (from the open
/// end, looking down the tube).
struct TubeGrid {
  int around = 0, along = 0;
  std::vector<Vec3> outer;        // [m] row * around + column
  std::vector<Vec3> axis;         // [m] centre of each row, inside the lumen
  std::vector<double> depth;      // [m] per row: length along the tube from the rim

  int at(int row, int column) const { return row * around + (column + around) % around; }
};

/// Vertex of the finished mesh: layer 0 is the outer wall, 1 the inner. Rows are slowest, which keeps the stiffness matrix banded.
inline int wallVertex(const TubeGrid& grid, int row, int column, int layer) { return 2 * grid.at(row, column) + layer; }

/// The cells' tets alone, for a mesh whose vertices stand as `wallVertex` numbers them: kTetsPerCell for each, by row and column.
inline constexpr int kTetsPerCell = 6;
void addWallTets(const TubeGrid&, TetMesh&);

/// The wall as six tets a cell, `wall` thick along the inward normals. Where the normals of a tight fold would turn a tet inside out,
/// they lean toward the axis until none is. Throws InputError when even that leaves a tet without volume.
TetMesh wallMesh(const TubeGrid&, double wall);  // wall [m]

/// Normalised shape of a tet: 1 regular, 0 flat, negative inside out. 6 sqrt(2) V / (root mean square edge)^3.
double tetQuality(const TetMesh&, int tet);      // [1]

}  // namespace halsted::scenes
