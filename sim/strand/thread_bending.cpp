#include "sim/strand/thread_bending.h"

namespace halsted {
namespace {

Vec3 curlAt(const std::vector<Vec3>& x, int i, const NodeBend& bend) {   // [m] over nodes i, i + 1, i + 2
  return bend.weight[0] * x[i] + bend.weight[1] * x[i + 1] + bend.weight[2] * x[i + 2];
}

/// The part of a bend that is elastic.  [1]
double elasticShare(const Vec3& bent, double yield) {   // [m], [m]
  const double size = bent.norm();             // [m]
  return size > yield ? yield / size : 1.0;
}

/// Turned by the smallest rotation that takes unit vector `from` to `to`.
Vec3 carried(const Vec3& v, const Vec3& from, const Vec3& to) {
  const Vec3 axis = from.cross(to);
  const double cosine = from.dot(to);          // [1]
  if (cosine < -0.9) return Vec3::Zero();      // turned back in one step: nothing says which way
  return cosine * v + axis.cross(v) + axis.dot(v) / (1.0 + cosine) * axis;
}

}  // namespace

void assembleBending(const StrandModel& m, const std::vector<Vec3>& iterate, const BendingState& s, BandedMatrix& matrix, std::vector<double>& rhs) {
  for (int i = 0; i + 2 < m.nodes; ++i) {
    if (!s.cut.empty() && (s.cut[i] || s.cut[i + 1])) continue;
    const NodeBend& bend = m.bend[i];
    Vec3 curl = curlAt(iterate, i, bend);
    double kb = bend.stiffness;                // [N/m]
    if (!s.set.empty()) {
      curl -= s.set[i];
      kb *= elasticShare(curl, bend.yield);    // the secant: what yields does not stiffen, and the matrix stays positive
    }
    const auto& c = bend.weight;
    for (int a = 0; a < 3; ++a) {
      for (int b = a; b < 3; ++b)
        for (int r = 0; r < 3; ++r) matrix.add(3 * (i + a) + r, 3 * (i + b) + r, kb * c[a] * c[b]);
      for (int r = 0; r < 3; ++r) rhs[3 * (i + a) + r] += -kb * c[a] * curl[r];
    }
  }
}

void takeSet(const StrandModel& m, const std::vector<Vec3>& before, const std::vector<Vec3>& now, std::vector<Vec3>& set) {
  for (int i = 0; i + 2 < m.nodes; ++i) {
    const NodeBend& bend = m.bend[i];
    if (set[i] != Vec3::Zero()) set[i] = carried(set[i], (before[i + 2] - before[i]).normalized(), (now[i + 2] - now[i]).normalized());
    const Vec3 bent = curlAt(now, i, bend) - set[i];   // [m]
    const double share = elasticShare(bent, bend.yield);
    if (share < 1.0) set[i] += (1.0 - share) * bent;
  }
}

}  // namespace halsted
