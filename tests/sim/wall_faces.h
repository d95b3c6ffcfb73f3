#pragma once
/// The faces of the wall of tests/sim/step_rig.h, named as an organ's mesh names them.
#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/suture/edge_exit.h"
#include "tests/sim/step_rig.h"

namespace halsted {

/// Of each triangle: 0 at x = 0, the serosa; 1 at the other face, the mucosa; all round it is edge.
inline std::vector<int> wallFaces(const TetMesh& mesh, const SurfaceModel& surface, double thickness = kWallX) {   // [m]
  std::vector<int> layer(surface.triangles.size(), kEdgeFace);
  for (std::size_t f = 0; f < layer.size(); ++f)
    for (const int face : {0, 1}) {
      const auto& t = surface.triangles[f];
      if (std::all_of(t.begin(), t.end(), [&](int v) { return std::fabs(mesh.vertices[v].x() - face * thickness) < 1e-9; })) layer[f] = face;
    }
  return layer;
}

}  // namespace halsted
