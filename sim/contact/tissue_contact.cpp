#include "sim/contact/tissue_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/contact/geometry.h"
#include "sim/contact/pair_search.h"
#include "sim/tissue/projective_model.h"

namespace halsted {
namespace {

constexpr double kThickness = 0.1e-3;          // [m] gap kept between two surfaces
constexpr double kLeastGive = 1e-6;            // [m/N] where everything is held in place
constexpr double kFarther = 0.3e-3;            // [m] behind, than behind the nearest face: not where the vertex came in
constexpr double kFaithful = 0.05e-3;          // [m] by which a face that pushes counts as nearer, lest two take turns

/// What a sweep makes of what is missing at a contact. The bound of the compliance is of one step: held for longer, tissue gives many times as much, so
/// a force that sums up whatever is missing runs ahead of it and comes back (walls that are sewn together buzzed by 0.8 mm).
struct Answer {
  double share = 0.5;                          // [1] of what is missing that is made good in this step
  double carried = 0.003;                      // [1] of what is missing that the next step begins with
  double most = 0.3e-3;                        // [m] deeper counts as this deep
};

/// Where tissue has no material: all that is missing is made good and carried on. Two sweeps a frame leave no time for less.
constexpr Answer kWhole{1.0, 1.0, std::numeric_limits<double>::infinity()};

/// Nothing but contact stops a free piece: answered with less it sinks in too far. Below twice the bound a sweep still converges.
constexpr Answer kFirm{.share = 1.9};

Answer answerOf(const Model& m, const State& s, int vertex, int corner) {
  if (m.tissue.solver == TissueSolver::kShapeMatching) return kWhole;
  return s.cut && std::max(s.tissue.piece[vertex], s.tissue.piece[corner]) > 0 ? kFirm : Answer{};
}

void applyPair(const Model& m, const PairGap& g, int vertex, int triangle, double force, std::vector<Vec3>& nodal) {
  nodal[vertex] += force * g.normal;
  const auto& v = m.surface.triangles[triangle];
  for (int k = 0; k < 3; ++k) nodal[v[k]] -= g.weight[k] * force * g.normal;
}

/// No force carried and the vertex above the gap that is kept: the pair stays without force. Most pairs, at a tenth of the cost.
bool apart(const Model& m, const TissueState& t, int pair) {
  if (t.pairForce[pair] > 0.0) return false;
  const auto& v = m.surface.triangles[t.pairTriangle[pair]];
  const Vec3& a = t.position[v[0]];
  const Vec3 normal = (t.position[v[1]] - a).cross(t.position[v[2]] - a);              // [m^2]
  const double height = normal.dot(t.position[t.pairVertex[pair]] - a);                // [m^3] times the normal's length
  return height > 0.0 && height * height > kThickness * kThickness * normal.squaredNorm();
}

struct RodGap {
  bool touches = false;
  double distance = 0.0;                       // [m] to the axis
  Vec3 normal = Vec3::UnitZ();                 // [1] away from it
};

RodGap rodGap(const Model& m, const TissueState& t, int vertex) {
  const RodParams& rod = m.params.anvil;
  const Vec3& p = t.position[vertex];
  RodGap g;
  const Vec3 along = rod.to - rod.from;                                // [m]
  const bool free = t.rodForce[vertex].isZero(0.0);
  if (free && (p - rod.from).cross(along).squaredNorm() > rod.radius * rod.radius * along.squaredNorm()) return g;   // off the whole line
  const Vec3 away = p - rod.from - closestOnSegment(p, rod.from, rod.to) * along;
  g.distance = away.norm();
  if (free && g.distance > rod.radius) return g;
  g.touches = g.distance > 1e-9;
  if (g.touches) g.normal = away / g.distance;
  return g;
}

/// Pairs that may push, and how they stand: no position moves before `solvePairs` is done with them.
void findTouching(const Model& m, const TissueState& t, SelfWork& w) {
  w.touching = 0;
  for (int i = 0; i < t.pairCount; ++i) {
    if (apart(m, t, i)) continue;
    w.pair[w.touching] = i;
    w.gap[w.touching++] = pairGap(m, {t.position, t.gone}, t.pairVertex[i], t.pairTriangle[i]);
  }
}

/// A vertex behind several faces, as of a wedge between two walls, is pushed out through the nearest: others would push it to and fro.
void keepNearest(const TissueState& t, SelfWork& w) {
  const auto behind = [&](int n) { return w.gap[n].near && w.gap[n].height <= 0.0; };
  const auto depth = [&](int n) { return -w.gap[n].height - (t.pairForce[w.pair[n]] > 0.0 ? kFaithful : 0.0); };   // [m]
  const auto least = [&](int n) -> double& { return w.nearest[t.pairVertex[w.pair[n]]]; };   // [m]
  for (int n = 0; n < w.touching; ++n) least(n) = std::numeric_limits<double>::infinity();
  for (int n = 0; n < w.touching; ++n)
    if (behind(n)) least(n) = std::fmin(least(n), depth(n));
  for (int n = 0; n < w.touching; ++n)
    if (behind(n) && depth(n) > least(n) + kFarther) w.gap[n].near = false;
}

/// How many contacts push each particle: one for its own, a weight for each triangle of which it is a corner.
bool gatherLoads(const Model& m, State& s) {
  const TissueState& t = s.tissue;
  const SelfWork& w = s.work.self;
  std::vector<double>& load = s.work.self.give;
  std::fill(load.begin(), load.end(), 0.0);
  for (int n = 0; n < w.touching; ++n) {
    const int i = w.pair[n];
    load[t.pairVertex[i]] += 1.0;
    for (int k = 0; k < 3; ++k) load[m.surface.triangles[t.pairTriangle[i]][k]] += w.gap[n].weight[k];
  }
  bool any = w.touching > 0;
  if (!(m.params.anvil.radius > 0.0)) return any;
  for (int v : m.surface.vertices) {
    if ((s.cut && !s.cut->bare[v]) || !rodGap(m, t, v).touches) continue;
    load[v] += 1.0;
    any = true;
  }
  return any;
}

/// load := A^-1 load, but no less than a particle's own compliance: how far each goes when every contact pushes with a newton.  [m/N]
/// Row sums of the contacts' compliance matrix, by which a Jacobi sweep can only undershoot (Gershgorin).
void answerLoads(const Model& m, TissueWork& w, std::vector<double>& load) {
  const ProjectiveModel& p = m.tissue.projective;
  for (int i = 0; i < p.size; ++i) {
    double* row = &w.rows[4 * p.permutation[i]];
    row[0] = m.tissue.isFixed[i] ? 0.0 : load[i];
    row[1] = row[2] = row[3] = 0.0;
  }
  solveFactor(p, w.rows.data());
  for (int i = 0; i < p.size; ++i) load[i] = m.tissue.isFixed[i] ? 0.0 : std::fmax(w.rows[4 * p.permutation[i]], p.self[i]);
}

void solvePairs(const Model& m, State& s) {
  TissueState& t = s.tissue;
  const SelfWork& w = s.work.self;
  const std::vector<double>& give = w.give;
  for (int n = 0; n < w.touching; ++n) {
    const int i = w.pair[n], vertex = t.pairVertex[i], triangle = t.pairTriangle[i];
    const PairGap& g = w.gap[n];
    const auto& v = m.surface.triangles[triangle];
    const double both = give[vertex] + g.weight[0] * give[v[0]] + g.weight[1] * give[v[1]] + g.weight[2] * give[v[2]] + kLeastGive;   // [m/N]
    const Answer answer = answerOf(m, s, vertex, v[0]);
    const double before = t.pairForce[i], missing = std::fmin(kThickness - g.height, answer.most) / both;   // [N]
    const auto with = [&](double share) { return g.near ? std::fmax(0.0, before + share * missing) : 0.0; };
    t.pairForce[i] = with(answer.carried);
    applyPair(m, g, vertex, triangle, with(answer.share) - before, s.work.change);
  }
}

void solveRod(const Model& m, State& s) {
  TissueState& t = s.tissue;
  if (!(m.params.anvil.radius > 0.0)) return;
  for (int v : m.surface.vertices) {
    if (s.cut && !s.cut->bare[v]) continue;
    const Vec3 old = t.rodForce[v];
    const RodGap g = rodGap(m, t, v);
    if (!g.touches && old.isZero(0.0)) continue;
    Vec3 fresh = Vec3::Zero();
    if (g.touches) {
      const Vec3& n = g.normal;
      const double give = s.work.self.give[v] + kLeastGive;            // [m/N]
      const double pushed = std::fmax(0.0, old.dot(n) + (m.params.anvil.radius - g.distance) / give);
      const Vec3 moved = t.position[v] - s.work.tissue.previous[v], slide = moved - moved.dot(n) * n;
      Vec3 grip = old - old.dot(n) * n - slide / give;
      const double limit = m.params.contact.toolTissueFriction * pushed, size = grip.norm();
      if (size > limit) grip *= size > 0.0 ? limit / size : 0.0;
      fresh = pushed * n + grip;
    }
    t.rodForce[v] = fresh;
    s.work.change[v] += fresh - old;
  }
}

}  // namespace

int tissueContactInterval(const Model& m) { return m.tissue.solver == TissueSolver::kShapeMatching ? 4 : 1; }

void solveTissueContact(const Model& m, State& s) {
  searchPairs(m, s);
  if (s.step % static_cast<unsigned>(tissueContactInterval(m)) != 0) return;
  findTouching(m, s.tissue, s.work.self);
  if (m.tissue.solver != TissueSolver::kShapeMatching) keepNearest(s.tissue, s.work.self);
  if (!gatherLoads(m, s)) return;
  answerLoads(m, s.work.tissue, s.work.self.give);
  solvePairs(m, s);
  solveRod(m, s);
}

void gatherTissueContact(const Model& m, const State& s, std::vector<Vec3>& nodal) {
  const TissueState& t = s.tissue;
  for (std::size_t i = 0; i < t.rodForce.size(); ++i) nodal[i] += t.rodForce[i];
  for (int i = 0; i < t.pairCount; ++i) {
    if (t.pairForce[i] == 0.0) continue;
    const PairGap g = pairGap(m, {t.position, t.gone}, t.pairVertex[i], t.pairTriangle[i]);
    applyPair(m, g, t.pairVertex[i], t.pairTriangle[i], t.pairForce[i], nodal);
  }
}

}  // namespace halsted
