#include "sim/tissue/tissue.h"

namespace halsted {

/// V 2 k mu (F - I) g_a in place of V (2 mu target - p R) g_a: what the matrix says of the present place, so that only motion is resisted.
void relaxGone(const TissueModel& m, TissueState& s, TissueWork& w) {
  constexpr int lanes = ProjectiveModel::kLanes;
  for (std::size_t t = 0; t < m.tets.size(); ++t) {
    if (!s.gone[t]) continue;
    const auto& v = m.tets[t];
    Mat3 edges;                                                        // [m]
    for (int c = 0; c < 3; ++c) edges.col(c) = s.position[v[c + 1]] - s.position[v[0]];
    const double weight = 2.0 * m.material.stiffening * m.material.mu * m.restVolume[t];   // [J]
    const Mat3 target = weight * (edges * m.restInverse[t] - Mat3::Identity());
    Vec3 first = Vec3::Zero();                                         // [N]
    double* force = &w.scratch[(t / lanes * 4 * 3) * lanes + t % lanes];
    for (int a = 1; a < 4; ++a) {
      const Vec3 f = target * m.restInverse[t].row(a - 1).transpose();
      for (int axis = 0; axis < 3; ++axis) force[(a * 3 + axis) * lanes] = f[axis];
      first -= f;
    }
    for (int axis = 0; axis < 3; ++axis) force[axis * lanes] = first[axis];
    s.pressure[t] = 0.0;
  }
}

}  // namespace halsted
