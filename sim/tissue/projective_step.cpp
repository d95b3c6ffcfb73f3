#include "sim/lanes.h"
#include "sim/tissue/tissue.h"

namespace halsted {
namespace {

constexpr int kLanes = ProjectiveModel::kLanes;

/// Three components per lane.
template <typename L> struct V3 { L x, y, z; };
template <typename L> HALSTED_INLINE V3<L> operator-(V3<L> a, V3<L> b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <typename L> HALSTED_INLINE V3<L> operator+(V3<L> a, V3<L> b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <typename L> HALSTED_INLINE V3<L> operator*(L s, V3<L> a) { return {s * a.x, s * a.y, s * a.z}; }
template <typename L> HALSTED_INLINE L dot(V3<L> a, V3<L> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <typename L> HALSTED_INLINE V3<L> cross(V3<L> a, V3<L> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Matrix as its three columns.
template <typename L> struct M3 { V3<L> c0, c1, c2; };

template <typename L> HALSTED_INLINE M3<L> rotationOf(L w, L x, L y, L z) {
  const L one = w * 0.0 + 1.0, two = one + one;
  return {{one - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)},
          {two * (x * y - w * z), one - two * (x * x + z * z), two * (y * z + w * x)},
          {two * (x * z + w * y), two * (y * z - w * x), one - two * (x * x + y * y)}};
}

struct LocalData {
  const double* position;        // [m] xyz per particle
  const int* vertex;             // [corner][lane]
  const double* restInverse;     // [1/m] [9][lane]
  const double* volume;          // [m^3] [lane]
  double* quaternion;            // x, y, z, w per tet, as Eigen stores them
  double* pressure;              // [Pa] per tet
  double* force;                 // [N] [corner][xyz][lane]
  double mu, lambda, gain;       // [Pa], [Pa], [Pa] Uzawa step
  double stiffening, toe;        // [1], [1] see secantFactor
};

template <typename L> HALSTED_INLINE V3<L> gatherPosition(const double* position, const int* vertex) {
  double x[4], y[4], z[4];
  for (int l = 0; l < LaneCount<L>::value; ++l) {
    const double* p = position + 3 * vertex[l];
    x[l] = p[0]; y[l] = p[1]; z[l] = p[2];
  }
  return {loadLanes<L>(x), loadLanes<L>(y), loadLanes<L>(z)};
}

/// One warm-started step of the rotation of F (Mueller et al. 2016): w = sum r_i x f_i / (|sum r_i . f_i| + eps), q <- (1, w/2) q.
template <typename L> HALSTED_INLINE M3<L> updateRotation(double* q4, const M3<L>& f) {
  double buffer[4][4];
  for (int c = 0; c < 4; ++c)
    for (int l = 0; l < LaneCount<L>::value; ++l) buffer[c][l] = q4[4 * l + c];
  L x = loadLanes<L>(buffer[0]), y = loadLanes<L>(buffer[1]), z = loadLanes<L>(buffer[2]), w = loadLanes<L>(buffer[3]);
  const M3<L> r = rotationOf(w, x, y, z);
  const V3<L> torque = cross(r.c0, f.c0) + cross(r.c1, f.c1) + cross(r.c2, f.c2);
  const L scale = 0.5 / (magnitude(dot(r.c0, f.c0) + dot(r.c1, f.c1) + dot(r.c2, f.c2)) + 1e-9);
  const V3<L> a = scale * torque;
  const L nw = w - (a.x * x + a.y * y + a.z * z);
  const L nx = x + w * a.x + (a.y * z - a.z * y);
  const L ny = y + w * a.y + (a.z * x - a.x * z);
  const L nz = z + w * a.z + (a.x * y - a.y * x);
  const L inverseNorm = 1.0 / squareRoot(nw * nw + nx * nx + ny * ny + nz * nz);
  x = nx * inverseNorm; y = ny * inverseNorm; z = nz * inverseNorm; w = nw * inverseNorm;
  storeLanes(buffer[0], x); storeLanes(buffer[1], y); storeLanes(buffer[2], z); storeLanes(buffer[3], w);
  for (int c = 0; c < 4; ++c)
    for (int l = 0; l < LaneCount<L>::value; ++l) q4[4 * l + c] = buffer[c][l];
  return rotationOf(w, x, y, z);
}

template <typename L> HALSTED_INLINE void storeForce(double* force, const V3<L>& f) {
  storeLanes(force, f.x); storeLanes(force + kLanes, f.y); storeLanes(force + 2 * kLanes, f.z);
}

/// The stress the matrix must still be told about, over 2 mu: k (F - I) - h (F - R), which is R - I where nothing stiffens.
template <typename L> HALSTED_INLINE M3<L> stiffeningTarget(const LocalData& d, const M3<L>& f, const M3<L>& r) {
  const V3<L> d0 = f.c0 - r.c0, d1 = f.c1 - r.c1, d2 = f.c2 - r.c2;
  const L strain = squareRoot(dot(d0, d0) + dot(d1, d1) + dot(d2, d2));
  const L zero = strain * 0.0, k = zero + d.stiffening;
  const L secant = k - (k - 1.0) * d.toe / larger(strain, zero + d.toe);
  M3<L> t{k * f.c0 - secant * d0, k * f.c1 - secant * d1, k * f.c2 - secant * d2};
  t.c0.x = t.c0.x - k; t.c1.y = t.c1.y - k; t.c2.z = t.c2.z - k;
  return t;
}

/// Local step of one group: rotation, pressure, and the right-hand side it adds to its four corners:
/// V (2 mu target - p R) g_a.
template <typename L> HALSTED_INLINE void localGroup(const LocalData& d) {
  const V3<L> x0 = gatherPosition<L>(d.position, d.vertex);
  const V3<L> e1 = gatherPosition<L>(d.position, d.vertex + kLanes) - x0;
  const V3<L> e2 = gatherPosition<L>(d.position, d.vertex + 2 * kLanes) - x0;
  const V3<L> e3 = gatherPosition<L>(d.position, d.vertex + 3 * kLanes) - x0;
  L b[9];
  for (int e = 0; e < 9; ++e) b[e] = loadLanes<L>(d.restInverse + e * kLanes);
  // F = (e1 e2 e3) B, by columns.
  const M3<L> f{b[0] * e1 + b[3] * e2 + b[6] * e3, b[1] * e1 + b[4] * e2 + b[7] * e3, b[2] * e1 + b[5] * e2 + b[8] * e3};
  const M3<L> r = updateRotation<L>(d.quaternion, f);
  const L dilation = dot(r.c0, f.c0) + dot(r.c1, f.c1) + dot(r.c2, f.c2) - 3.0;
  L p = loadLanes<L>(d.pressure);
  const L missing = d.gain * (dilation - p / d.lambda);
  p = p + missing;
  storeLanes(d.pressure, p);
  p = p + (d.stiffening - 1.0) * missing;      // one step answers only 1/k of a change: the lead that keeps the pressure from ringing
  const L volume = loadLanes<L>(d.volume);
  const L twoMu = 2.0 * d.mu * volume, pressed = p * volume;
  const M3<L> target = stiffeningTarget<L>(d, f, r);
  const V3<L> c0 = twoMu * target.c0 - pressed * r.c0, c1 = twoMu * target.c1 - pressed * r.c1, c2 = twoMu * target.c2 - pressed * r.c2;
  const V3<L> f1 = b[0] * c0 + b[1] * c1 + b[2] * c2;
  const V3<L> f2 = b[3] * c0 + b[4] * c1 + b[5] * c2;
  const V3<L> f3 = b[6] * c0 + b[7] * c1 + b[8] * c2;
  const V3<L> f0 = f1 + f2 + f3;
  storeForce<L>(d.force, V3<L>{-f0.x, -f0.y, -f0.z});
  storeForce<L>(d.force + 3 * kLanes, f1);
  storeForce<L>(d.force + 6 * kLanes, f2);
  storeForce<L>(d.force + 9 * kLanes, f3);
}

LocalData materialData(const TissueModel& m) {
  LocalData d{};
  d.mu = m.material.mu;
  d.lambda = m.material.lambda;
  d.stiffening = m.material.stiffening;
  d.toe = m.material.toe;
  d.gain = 1.0 / (1.5 / d.mu + 1.0 / d.lambda);   // largest eigenvalue of the volume response is at most 3 / (2 mu)
  return d;
}

LocalData groupData(LocalData d, const ProjectiveModel& p, TissueState& s, TissueWork& w, int g) {
  d.position = s.position[0].data();
  d.vertex = &p.laneVertex[g * 4 * kLanes];
  d.restInverse = &p.laneRestInverse[g * 9 * kLanes];
  d.volume = &p.laneVolume[g * kLanes];
  d.quaternion = s.rotation[g * kLanes].coeffs().data();
  d.pressure = &s.pressure[g * kLanes];
  d.force = &w.scratch[g * 12 * kLanes];
  return d;
}

HALSTED_INLINE void localBody(const TissueModel& m, TissueState& s, TissueWork& w) {
  const LocalData material = materialData(m);
  for (int g = 0; g < m.projective.groups; ++g) localGroup<Lanes4>(groupData(material, m.projective, s, w, g));
}

__attribute__((target("avx2"))) void localStepWide(const TissueModel& m, TissueState& s, TissueWork& w) { localBody(m, s, w); }
void localStep(const TissueModel& m, TissueState& s, TissueWork& w) { localBody(m, s, w); }

/// Rows are (x, y, z, 0): four lanes, of which three carry a right-hand side. A target sees its columns in ascending order, as when
/// they come one by one. A push at a few points leaves most panels with nothing to pass on: false.
template <int W> HALSTED_INLINE bool eliminate(const ProjectiveModel& p, const ProjectiveModel::Panel& panel, double* rows) {
  const double* value = p.value.data() + panel.value;
  const int* row = p.row.data() + panel.row;
  double* own = rows + 4 * panel.first;
  Lanes4 x[W];
  for (int r = 0; r < W; ++r) x[r] = loadLanes<Lanes4>(own + 4 * r);
  auto pushed = x[0] != 0.0;
  for (int r = 1; r < W; ++r) pushed = pushed | (x[r] != 0.0);
  if (!(pushed[0] | pushed[1] | pushed[2] | pushed[3])) return false;
  for (int r = 1; r < W; ++r) {
    for (int c = 0; c < r; ++c) x[r] = x[r] - value[r * W + c] * x[c];
    storeLanes(own + 4 * r, x[r]);
  }
  for (int r = W; r < panel.rows; ++r) {
    double* target = rows + row[r];
    Lanes4 sum = loadLanes<Lanes4>(target);
    for (int c = 0; c < W; ++c) sum = sum - value[r * W + c] * x[c];
    storeLanes(target, sum);
  }
  return true;
}

/// Entries of the way back, from where it has come.
struct BackEntries { const int* row; const double* value; };

/// Those of `N` columns abreast from entry `from` to the end of the shortest; then the others'.
template <int N> HALSTED_INLINE void subtract(const ProjectiveModel::Abreast& columns, int from, const double* rows, BackEntries& next, Lanes4* x) {
  const int to = columns.count[N - 1];
  for (int k = from; k < to; ++k, next.row += N, next.value += N)
    for (int n = 0; n < N; ++n) x[n] = x[n] - next.value[n] * loadLanes<Lanes4>(rows + next.row[n]);
  if constexpr (N > 1) subtract<N - 1>(columns, to, rows, next, x);
}

template <int N> HALSTED_INLINE void substitute(const ProjectiveModel& p, const ProjectiveModel::Abreast& columns, BackEntries& next, double* rows) {
  Lanes4 x[N];
  for (int n = 0; n < N; ++n) x[n] = loadLanes<Lanes4>(rows + 4 * columns.index[n]) * p.inverseDiagonal[columns.index[n]];
  subtract<N>(columns, 0, rows, next, x);
  for (int n = 0; n < N; ++n) storeLanes(rows + 4 * columns.index[n], x[n]);
}

HALSTED_INLINE void substituteAbreast(const ProjectiveModel& p, const ProjectiveModel::Abreast& columns, BackEntries& next, double* rows) {
  if (columns.index[3] >= 0) substitute<4>(p, columns, next, rows);
  else if (columns.index[2] >= 0) substitute<3>(p, columns, next, rows);
  else if (columns.index[1] >= 0) substitute<2>(p, columns, next, rows);
  else substitute<1>(p, columns, next, rows);
}

HALSTED_INLINE bool eliminatePanel(const ProjectiveModel& p, const ProjectiveModel::Panel& panel, double* rows) {
  switch (panel.width) {
    case 1: return eliminate<1>(p, panel, rows);
    case 2: return eliminate<2>(p, panel, rows);
    case 3: return eliminate<3>(p, panel, rows);
    default: return eliminate<4>(p, panel, rows);
  }
}

HALSTED_INLINE void solveBody(const ProjectiveModel& p, double* rows) {
  bool pushed[ProjectiveModel::kMostParts] = {};
  for (const ProjectiveModel::Panel& panel : p.panels) pushed[panel.part] |= eliminatePanel(p, panel, rows);
  for (std::size_t part = 0; part < p.parts.size(); ++part) {
    if (!pushed[part]) continue;                                       // nothing moves there
    BackEntries next{p.backRow.data() + p.parts[part].entry, p.backValue.data() + p.parts[part].entry};
    for (int k = p.parts[part].first; k < p.parts[part].end; ++k) substituteAbreast(p, p.backward[k], next, rows);
  }
}

__attribute__((target("avx2"))) void solveWide(const ProjectiveModel& p, double* rows) { solveBody(p, rows); }
void solveNarrow(const ProjectiveModel& p, double* rows) { solveBody(p, rows); }

}  // namespace

void solveFactor(const ProjectiveModel& p, double* rows) { p.wide ? solveWide(p, rows) : solveNarrow(p, rows); }

void predictProjective(const TissueModel& m, std::span<const Vec3> force, TissueState& s, TissueWork& w) {
  const ProjectiveModel& p = m.projective;
  p.wide ? localStepWide(m, s, w) : localStep(m, s, w);
  if (!s.gone.empty()) relaxGone(m, s, w);
  double* rows = w.rows.data();
  const double inertia = 1.0 / (m.dt * m.dt) + m.massDamping / m.dt;   // [1/s^2]
  for (int i = 0; i < p.size; ++i) {
    Vec3 elastic = Vec3::Zero();
    for (int e = p.cornerStart[i]; e < p.cornerStart[i + 1]; ++e) {
      const double* f = &w.scratch[p.corner[e]];
      elastic += Vec3(f[0], f[kLanes], f[2 * kLanes]);
    }
    const Vec3 weight = s.left.empty() ? m.gravity : Vec3(s.left[i] * m.gravity);   // [m/s^2]
    Vec3 rhs = m.mass[i] * (inertia * (s.position[i] - m.rest[i]) + s.velocity[i] / m.dt + weight) + force[i] + elastic;
    if (m.isFixed[i]) rhs.setZero();
    double* target = rows + 4 * p.permutation[i];
    target[0] = rhs.x(); target[1] = rhs.y(); target[2] = rhs.z(); target[3] = 0.0;
  }
  solveFactor(p, rows);
  for (int i = 0; i < p.size; ++i) {
    const double* u = rows + 4 * p.permutation[i];
    s.position[i] = m.rest[i] + Vec3(u[0], u[1], u[2]);
  }
}

}  // namespace halsted
