#include "sim/cutting/burn.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/geometry.h"
#include "sim/cutting/cut_measure.h"
#include "sim/cutting/loose_ends.h"
#include "sim/cutting/pieces.h"
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"
#include "sim/suture/holes.h"
#include "sim/tools/instrument.h"

namespace halsted {
namespace {

constexpr double kSpark = 0.15e-3;             // [m] of steam that the current jumps (design)
constexpr double kSmoking = 1.5e-3;            // [m] about the electrode, in which charred tissue still smokes (of the picture)
constexpr double kCharred = 0.3;               // [1] of the heat that takes a tet away

/// Of a point from a tet; 0 inside.  [m]
double distanceTo(const Vec3& p, const std::array<int, 4>& tet, std::span<const Vec3> x) {
  double least = 1e300;                        // [m^2]
  bool inside = true;
  for (int f = 0; f < 4; ++f) {
    const auto corner = faceCorners(tet, f);
    const Vec3 &a = x[corner[0]], &b = x[corner[1]], &c = x[corner[2]];
    inside = inside && (b - a).cross(c - a).dot(p - a) <= 0.0;
    least = std::fmin(least, (p - mix(closestOnTriangle(p, a, b, c), a, b, c)).squaredNorm());
  }
  return inside ? 0.0 : std::sqrt(least);
}

bool outsideBox(const Vec3& p, const std::array<int, 4>& tet, std::span<const Vec3> x, double reach) {   // p, reach [m]
  constexpr double kLongestEdge = 20e-3;       // [m] no tissue is stretched so far: most tets need one corner to be left out
  const Vec3 &a = x[tet[0]], &b = x[tet[1]], &c = x[tet[2]], &d = x[tet[3]];
  if ((a - p).squaredNorm() > (kLongestEdge + reach) * (kLongestEdge + reach)) return true;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::min({a[axis], b[axis], c[axis], d[axis]}), high = std::max({a[axis], b[axis], c[axis], d[axis]});
    if (!(p[axis] > low - reach && p[axis] < high + reach)) return true;
  }
  return false;
}

/// Tets within reach of one electrode.
struct Heated {
  static constexpr int kMost = 128;
  std::array<int, kMost> tet{};
  std::array<double, kMost> share{};           // [m] how much nearer than the reach
  int count = 0;
  double sum = 0.0;                            // [m]
  bool touches = false;
};

Heated heatedBy(const Model& m, const State& s, const Vec3& tip) {   // tip [m]
  const CauteryParams& pen = m.params.cautery;
  const double reach = pen.tipRadius + pen.reach, spark = pen.tipRadius + std::fmin(kSpark, 0.5 * pen.reach);   // [m]
  Heated h;
  for (int t = 0; t < static_cast<int>(m.tissue.tets.size()) && h.count < Heated::kMost; ++t) {
    if (s.tissue.gone[t] || outsideBox(tip, m.tissue.tets[t], s.tissue.position, reach)) continue;
    const double distance = distanceTo(tip, m.tissue.tets[t], s.tissue.position);   // [m]
    if (distance >= reach) continue;
    h.touches = h.touches || distance < spark;
    h.tet[h.count] = t;
    h.share[h.count++] = reach - distance;
    h.sum += reach - distance;
  }
  return h;
}

bool switchedOn(const Model& m, const State& s, int hand) { return toolOf(m, s, hand).kind == ToolKind::kElectrocautery && s.tools[hand].closed; }

/// Should this tet be left alone? What is on no wall of the line, and the inner wall before the outer one is through.
bool isOvershoot(const Model& m, const CutMetrics& metrics, int tet) {
  if (!m.mesh.cuttable[tet]) return true;
  if (m.mesh.cutLine.empty()) return false;
  const int wall = m.mesh.cutLine[tet].wall;
  const bool outerLeft = m.cut.wallStart[1] > m.cut.wallStart[0] && metrics.share[0] < 1.0;
  return wall < 0 || (wall == 1 && outerLeft);
}

/// True when a tet went.
bool heatTissue(const Model& m, int hand, State& s, StepOutput& out) {
  const Heated h = heatedBy(m, s, s.tools[hand].proxy.position);
  if (!h.touches || !(m.params.cautery.power > 0.0)) return false;
  CutMetrics& metrics = *s.metrics.cut;
  const double given = m.params.cautery.power * m.params.dt;     // [J]
  bool went = false;
  for (int i = 0; i < h.count; ++i) {
    const int t = h.tet[i];
    const double heat = given * (h.share[i] / h.sum);            // [J]
    s.tissue.heat[t] += heat;
    if (isOvershoot(m, metrics, t)) metrics.overshoot += heat;
    if (!m.mesh.cuttable[t] || s.tissue.heat[t] < m.tissue.restVolume[t] * m.params.cautery.cuttingEnergy) continue;
    s.tissue.gone[t] = static_cast<std::uint8_t>(Gone::kBurnt);
    ++metrics.burnt;
    went = true;
    pushEvent(out, {s.step, EventKind::kTissueCut, hand, t, s.tissue.heat[t]});
  }
  metrics.energy += given;
  metrics.time += m.params.dt;
  metrics.current = true;
  return went;
}

}  // namespace

void cutTissue(const Model& m, State& s, StepOutput& out) {
  if (!s.cut) return;
  s.metrics.cut->current = false;
  bool went = false;
  for (int hand = 0; hand < kHands; ++hand) {
    if (switchedOn(m, s, hand) && heatTissue(m, hand, s, out)) went = true;
  }
  if (takeAwayPieces(m, s, out)) went = true;
  if (!went) return;
  settlePieces(m, s, out);
  letGoOfGone(m, s, out);
  measureCut(m, s);
}

bool smokes(const Model& m, const State& s, int hand) {
  if (!s.cut || !switchedOn(m, s, hand)) return false;
  const Vec3& tip = s.tools[hand].proxy.position;
  for (int t = 0; t < static_cast<int>(m.tissue.tets.size()); ++t) {
    if (s.tissue.heat[t] < kCharred * m.tissue.restVolume[t] * m.params.cautery.cuttingEnergy) continue;
    if (!outsideBox(tip, m.tissue.tets[t], s.tissue.position, kSmoking)) return true;
  }
  return false;
}

}  // namespace halsted
