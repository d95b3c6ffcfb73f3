#include "sim/suture/tied_stitches.h"

#include <algorithm>
#include <cmath>

#include "sim/lanes.h"
#include "sim/model.h"
#include "sim/state.h"
#include "sim/suture/holes.h"

namespace halsted {
namespace {

constexpr double kRoom = 1.25;                 // [1] stitches turn after they were tied: what they share is an estimate from then

constexpr double kSwing = 2.0;                 // [1] of the way that a stretch's own pull makes in a step
constexpr double kLeastWay = 1e-6;             // [m] between two holes

using Directions = std::array<Vec3, TiedStitch::kMostHoles>;   // [1]

/// Where a loop under a newton of tension pulls each hole: toward the hole before and the hole after it. Returns the loop's length.  [m]
double pullsOf(const Model& m, const TiedStitch& s, std::span<const Vec3> x, Directions& pull) {   // x [m]
  Directions point;                            // [m]
  for (int i = 0; i < s.holeCount; ++i) {
    point[i] = pointOf(m, s.hole[i], x);
    pull[i] = Vec3::Zero();
  }
  double length = 0.0;                         // [m]
  for (int i = 0; i < s.holeCount; ++i) {
    const int next = i + 1 < s.holeCount ? i + 1 : 0;
    const Vec3 way = point[next] - point[i];   // [m]
    const double size = way.norm();            // [m]
    length += size;
    if (size < 1e-9) continue;
    pull[i] += way / size;
    pull[next] -= way / size;
  }
  return length;
}

/// How far a newton of tension closes the loop itself.  [m/N]
double ownGive(const TiedStitch& s, const Directions& pull) {
  double sum = 0.0;                            // [m/N]
  for (int i = 0; i < s.holeCount; ++i)
    for (int j = 0; j < s.holeCount; ++j) sum += s.give[i * TiedStitch::kMostHoles + j] * pull[i].dot(pull[j]);
  return sum;
}

/// How far a newton of tension in one loop closes or opens another.  [m/N]
double sharedGive(const Model& m, const TiedStitch& a, const TiedStitch& b, std::span<const Vec3> x) {   // x [m]
  Directions pullA, pullB;
  pullsOf(m, a, x, pullA);
  pullsOf(m, b, x, pullB);
  double sum = 0.0;                            // [m/N]
  for (int i = 0; i < a.holeCount; ++i)
    for (int j = 0; j < b.holeCount; ++j) sum += complianceBetween(m, a.hole[i], b.hole[j]) * pullA[i].dot(pullB[j]);
  return kRoom * magnitude(sum);
}

void addForces(const Model& m, const TiedStitch& s, double sign, std::vector<Vec3>& nodal) {   // sign [1], nodal [N]
  for (int i = 0; i < s.holeCount; ++i)
    for (int c = 0; c < 4; ++c) nodal[m.tissue.tets[s.hole[i].tet][c]] += sign * s.hole[i].weight[c] * s.force[i];
}

int nextHole(const TiedStitch& s, int i) { return i + 1 < s.holeCount ? i + 1 : 0; }

using Others = std::array<double, TiedStitch::kMostHoles>;       // [m/N] per hole

/// How far a newton at one hole moves another; itself, as if the holes of all other loops were pulled as hard. A row of loops swings as one: each solved as if
/// its neighbours stood still, they threw the rims of a seam to and fro.  [m/N]
double giveOf(const TiedStitch& s, const Others& others, int i, int j) { return s.give[i * TiedStitch::kMostHoles + j] + (i == j ? others[i] : 0.0); }

/// How far a newton in one stretch of the loop shortens another, or itself.  [m/N]
double giveBetween(const TiedStitch& s, const Others& others, int a, int b) {
  const auto give = [&](int i, int j) { return giveOf(s, others, i, j); };
  const int afterA = nextHole(s, a), afterB = nextHole(s, b);
  return give(afterA, afterB) - give(afterA, b) - give(a, afterB) + give(a, b);
}

/// Has it a stretch so short that its pull swings it round within a step?
bool crowded(const Model& m, const TiedStitch& s, const Others& others, std::span<const Vec3> x) {   // x [m]
  for (int i = 0; i < s.holeCount; ++i) {
    const double size = (pointOf(m, s.hole[nextHole(s, i)], x) - pointOf(m, s.hole[i], x)).norm();   // [m]
    if (size < kSwing * s.tension * giveBetween(s, others, i, i)) return true;
  }
  return false;
}

/// Pull of every stretch at the end of the step, where its two holes will be then: two walls that lie on each other leave their holes next to
/// each other, and a pull along the way between them as it was would throw them past each other to and fro. Each stretch counts as a spring
/// whose rest length is nothing and which bears the tension at its present length; the system is symmetric and positive.
void pullImplicitly(const Model& m, const Others& others, std::span<const Vec3> x, TiedStitch& s) {   // x [m]
  constexpr int kMost = TiedStitch::kMostHoles;
  const int n = s.holeCount;
  Directions free, pull;                       // [m] holes without this loop; [N] of each stretch
  for (int i = 0; i < n; ++i) {
    free[i] = pointOf(m, s.hole[i], x);
    for (int j = 0; j < n; ++j) free[i] -= giveOf(s, others, i, j) * s.force[j];
  }
  double a[kMost][kMost];                      // [m/N] lower triangle, then its factor
  for (int i = 0; i < n; ++i) {
    pull[i] = free[nextHole(s, i)] - free[i];
    for (int j = 0; j <= i; ++j) a[i][j] = giveBetween(s, others, i, j);
    a[i][i] += std::fmax(kLeastWay, (pointOf(m, s.hole[nextHole(s, i)], x) - pointOf(m, s.hole[i], x)).norm()) / s.tension;
  }
  for (int j = 0; j < n; ++j)                  // L D L^T in place
    for (int i = j + 1; i < n; ++i) {
      const double share = a[i][j] / a[j][j];  // [1]
      for (int k = i; k < n; ++k) a[k][i] -= share * a[k][j];
      pull[i] -= share * pull[j];
    }
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) pull[i] -= a[k][i] * pull[k];
    pull[i] /= a[i][i];
  }
  for (int i = 0; i < n; ++i) s.force[i] = pull[i];
  for (int i = 0; i < n; ++i) s.force[nextHole(s, i)] -= pull[i];
}

