#include "sim/suture/tissue_point.h"

#include "sim/model.h"

namespace halsted {

Vec3 pointOf(const Model& m, const TissuePoint& p, std::span<const Vec3> x) {
  const auto& v = m.tissue.tets[p.tet];
  return p.weight[0] * x[v[0]] + p.weight[1] * x[v[1]] + p.weight[2] * x[v[2]] + p.weight[3] * x[v[3]];
}

double complianceBetween(const Model& m, const TissuePoint& a, const TissuePoint& b) {
  double sum = 0.0;                            // [m/N]
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      sum += a.weight[i] * b.weight[j] * compliance(m.tissue.projective, m.tissue.tets[a.tet][i], m.tissue.tets[b.tet][j]);
  return sum;
}

double wallShare(const Model& m, const TissuePoint& p) {
  double share = 0.0;                          // [1]
  for (int c = 0; c < 4; ++c) share += p.weight[c] * m.bowels.wallDepth[m.tissue.tets[p.tet][c]];
  return share;
}

}  // namespace halsted
