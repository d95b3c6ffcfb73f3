#include "sim/tissue/tissue.h"
#include "sim/tissue/substeps.h"

namespace halsted {
namespace {

constexpr int kLanes = XpbdModel::kLanes;

struct Sweep {
  const int* vertex;             // [corner][lane]
  const double* restInverse;     // [1/m] [9][lane]
  const double* inverseVolume;   // [1/m^3] [lane]
  double* rows;                  // x, y, z [m], inverse mass [1/kg] per particle
  double deviatoric, volumetric; // [1/(Pa s^2)] 1 / (mu h^2), 1 / (lambda h^2)
  double restDeterminant;        // [1] 1 + mu / lambda: makes the rest state stress-free
  const double* held;            // [1] [lane] 1, or 0 where the tet is gone; nullptr: none is gone here
};

template <typename L> struct Corner { LaneVec<L> x; L w; };

template <typename L> HALSTED_INLINE Corner<L> loadCorner(const Sweep& s, int c) {
  const LaneRows<L> r = gatherRows<L>(s.rows, s.vertex + c * kLanes);
  return {{r.x, r.y, r.z}, r.w};
}

template <typename L> HALSTED_INLINE void storeCorner(const Sweep& s, int c, const Corner<L>& corner, const LaneVec<L>& dx) {
  const LaneVec<L> x = corner.x + corner.w * dx;
  scatterRows<L>(s.rows, s.vertex + c * kLanes, LaneRows<L>{x.x, x.y, x.z, corner.w});
}

/// Both constraints of four tets, as a 2x2 block (Macklin and Mueller 2021, eqs. 10 to 13 and section 3.3):
///   C_D = |F|,  C_H = det F - (1 + mu/lambda),  (grad C M^-1 grad C^T + alpha) dlambda = -C.
template <typename L> HALSTED_INLINE void projectGroup(const Sweep& s) {
  const Corner<L> p0 = loadCorner<L>(s, 0), p1 = loadCorner<L>(s, 1), p2 = loadCorner<L>(s, 2), p3 = loadCorner<L>(s, 3);
  const LaneVec<L> e1 = p1.x - p0.x, e2 = p2.x - p0.x, e3 = p3.x - p0.x;
  L b[9];
  for (int e = 0; e < 9; ++e) b[e] = loadLanes<L>(s.restInverse + e * kLanes);
  const LaneMat<L> f{b[0] * e1 + b[3] * e2 + b[6] * e3, b[1] * e1 + b[4] * e2 + b[7] * e3, b[2] * e1 + b[5] * e2 + b[8] * e3};
  const LaneMat<L> cof{cross(f.c1, f.c2), cross(f.c2, f.c0), cross(f.c0, f.c1)};
  // 1e-24: a tet collapsed to a point has no direction to grow in, but stays finite.
  const L norm = squareRoot(dot(f.c0, f.c0) + dot(f.c1, f.c1) + dot(f.c2, f.c2) + 1e-24);
  const L inverse = 1.0 / norm;
  const L ch = dot(f.c0, cof.c0) - s.restDeterminant;

  const LaneVec<L> d1 = inverse * (b[0] * f.c0 + b[1] * f.c1 + b[2] * f.c2);
  const LaneVec<L> d2 = inverse * (b[3] * f.c0 + b[4] * f.c1 + b[5] * f.c2);
  const LaneVec<L> d3 = inverse * (b[6] * f.c0 + b[7] * f.c1 + b[8] * f.c2);
  const LaneVec<L> d0 = d1 + d2 + d3;                                  // minus the gradient at corner 0
  const LaneVec<L> h1 = b[0] * cof.c0 + b[1] * cof.c1 + b[2] * cof.c2;
  const LaneVec<L> h2 = b[3] * cof.c0 + b[4] * cof.c1 + b[5] * cof.c2;
  const LaneVec<L> h3 = b[6] * cof.c0 + b[7] * cof.c1 + b[8] * cof.c2;
  const LaneVec<L> h0 = h1 + h2 + h3;

  const L iv = loadLanes<L>(s.inverseVolume);
  const L dd = p0.w * dot(d0, d0) + p1.w * dot(d1, d1) + p2.w * dot(d2, d2) + p3.w * dot(d3, d3) + s.deviatoric * iv;
  const L dh = p0.w * dot(d0, h0) + p1.w * dot(d1, h1) + p2.w * dot(d2, h2) + p3.w * dot(d3, h3);
  const L hh = p0.w * dot(h0, h0) + p1.w * dot(h1, h1) + p2.w * dot(h2, h2) + p3.w * dot(h3, h3) + s.volumetric * iv;
  const L scale = 1.0 / (dd * hh - dh * dh);                           // positive: a Gram matrix plus a positive diagonal
  L ld = scale * (dh * ch - hh * norm);
  L lh = scale * (dh * norm - dd * ch);
  if (s.held) {                                                        // tets that are gone hold nothing
    const L held = loadLanes<L>(s.held);
    ld = held * ld;
    lh = held * lh;
  }
  storeCorner<L>(s, 0, p0, (-ld) * d0 - lh * h0);
  storeCorner<L>(s, 1, p1, ld * d1 + lh * h1);
  storeCorner<L>(s, 2, p2, ld * d2 + lh * h2);
  storeCorner<L>(s, 3, p3, ld * d3 + lh * h3);
}

/// False where no tet of the group is gone.
HALSTED_INLINE bool markGone(const XpbdModel& x, int group, const std::vector<std::uint8_t>& gone, double* held) {   // [1]
  bool any = false;
  for (int lane = 0; lane < kLanes; ++lane) {
    const bool away = gone[x.laneTet[group * kLanes + lane]] != 0;
    held[lane] = away ? 0.0 : 1.0;
    any = any || away;
  }
  return any;
}

template <typename L> HALSTED_INLINE void sweep(const XpbdModel& x, Sweep s, const std::vector<std::uint8_t>& gone) {
  double held[kLanes];                                                 // [1]
  const int* vertex = s.vertex;
  const double *restInverse = s.restInverse, *inverseVolume = s.inverseVolume;   // [1/m], [1/m^3]
  for (int g = 0; g < x.groups; ++g) {
    s.vertex = vertex + g * 4 * kLanes;
    s.restInverse = restInverse + g * 9 * kLanes;
    s.inverseVolume = inverseVolume + g * kLanes;
    s.held = !gone.empty() && markGone(x, g, gone, held) ? held : nullptr;
    projectGroup<L>(s);
  }
}

using GoneTets = std::vector<std::uint8_t>;
void sweepSerial(const XpbdModel& x, const Sweep& s, const GoneTets& gone) { sweep<Serial4>(x, s, gone); }
__attribute__((target("avx2"))) void sweepWide(const XpbdModel& x, const Sweep& s, const GoneTets& gone) { sweep<Lanes4>(x, s, gone); }

}  // namespace

void predictXpbd(const TissueModel& m, std::span<const Vec3> force, TissueState& s, TissueWork& w) {
  const XpbdModel& x = m.xpbd;
  const double h = m.dt / x.substeps;                                  // [s]
  // The model's lambda is Lame's plus mu, or the linear response would be softer than E and nu say (Smith et al. 2018, sec. 3.4).
  const double lambda = m.material.lambda + m.material.mu;             // [Pa]
  const Sweep data{x.laneVertex.data(), x.laneRestInverse.data(), x.laneInverseVolume.data(), w.rows.data(),
                   1.0 / (m.material.mu * h * h), 1.0 / (lambda * h * h), 1.0 + m.material.mu / lambda, nullptr};
  for (int k = 0; k < x.substeps; ++k) {
    beginSubstep(m, force, h, s, w);
    switch (x.path) {
      case LanePath::kSerial: sweepSerial(x, data, s.gone); break;
      case LanePath::kWide: sweepWide(x, data, s.gone); break;
    }
    endSubstep(h, s, w);
  }
  endSubsteps(m, s, w);
}

}  // namespace halsted