/// Implicit on the tissue's one-step compliance, as if every other stitch changed as much: it can only undershoot.
void solveLoop(const Model& m, const Others& others, std::span<const Vec3> x, TiedStitch& s) {   // x [m]
  Directions pull;
  const double stretched = pullsOf(m, s, x, pull) - s.length;                  // [m]
  const double stiffness = m.params.thread.axialStiffness / s.length;          // [N/m]
  const double give = ownGive(s, pull) + s.shared;                             // [m/N]
  s.tension = std::fmax(0.0, s.tension + (stiffness * stretched - s.tension) / (1.0 + stiffness * give));
  if (s.tension > 0.0 && crowded(m, s, others, x)) return pullImplicitly(m, others, x, s);
  for (int i = 0; i < s.holeCount; ++i) s.force[i] = s.tension * pull[i];
}

/// Row sums of the holes' compliance (Gershgorin), one loop after the other, so that they are the same however many were known before.
void countOthers(const Model& m, const TiedStitches& all, StitchWork& w) {
  bool same = w.count <= all.count;
  for (int k = 0; same && k < w.count; ++k) same = all.stitch[k].hole == w.hole[k];
  if (!same) w.count = 0;
  for (; w.count < all.count; ++w.count) {     // one more loop: those before it and it
    const TiedStitch& fresh = all.stitch[w.count];
    w.hole[w.count] = fresh.hole;
    w.others[w.count] = {};
    for (int k = 0; k < w.count; ++k)
      for (int i = 0; i < all.stitch[k].holeCount; ++i)
        for (int j = 0; j < fresh.holeCount; ++j) {
          const double give = magnitude(complianceBetween(m, all.stitch[k].hole[i], fresh.hole[j]));   // [m/N]
          w.others[k][i] += give;
          w.others[w.count][j] += give;
        }
  }
}

