#include "app/stress/wall_points.h"

#include <cmath>
#include <stdexcept>

namespace halsted::app {
namespace {

/// Barycentric weights of a place in a triangle's own (turn, depth) coordinates; the turn is counted from the place.
bool weightsIn(const TetMesh& mesh, const std::array<int, 3>& corner, double turn, double depth, std::array<double, 3>& weight) {   // [1] [m] [1]
  Eigen::Vector2d at[3];                       // [1] and [m], from the place
  for (int k = 0; k < 3; ++k) {
    at[k] = mesh.uv[corner[k]] - Eigen::Vector2d(turn, depth);
    at[k].x() -= std::round(at[k].x());
  }
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); };
  const double area = cross(at[1] - at[0], at[2] - at[0]);       // [m]
  if (area == 0.0 || std::fabs(at[0].x()) > 0.25) return false;
  weight = {cross(at[1], at[2]) / area, cross(at[2], at[0]) / area, cross(at[0], at[1]) / area};
  return weight[0] > -1e-9 && weight[1] > -1e-9 && weight[2] > -1e-9;
}

}  // namespace

TissuePoint wallPoint(const Model& m, int bowel, WallSide side, double turn, double depth) {
  std::array<double, 3> weight{};
  for (std::size_t f = 0; f < m.surface.triangles.size(); ++f) {
    const auto& corner = m.surface.triangles[f];
    if (m.mesh.triangleLayer[f] != static_cast<int>(side) || m.bowels.of[corner[0]] != bowel) continue;
    if (!weightsIn(m.mesh, corner, turn, depth, weight)) continue;
    TissuePoint p;
    p.tet = m.surface.triangleTet[f];
    for (int c = 0; c < 4; ++c)
      for (int k = 0; k < 3; ++k)
        if (m.tissue.tets[p.tet][c] == corner[k]) p.weight[c] = weight[k];
    return p;
  }
  throw std::out_of_range("the wall does not reach so deep");
}

}  // namespace halsted::app
