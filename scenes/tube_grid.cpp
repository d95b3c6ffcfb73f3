#include "scenes/tube_grid.h"

#include <algorithm>
#include <cmath>

#include "scenes/scene.h"

namespace halsted::scenes {
namespace {

constexpr double kLeastQuality = 0.05;  // [1] below it a tet is mended; tuned: the procedural colon's worst is 0.5
constexpr int kMendRounds = 40;
constexpr double kLeanStep = 0.1;       // [1] of the way to the axis per round

/// Corner bits: 1 = next column, 2 = next row, 4 = inner layer. These axes are right-handed, so the even permutations are positive.
constexpr int kKuhnTets[kTetsPerCell][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

/// Inward unit direction per grid vertex: central differences of the grid; in the plane of the cut at both ends, so that the cuts
/// stay flat.
std::vector<Vec3> inwardNormals(const TubeGrid& grid) {
  std::vector<Vec3> normals(grid.outer.size());
  for (int row = 0; row < grid.along; ++row) {
    const int above = std::max(row - 1, 0), below = std::min(row + 1, grid.along - 1);
    const bool end = row == 0 || row == grid.along - 1;
    const Vec3 axis = (grid.axis[below] - grid.axis[above]).normalized();
    for (int column = 0; column < grid.around; ++column) {
      const Vec3 across = grid.outer[grid.at(row, column + 1)] - grid.outer[grid.at(row, column - 1)];
      const Vec3 down = end ? axis : Vec3(grid.outer[grid.at(below, column)] - grid.outer[grid.at(above, column)]);
      normals[grid.at(row, column)] = across.cross(down).normalized();
    }
  }
  return normals;
}

Vec3 towardAxis(const TubeGrid& grid, int row, int column) {
  return (grid.axis[row] - grid.outer[grid.at(row, column)]).normalized();
}

/// Averages each direction with its neighbours: neighbouring columns of the wall must not cross in a fold.
void smooth(const TubeGrid& grid, std::vector<Vec3>& directions) {
  const std::vector<Vec3> before = directions;
  for (int row = 1; row + 1 < grid.along; ++row) {
    for (int column = 0; column < grid.around; ++column) {
      const Vec3 sum = 4.0 * before[grid.at(row, column)] + before[grid.at(row, column - 1)] + before[grid.at(row, column + 1)] +
                       before[grid.at(row - 1, column)] + before[grid.at(row + 1, column)];
      if (sum.norm() > 1e-9) directions[grid.at(row, column)] = sum.normalized();
    }
  }
}

void placeVertices(const TubeGrid& grid, const std::vector<Vec3>& directions, double wall, TetMesh& mesh) {
  mesh.vertices.resize(2 * grid.outer.size());
  for (std::size_t i = 0; i < grid.outer.size(); ++i) {
    mesh.vertices[2 * i] = grid.outer[i];
    mesh.vertices[2 * i + 1] = grid.outer[i] + wall * directions[i];
  }
}

/// Leans the directions of every bad tet's corners toward the axis. Returns the number of bad tets.
int leanBadTets(const TubeGrid& grid, const TetMesh& mesh, std::vector<Vec3>& directions) {
  int bad = 0;
  std::vector<char> lean(directions.size(), 0);
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
    if (tetQuality(mesh, t) >= kLeastQuality) continue;
    ++bad;
    for (int corner : mesh.tets[t]) lean[corner / 2] = 1;
  }
  for (std::size_t i = 0; i < lean.size(); ++i) {
    if (!lean[i]) continue;
    const int row = static_cast<int>(i) / grid.around, column = static_cast<int>(i) % grid.around;
    const Vec3 leaned = (1.0 - kLeanStep) * directions[i] + kLeanStep * towardAxis(grid, row, column);
    if (leaned.norm() > 1e-9) directions[i] = leaned.normalized();
  }
  return bad;
}

void addSurface(const TubeGrid& grid, TetMesh& mesh) {
  mesh.surface = boundaryTriangles(mesh.tets);
  for (const auto& triangle : mesh.surface) {
    int inner = 0;
    for (int vertex : triangle) inner += vertex & 1;
    mesh.triangleLayer.push_back(inner == 0 ? 0 : inner == 3 ? 1 : 2);
  }
  for (int row = 0; row < grid.along; ++row)
    for (int column = 0; column < grid.around; ++column)
      for (int layer = 0; layer < 2; ++layer) mesh.uv.emplace_back(static_cast<double>(column) / grid.around, grid.depth[row]);
  for (int column = 0; column < grid.around; ++column) {
    mesh.rim.push_back(wallVertex(grid, 0, column, 0));
    for (int layer = 0; layer < 2; ++layer) mesh.fixed.push_back(wallVertex(grid, grid.along - 1, column, layer));
  }
}

}  // namespace

void addWallTets(const TubeGrid& grid, TetMesh& mesh) {
  for (int row = 0; row + 1 < grid.along; ++row) {
    for (int column = 0; column < grid.around; ++column) {
      std::array<int, 8> corner;
      for (int c = 0; c < 8; ++c) corner[c] = wallVertex(grid, row + (c >> 1 & 1), column + (c & 1), c >> 2);
      for (const auto& tet : kKuhnTets) mesh.tets.push_back({corner[tet[0]], corner[tet[1]], corner[tet[2]], corner[tet[3]]});
    }
  }
}

double tetQuality(const TetMesh& mesh, int tet) {
  const auto& corners = mesh.tets[tet];
  double squares = 0.0;  // [m^2]
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) squares += (mesh.vertices[corners[i]] - mesh.vertices[corners[j]]).squaredNorm();
  const double edge = std::sqrt(squares / 6.0);  // [m]
  return edge > 0.0 ? 6.0 * std::sqrt(2.0) * volume(mesh, tet) / (edge * edge * edge) : 0.0;
}

TetMesh wallMesh(const TubeGrid& grid, double wall) {
  TetMesh mesh;
  addWallTets(grid, mesh);
  std::vector<Vec3> directions = inwardNormals(grid);
  int bad = 0;
  for (int round = 0; round < kMendRounds; ++round) {
    placeVertices(grid, directions, wall, mesh);
    bad = leanBadTets(grid, mesh, directions);
    if (bad == 0) break;
    smooth(grid, directions);
  }
  if (bad > 0) throw InputError(std::to_string(bad) + " of " + std::to_string(mesh.tets.size()) +
                                " wall tetrahedra turn inside out: the wall is too thick for this surface's folds");
  addSurface(grid, mesh);
  return mesh;
}

}  // namespace halsted::scenes