double hardestPull(const TiedStitch& s) {      // [N] at one of its holes
  double most = 0.0;                           // [N^2]
  for (int i = 0; i < s.holeCount; ++i) most = std::fmax(most, s.force[i].squaredNorm());
  return std::sqrt(most);
}

void removeStitch(const Model& m, int which, double pull, State& s, StepOutput& out) {   // pull [N]
  TiedStitches& all = *s.stitches;
  addForces(m, all.stitch[which], -1.0, s.work.change);
  std::copy(all.stitch.begin() + which + 1, all.stitch.begin() + all.count, all.stitch.begin() + which);
  all.stitch[--all.count] = TiedStitch{};
  ++all.torn;
  ++s.metrics.tears;
  pushEvent(out, {s.step, EventKind::kChannelTorn, -1, which, pull});
}

bool inGone(const TiedStitch& s, std::span<const std::uint8_t> gone) {
  for (int i = 0; i < s.holeCount; ++i)
    if (gone[s.hole[i].tet]) return true;
  return false;
}

}  // namespace

void tearStitchesInGone(const Model& m, State& s, StepOutput& out) {
  if (!s.stitches) return;
  for (int k = s.stitches->count - 1; k >= 0; --k)
    if (inGone(s.stitches->stitch[k], s.tissue.gone)) removeStitch(m, k, hardestPull(s.stitches->stitch[k]), s, out);
}

double loopLength(const Model& m, const TiedStitch& s, std::span<const Vec3> x) {
  Directions pull;
  return pullsOf(m, s, x, pull);
}

bool tieStitch(const Model& m, State& s, std::span<const TissuePoint> holes, double length) {
  if (!s.stitches) return false;
  TiedStitches& all = *s.stitches;
  if (all.count == TiedStitches::kMost || holes.size() < 2 || holes.size() > TiedStitch::kMostHoles || !(length > 0.0)) return false;
  TiedStitch& fresh = all.stitch[all.count];
  fresh = TiedStitch{};
  fresh.holeCount = static_cast<std::int32_t>(holes.size());
  fresh.length = length;
  std::copy(holes.begin(), holes.end(), fresh.hole.begin());
  for (int i = 0; i < fresh.holeCount; ++i)
    for (int j = 0; j < fresh.holeCount; ++j) fresh.give[i * TiedStitch::kMostHoles + j] = complianceBetween(m, fresh.hole[i], fresh.hole[j]);
  for (int k = 0; k < all.count; ++k) {
    const double give = sharedGive(m, fresh, all.stitch[k], s.tissue.position);   // [m/N]
    fresh.shared += give;
    all.stitch[k].shared += give;
  }
  ++all.count;
  return true;
}

void loadStitch(const Model& m, std::span<const Vec3> x, double tension, TiedStitch& s) {
  Directions pull;
  s.length = pullsOf(m, s, x, pull) / (1.0 + tension / m.params.thread.axialStiffness);
  s.tension = tension;
  for (int i = 0; i < s.holeCount; ++i) s.force[i] = tension * pull[i];
}

void gatherStitchForces(const Model& m, const State& s, std::vector<Vec3>& nodal) {
  if (!s.stitches) return;
  for (int k = 0; k < s.stitches->count; ++k) addForces(m, s.stitches->stitch[k], 1.0, nodal);
}

void settleStitches(const Model& m, State& s, StepOutput& out) {
  if (!s.stitches) return;
  TiedStitches& all = *s.stitches;
  countOthers(m, all, s.work.stitches);
  for (int k = 0; k < all.count; ++k) {
    TiedStitch& stitch = all.stitch[k];
    addForces(m, stitch, -1.0, s.work.change);
    solveLoop(m, s.work.stitches.others[k], s.tissue.position, stitch);
    addForces(m, stitch, 1.0, s.work.change);
  }
  for (int k = all.count - 1; k >= 0; --k) {
    const double pull = hardestPull(all.stitch[k]);              // [N]
    if (pull > m.params.needle.tearForce) removeStitch(m, k, pull, s, out);
  }
}

}  // namespace halsted
