#include <algorithm>

#include "sim/tissue/substeps.h"
#include "sim/tissue/tissue.h"

/// Overlapping shape matching (Mueller et al. 2005; paper 003) by sums of affine maps (Rivers and James 2007, sec. 4): a particle's
/// moment m x (q, 1) is formed once and added into its clusters; a cluster's map q -> R q + t is added once into its members. That
/// is three vector additions a member and way instead of a matrix product, and what neighbouring clusters have in common is added once.
namespace halsted {
namespace {

constexpr int kLanes = SumPlan::kLists;
static_assert(kLanes == 4);
constexpr int kMap = ShapeMatchingModel::kMap;  // three rows of four: x, y, z of the map's image; columns x, y, z, 1 of its argument

struct Match {
  const ShapeMatchingModel& shape;
  double* rows;                  // x, y, z [m], inverse mass [1/kg] per particle
  double* moment;                // [kg m^2] and, last column, [kg m], kMap per particle, then per shared sum of them, then zeros
  double* map;                   // rotation [1] and offset [m], kMap per cluster, then per shared sum of them, then zeros
  double* quaternion;            // x, y, z, w [1] per cluster
};

/// moment := mass * (x - origin) (q, 1)^T / owners
template <typename L> HALSTED_INLINE void formMoments(const Match& d, int particles) {
  const double *rest = d.shape.rest.data(), *mass = d.shape.mass.data(), *row = d.rows;
  const Vec3 origin = d.shape.origin;
  double* moment = d.moment;
  for (int i = 0; i < particles; ++i, rest += 4, row += 4, moment += kMap) {
    const L q = loadLanes<L>(rest);
    for (int a = 0; a < 3; ++a) storeLanes(moment + 4 * a, mass[i] * (row[a] - origin[a]) * q);
  }
}

/// The sums that several lists have in common, behind their inputs.
template <typename L> HALSTED_INLINE void sumShared(const SumPlan& plan, int inputs, double* maps) {
  double* sum = maps + kMap * inputs;
  const int *pair = plan.shared.data(), *end = pair + plan.shared.size();
  for (; pair != end; pair += 2, sum += kMap) {
    const double *left = maps + pair[0], *right = maps + pair[1];
    for (int a = 0; a < 3; ++a) storeLanes(sum + 4 * a, loadLanes<L>(left + 4 * a) + loadLanes<L>(right + 4 * a));
  }
  for (int a = 0; a < kMap; ++a) sum[a] = 0.0;                         // the empty map
}

/// The sums of four lists side by side: twelve chains of additions that do not wait for each other.
template <typename L> HALSTED_INLINE void sumFour(const SumPlan& plan, int group, const double* maps, L (&sum)[kLanes][3]) {
  const int *node = plan.node.data() + plan.start[group], *end = plan.node.data() + plan.start[group + 1];
  for (int l = 0; l < kLanes; ++l)
    for (int a = 0; a < 3; ++a) sum[l][a] = loadLanes<L>(maps + node[l] + 4 * a);
  for (node += kLanes; node != end; node += kLanes) {
    for (int l = 0; l < kLanes; ++l)
      for (int a = 0; a < 3; ++a) sum[l][a] = sum[l][a] + loadLanes<L>(maps + node[l] + 4 * a);
  }
}

/// Row `a` of four maps -> its entries, four lanes each.
template <typename L> HALSTED_INLINE LaneRows<L> entriesOf(const L (&sum)[kLanes][3], int a) {
  return transpose(LaneRows<L>{sum[0][a], sum[1][a], sum[2][a], sum[3][a]});
}

/// The rotation of a quaternion of any length; scale = 2 / length^2.
template <typename L, typename S> HALSTED_INLINE LaneMat<L> rotationOf(const LaneRows<L>& q, const S& scale) {
  const L x = scale * q.x, y = scale * q.y, z = scale * q.z;
  const L xx = x * q.x, yy = y * q.y, zz = z * q.z, xy = x * q.y, xz = x * q.z, yz = y * q.z;
  const L wx = x * q.w, wy = y * q.w, wz = z * q.w;
  return {{1.0 - (yy + zz), xy + wz, xz - wy}, {xy - wz, 1.0 - (xx + zz), yz + wx}, {xz + wy, yz - wx, 1.0 - (xx + yy)}};
}

/// One step toward the rotation nearest to A. Torque and trace as in Mueller et al. 2016, eq. 8; where the objective tr(R^T A) is
/// concave about R its Hessian tr(S) I - S, S = sym(A R^T), is inverted, which converges in one or two warm-started steps where the
/// paper's scalar bound halves the error each time. Elsewhere (inverted, flat, line, point) the paper's step is taken.
/// The quaternion comes back longer than one.
template <typename L> HALSTED_INLINE LaneRows<L> turn(const LaneRows<L>& q, const LaneMat<L>& a, double tiny) {   // tiny [kg m^2]
  const LaneMat<L> r = rotationOf(q, 2.0);
  const LaneVec<L> ax{a.c0.x, a.c1.x, a.c2.x}, ay{a.c0.y, a.c1.y, a.c2.y}, az{a.c0.z, a.c1.z, a.c2.z};   // rows
  const LaneVec<L> rx{r.c0.x, r.c1.x, r.c2.x}, ry{r.c0.y, r.c1.y, r.c2.y}, rz{r.c0.z, r.c1.z, r.c2.z};
  // B = A R^T: its symmetric part makes the Hessian, its antisymmetric part is the torque.
  const L bxx = dot(ax, rx), bxy = dot(ax, ry), bxz = dot(ax, rz);
  const L byx = dot(ay, rx), byy = dot(ay, ry), byz = dot(ay, rz);
  const L bzx = dot(az, rx), bzy = dot(az, ry), bzz = dot(az, rz);
  const LaneVec<L> torque{bzy - byz, bxz - bzx, byx - bxy};
  const L sxy = 0.5 * (bxy + byx), sxz = 0.5 * (bxz + bzx), syz = 0.5 * (byz + bzy);

  const L hxx = byy + bzz, hyy = bxx + bzz, hzz = bxx + byy;           // Hessian's diagonal; off-diagonals are -s
  const L cxx = hyy * hzz - syz * syz, cxy = sxz * syz + sxy * hzz, cxz = sxy * syz + sxz * hyy;
  const L cyy = hxx * hzz - sxz * sxz, cyz = hxx * syz + sxy * sxz, czz = hxx * hyy - sxy * sxy;
  const L det = hxx * cxx - sxy * cxy - sxz * cxz;
  const L bound = magnitude(bxx + hxx) + tiny;                         // [kg m^2]
  // Positive definite with room to spare, all three leading minors, or zero.
  const L zero = bound * 0.0;
  const L minors = selectAbove(czz, zero, selectAbove(hxx, zero, det, zero), zero);
  const L definite = selectAbove(minors, 1e-6 * bound * bound * bound, det, zero);
  const L half = 0.5 / selectAbove(definite, zero, definite, bound);
  const LaneVec<L> w{half * selectAbove(definite, zero, cxx * torque.x + cxy * torque.y + cxz * torque.z, torque.x),
                     half * selectAbove(definite, zero, cxy * torque.x + cyy * torque.y + cyz * torque.z, torque.y),
                     half * selectAbove(definite, zero, cxz * torque.x + cyz * torque.y + czz * torque.z, torque.z)};
  // q <- (1, w/2) q, the rational form of exp(w/2): never turns past half a turn, needs no sine.
  return {q.x + q.w * w.x + (w.y * q.z - w.z * q.y), q.y + q.w * w.y + (w.z * q.x - w.x * q.z),
          q.z + q.w * w.z + (w.x * q.y - w.y * q.x), q.w - (w.x * q.x + w.y * q.y + w.z * q.z)};
}

/// Four clusters: their summed moments -> their rigid maps.
template <typename L> HALSTED_INLINE void solveGroup(const Match& d, int group, const int* cluster) {
  L sum[kLanes][3];
  sumFour<L>(d.shape.gather, group, d.moment, sum);
  const LaneRows<L> mx = entriesOf(sum, 0), my = entriesOf(sum, 1), mz = entriesOf(sum, 2);
  const double* centre = d.shape.laneCentre.data() + 4 * kLanes * group;
  const LaneVec<L> c{loadLanes<L>(centre), loadLanes<L>(centre + kLanes), loadLanes<L>(centre + 2 * kLanes)};   // [m]
  const L inverseMass = loadLanes<L>(centre + 3 * kLanes);             // [1/kg]
  // A = sum m x (q - c)^T = sum m x q^T - (sum m x) c^T
  const LaneVec<L> weighted{mx.w, my.w, mz.w};                         // [kg m]
  const LaneMat<L> a{LaneVec<L>{mx.x, my.x, mz.x} - c.x * weighted, LaneVec<L>{mx.y, my.y, mz.y} - c.y * weighted,
                     LaneVec<L>{mx.z, my.z, mz.z} - c.z * weighted};
  const LaneRows<L> q = turn(gatherRows<L>(d.quaternion, cluster), a, 1e-30);
  const L square = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, scale = 2.0 / square;
  const LaneMat<L> r = rotationOf(q, scale);                           // need not wait for the root
  const L unit = 0.5 * scale * squareRoot(square);
  scatterRows<L>(d.quaternion, cluster, LaneRows<L>{unit * q.x, unit * q.y, unit * q.z, unit * q.w});
  const LaneVec<L> t = inverseMass * weighted - (c.x * r.c0 + c.y * r.c1 + c.z * r.c2);
  int row[3][kLanes];
  for (int k = 0; k < 3; ++k)
    for (int l = 0; l < kLanes; ++l) row[k][l] = 3 * cluster[l] + k;
  scatterRows<L>(d.map, row[0], LaneRows<L>{r.c0.x, r.c1.x, r.c2.x, t.x});
  scatterRows<L>(d.map, row[1], LaneRows<L>{r.c0.y, r.c1.y, r.c2.y, t.y});
  scatterRows<L>(d.map, row[2], LaneRows<L>{r.c0.z, r.c1.z, r.c2.z, t.z});
}

/// Four particles: x moves by `resistance` of the way to the mean goal of the particle's clusters.
template <typename L> HALSTED_INLINE void moveGroup(const Match& d, int group, int particles) {
  const ShapeMatchingModel& s = d.shape;
  L sum[kLanes][3], product[3];
  sumFour<L>(s.spread, group, d.map, sum);
  const int first = kLanes * group, last = std::min(first + kLanes, particles);
  for (int a = 0; a < 3; ++a) {
    L scaled[kLanes][3];
    for (int l = 0; l < kLanes; ++l) scaled[l][a] = sum[l][a] * loadLanes<L>(&s.rest[4 * std::min(first + l, particles - 1)]);
    const LaneRows<L> p = entriesOf(scaled, a);
    product[a] = (p.x + p.y) + (p.z + p.w);
  }
  const LaneRows<L> goal = transpose(LaneRows<L>{product[0], product[1], product[2], product[2]});
  const L* goals[kLanes] = {&goal.x, &goal.y, &goal.z, &goal.w};
  const double rows[8] = {s.resistance, s.resistance, s.resistance, 0.0, s.origin.x(), s.origin.y(), s.origin.z(), 0.0};
  const L stiffness = loadLanes<L>(rows), origin = loadLanes<L>(rows + 4);   // the fourth lane, inverse mass, stays
  for (int i = first; i < last; ++i) {
    double* row = d.rows + 4 * i;
    if (row[3] == 0.0) continue;                                       // held in place
    const L x = loadLanes<L>(row);
    storeLanes(row, x + stiffness * (*goals[i - first] + origin - x));
  }
}

template <typename L> HALSTED_INLINE void iterate(const Match& d) {
  const ShapeMatchingModel& s = d.shape;
  const int particles = static_cast<int>(s.mass.size()), clusters = static_cast<int>(s.clusterStart.size()) - 1;
  formMoments<L>(d, particles);
  sumShared<L>(s.gather, particles, d.moment);
  for (int g = 0; kLanes * g < clusters; ++g) {
    // The last group repeats the last cluster: its lanes write the same bits.
    int cluster[kLanes];
    for (int l = 0; l < kLanes; ++l) cluster[l] = std::min(kLanes * g + l, clusters - 1);
    solveGroup<L>(d, g, cluster);
  }
  sumShared<L>(s.spread, clusters, d.map);
  for (int g = 0; kLanes * g < particles; ++g) moveGroup<L>(d, g, particles);
}

void iterateSerial(const Match& d) { iterate<Serial4>(d); }
__attribute__((target("avx2"))) void iterateWide(const Match& d) { iterate<Lanes4>(d); }

}  // namespace

void predictShapeMatching(const TissueModel& m, std::span<const Vec3> force, TissueState& s, TissueWork& w) {
  const ShapeMatchingModel& shape = m.shape;
  const double h = m.dt / shape.substeps;                              // [s]
  double* const scratch = w.scratch.data();
  const Match data{shape, w.rows.data(), scratch, scratch + kMap * (m.mass.size() + shape.gather.shared.size() / 2 + 1),
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
