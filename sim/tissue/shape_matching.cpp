#include "sim/tissue/substeps.h"
#include "sim/tissue/tissue.h"

/// Overlapping shape matching (Mueller et al. 2005; paper 003) by sums of affine maps (Rivers and James 2007, sec. 4): a particle's
/// moment m x (q, 1) is formed once and added into its clusters; a cluster's map q -> R q + t is added once into its members. That
/// is three vector additions a member and way instead of a matrix product, and what neighbouring clusters have in common is added once.
namespace halsted {
namespace {

constexpr int kLanes = 4;
constexpr int kMap = ShapeMatchingModel::kMap;  // three rows of four: x, y, z of the map's image; columns x, y, z, 1 of its argument

struct Match {
  const ShapeMatchingModel& shape;
  double* rows;                  // x, y, z [m], inverse mass [1/kg] per particle
  double* moment;                // [kg m^2] and, last column, [kg m], kMap per particle, then per shared sum of them
  double* map;                   // kMap per cluster: first the summed moments, then rotation [1] and offset [m]; then per shared sum
  double* quaternion;            // x, y, z, w [1] per cluster
};

/// moment := share * (x - origin) (q, 1)^T
template <typename L> HALSTED_INLINE void formMoments(const Match& d, int particles) {
  for (int i = 0; i < particles; ++i) {
    const L q = loadLanes<L>(d.shape.rest.data() + 4 * i);
    for (int a = 0; a < 3; ++a) {
      const double weighted = d.shape.share[i] * (d.rows[4 * i + a] - d.shape.origin[a]);   // [kg m]
      storeLanes(d.moment + kMap * i + 4 * a, weighted * q);
    }
  }
}

/// Sums the maps at the listed offsets in two chains, even and odd, so that additions overlap.
template <typename L> HALSTED_INLINE void sumMaps(const double* from, const int* offset, int count, L sum[3]) {
  const double* first = from + offset[0];
  L odd[3];
  for (int a = 0; a < 3; ++a) {
    sum[a] = loadLanes<L>(first + 4 * a);
    odd[a] = sum[a] * 0.0;
  }
  int k = 1;
  for (; k + 2 <= count; k += 2) {
    const double *left = from + offset[k], *right = from + offset[k + 1];
    for (int a = 0; a < 3; ++a) {
      odd[a] = odd[a] + loadLanes<L>(left + 4 * a);
      sum[a] = sum[a] + loadLanes<L>(right + 4 * a);
    }
  }
  if (k < count) {
    for (int a = 0; a < 3; ++a) odd[a] = odd[a] + loadLanes<L>(from + offset[k] + 4 * a);
  }
  for (int a = 0; a < 3; ++a) sum[a] = sum[a] + odd[a];
}

/// The sums that several lists have in common, behind their inputs.
template <typename L> HALSTED_INLINE void sumShared(const SumPlan& plan, int inputs, double* maps) {
  double* sum = maps + kMap * inputs;
  for (std::size_t k = 0; k < plan.shared.size(); k += 2, sum += kMap) {
    const double *left = maps + plan.shared[k], *right = maps + plan.shared[k + 1];
    for (int a = 0; a < 3; ++a) storeLanes(sum + 4 * a, loadLanes<L>(left + 4 * a) + loadLanes<L>(right + 4 * a));
  }
}

template <typename L> HALSTED_INLINE LaneMat<L> rotationOf(const LaneRows<L>& q) {
  const L xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z, xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const L wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{1.0 - 2.0 * (yy + zz), 2.0 * (xy + wz), 2.0 * (xz - wy)},
          {2.0 * (xy - wz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz + wx)},
          {2.0 * (xz + wy), 2.0 * (yz - wx), 1.0 - 2.0 * (xx + yy)}};
}

/// One step toward the rotation nearest to A. Torque and trace as in Mueller et al. 2016, eq. 8; where the objective tr(R^T A) is
/// concave about R its Hessian tr(S) I - S, S = sym(A R^T), is inverted, which converges in one or two warm-started steps where the
/// paper's scalar bound halves the error each time. Elsewhere (inverted, flat, line, point) the paper's step is taken.
template <typename L> HALSTED_INLINE void turn(LaneRows<L>& q, const LaneMat<L>& a, double tiny) {   // tiny [kg m^2]
  const LaneMat<L> r = rotationOf(q);
  const LaneVec<L> torque = cross(r.c0, a.c0) + cross(r.c1, a.c1) + cross(r.c2, a.c2);
  const L sxx = a.c0.x * r.c0.x + a.c1.x * r.c1.x + a.c2.x * r.c2.x;
  const L syy = a.c0.y * r.c0.y + a.c1.y * r.c1.y + a.c2.y * r.c2.y;
  const L szz = a.c0.z * r.c0.z + a.c1.z * r.c1.z + a.c2.z * r.c2.z;
  // Off-diagonals of A R^T; their antisymmetric part is the torque.
  const L sxy = a.c0.x * r.c0.y + a.c1.x * r.c1.y + a.c2.x * r.c2.y + 0.5 * torque.z;
  const L sxz = a.c0.x * r.c0.z + a.c1.x * r.c1.z + a.c2.x * r.c2.z - 0.5 * torque.y;
  const L syz = a.c0.y * r.c0.z + a.c1.y * r.c1.z + a.c2.y * r.c2.z + 0.5 * torque.x;

  const L hxx = syy + szz, hyy = sxx + szz, hzz = sxx + syy;           // Hessian's diagonal; off-diagonals are -s
  const L cxx = hyy * hzz - syz * syz, cxy = sxz * syz + sxy * hzz, cxz = sxy * syz + sxz * hyy;
  const L cyy = hxx * hzz - sxz * sxz, cyz = hxx * syz + sxy * sxz, czz = hxx * hyy - sxy * sxy;
  const L det = hxx * cxx - sxy * cxy - sxz * cxz;
  const L bound = magnitude(sxx + syy + szz) + tiny;                   // [kg m^2]
  // Positive definite with room to spare: all three leading minors.
  const L zero = bound * 0.0;
  L scale = selectAbove(det, 1e-6 * bound * bound * bound, 1.0 / selectAbove(det, zero, det, zero + 1.0), zero);
  scale = selectAbove(czz, zero, selectAbove(hxx, zero, scale, zero), zero);
  const L plain = 1.0 / bound;
  // Inlined by force: unoptimised, a call from the AVX2 path to a plain function would pass vectors in two different ways.
  const auto pick = [&](L newton, L simple) __attribute__((always_inline)) {
    return 0.5 * selectAbove(scale, zero, scale * newton, plain * simple);
  };
  const LaneVec<L> w{pick(cxx * torque.x + cxy * torque.y + cxz * torque.z, torque.x),
                     pick(cxy * torque.x + cyy * torque.y + cyz * torque.z, torque.y),
                     pick(cxz * torque.x + cyz * torque.y + czz * torque.z, torque.z)};
  // q <- (1, w/2) q, the rational form of exp(w/2): never turns past half a turn, needs no sine.
  const LaneRows<L> n{q.x + q.w * w.x + (w.y * q.z - w.z * q.y), q.y + q.w * w.y + (w.z * q.x - w.x * q.z),
                      q.z + q.w * w.z + (w.x * q.y - w.y * q.x), q.w - (w.x * q.x + w.y * q.y + w.z * q.z)};
  const L inverse = 1.0 / squareRoot(n.x * n.x + n.y * n.y + n.z * n.z + n.w * n.w);
  q = {inverse * n.x, inverse * n.y, inverse * n.z, inverse * n.w};
}

/// Summed moments of four clusters -> their rigid maps.
template <typename L> HALSTED_INLINE void solveGroup(const Match& d, const int* cluster) {
  const LaneRows<L> centroid = gatherRows<L>(d.shape.restCentroid.data(), cluster);
  int row[3][kLanes];
  for (int a = 0; a < 3; ++a)
    for (int l = 0; l < kLanes; ++l) row[a][l] = 3 * cluster[l] + a;
  const LaneRows<L> mx = gatherRows<L>(d.map, row[0]), my = gatherRows<L>(d.map, row[1]), mz = gatherRows<L>(d.map, row[2]);
  // A = sum m x (q - c0)^T = sum m x q^T - (sum m x) c0^T
  const LaneMat<L> a{{mx.x - mx.w * centroid.x, my.x - my.w * centroid.x, mz.x - mz.w * centroid.x},
                     {mx.y - mx.w * centroid.y, my.y - my.w * centroid.y, mz.y - mz.w * centroid.y},
                     {mx.z - mx.w * centroid.z, my.z - my.w * centroid.z, mz.z - mz.w * centroid.z}};
  LaneRows<L> q = gatherRows<L>(d.quaternion, cluster);
  turn(q, a, 1e-30);
  scatterRows<L>(d.quaternion, cluster, q);
  const LaneMat<L> r = rotationOf(q);
  const L im = centroid.w;                                             // [1/kg]
  const LaneVec<L> t = LaneVec<L>{im * mx.w, im * my.w, im * mz.w} - (centroid.x * r.c0 + centroid.y * r.c1 + centroid.z * r.c2);
  scatterRows<L>(d.map, row[0], LaneRows<L>{r.c0.x, r.c1.x, r.c2.x, t.x});
  scatterRows<L>(d.map, row[1], LaneRows<L>{r.c0.y, r.c1.y, r.c2.y, t.y});
  scatterRows<L>(d.map, row[2], LaneRows<L>{r.c0.z, r.c1.z, r.c2.z, t.z});
}

/// x moves by `resistance` of the way to the mean goal of the particle's clusters.
template <typename L> HALSTED_INLINE void moveToGoals(const Match& d, int particles) {
  const ShapeMatchingModel& s = d.shape;
  const double rows[8] = {s.resistance, s.resistance, s.resistance, 0.0, s.origin.x(), s.origin.y(), s.origin.z(), 0.0};
  const L stiffness = loadLanes<L>(rows), origin = loadLanes<L>(rows + 4);   // the fourth lane, inverse mass, stays
  for (int i = 0; i < particles; ++i) {
    double* row = d.rows + 4 * i;
    if (row[3] == 0.0) continue;                                       // held in place
    const int first = s.spread.start[i], owners = s.ownerStart[i + 1] - s.ownerStart[i];
    L sum[3];
    sumMaps<L>(d.map, &s.spread.node[first], s.spread.start[i + 1] - first, sum);
    const L q = loadLanes<L>(&s.rest[4 * i]);
    const LaneRows<L> product = transpose(LaneRows<L>{sum[0] * q, sum[1] * q, sum[2] * q, q});
    const L goal = (1.0 / owners) * (product.x + product.y + product.z + product.w) + origin;
    const L x = loadLanes<L>(row);
    storeLanes(row, x + stiffness * (goal - x));
  }
}

template <typename L> HALSTED_INLINE void iterate(const Match& d) {
  const ShapeMatchingModel& s = d.shape;
  const int particles = static_cast<int>(s.share.size()), clusters = static_cast<int>(s.clusterStart.size()) - 1;
  formMoments<L>(d, particles);
  sumShared<L>(s.gather, particles, d.moment);
  for (int c = 0; c < clusters; ++c) {
    L sum[3];
    sumMaps<L>(d.moment, &s.gather.node[s.gather.start[c]], s.gather.start[c + 1] - s.gather.start[c], sum);
    for (int a = 0; a < 3; ++a) storeLanes(d.map + kMap * c + 4 * a, sum[a]);
  }
  for (int c = 0; c < clusters; c += kLanes) {
    // The last group repeats the last cluster: its lanes write the same bits.
    const int last = clusters - 1, cluster[kLanes] = {c, c + 1 < last ? c + 1 : last, c + 2 < last ? c + 2 : last, c + 3 < last ? c + 3 : last};
    solveGroup<L>(d, cluster);
  }
  sumShared<L>(s.spread, clusters, d.map);
  moveToGoals<L>(d, particles);
}

void iterateSerial(const Match& d) { iterate<Serial4>(d); }
__attribute__((target("avx2"))) void iterateWide(const Match& d) { iterate<Lanes4>(d); }

}  // namespace

void predictShapeMatching(const TissueModel& m, std::span<const Vec3> force, TissueState& s, TissueWork& w) {
  const ShapeMatchingModel& shape = m.shape;
  const double h = m.dt / shape.substeps;                              // [s]
  double* const scratch = alignRow(w.scratch.data());
  const Match data{shape, w.rows.data(), scratch, scratch + kMap * (m.mass.size() + shape.gather.shared.size() / 2),
                   s.rotation[0].coeffs().data()};
  for (int k = 0; k < shape.substeps; ++k) {
    beginSubstep(m, force, h, s, w);
    for (int i = 0; i < shape.iterations; ++i) {
      switch (shape.path) {
        case LanePath::kSerial: iterateSerial(data); break;
        case LanePath::kWide: iterateWide(data); break;
      }
    }
    endSubstep(h, s, w);
  }
  endSubsteps(m, s, w);
}

}  // namespace halsted
