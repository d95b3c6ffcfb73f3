#include "sim/tissue/tissue.h"

namespace halsted {
namespace {

constexpr int kMostPieces = 32;                // free ones that part without drag; any beyond these stay in the viscous kerf

double weightOf(const TissueModel& m, int tet) {   // [J] as in the matrix
  return 2.0 * m.material.stiffening * m.material.mu * m.restVolume[tet];
}

Mat3 overRest(const TissueModel& m, const std::vector<Vec3>& field, int tet) {   // field [m] or [m/s]: its gradient, [1] or [1/s]
  const auto& v = m.tets[tet];
  Mat3 edges;
  for (int c = 0; c < 3; ++c) edges.col(c) = field[v[c + 1]] - field[v[0]];
  return edges * m.restInverse[tet];
}

/// The one free piece at this tet, if all its other corners hang on what is held or on nothing; 0: none, or two that part from each other.
int freePieceAt(const TissueModel& m, const TissueState& s, int tet) {
  int piece = 0;
  for (int v : m.tets[tet]) {
    const int own = s.piece[v];
    if (own <= 0 || own == piece) continue;
    if (piece > 0) return 0;
    piece = own;
  }
  return piece <= kMostPieces ? piece : 0;
}

/// Gradient of the field that is one on the piece and zero elsewhere.  [1/m]
Vec3 pieceGradient(const TissueModel& m, const TissueState& s, int tet, int piece) {
  const auto& v = m.tets[tet];
  const auto on = [&](int corner) { return s.piece[v[corner]] == piece ? 1.0 : 0.0; };   // [1]
  Vec3 sum = Vec3::Zero();
  for (int c = 1; c < 4; ++c) sum += (on(c) - on(0)) * m.restInverse[tet].row(c - 1).transpose();
  return sum;
}

/// How fast each free piece leaves: of the motion of the kerf's tets its part in the direction of a rigid parting, orthogonal in the
/// measure in which the kerf resists. What is taken out is then resisted as inertia, the rest as before: neither can give energy.
struct Parting {
  std::array<Vec3, kMostPieces + 1> speed = zeroVectors<kMostPieces + 1>();   // [m/s]
};

Parting partingOf(const TissueModel& m, const TissueState& s) {
  Parting p;
  std::array<double, kMostPieces + 1> resistance{};                    // [N/m]
  for (int t = 0; t < static_cast<int>(m.tets.size()); ++t) {
    const int piece = s.gone[t] ? freePieceAt(m, s, t) : 0;
    if (piece == 0) continue;
    const Vec3 g = pieceGradient(m, s, t, piece);
    p.speed[piece] += weightOf(m, t) * (overRest(m, s.velocity, t) * g);
    resistance[piece] += weightOf(m, t) * g.squaredNorm();
  }
  for (int i = 1; i <= kMostPieces; ++i)
    if (resistance[i] > 0.0) p.speed[i] /= resistance[i];
  return p;
}

}  // namespace

/// V 2 k mu (F - I) g_a in place of V (2 mu target - p R) g_a: what the matrix says of the present place, so that only motion is resisted.
void relaxGone(const TissueModel& m, TissueState& s, TissueWork& w) {
  constexpr int lanes = ProjectiveModel::kLanes;
  const Parting parting = partingOf(m, s);
  for (int t = 0; t < static_cast<int>(m.tets.size()); ++t) {
    if (!s.gone[t]) continue;
    Mat3 target = overRest(m, s.position, t) - Mat3::Identity();       // [1]
    const int piece = freePieceAt(m, s, t);
    if (piece > 0) target += m.dt * parting.speed[piece] * pieceGradient(m, s, t, piece).transpose();
    target *= weightOf(m, t);
    Vec3 first = Vec3::Zero();                                         // [N]
    double* force = &w.scratch[t / lanes * 12 * lanes + t % lanes];
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
