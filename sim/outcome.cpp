#include "sim/outcome.h"

#include <algorithm>

#include "sim/step.h"
#include "sim/whole_seam.h"

namespace halsted {
namespace {

constexpr int kLook = 16;                      // steps between looks at the seam

StepInput stillHands(const State& s) {
  StepInput input;
  for (int hand = 0; hand < kHands; ++hand) {
    input.tools[hand].pose = s.tools[hand].device;
    input.tools[hand].jaw = s.tools[hand].jaw;
  }
  return input;
}

/// Smallest share of a lumen's cross-section at the edge that is left.  [1]
double openShare(const Model& m, std::span<const Vec3> x) {
  double least = 1.0;                          // [1]
  for (const auto& columns : m.join.columns) {
    std::vector<int> lumen;
    for (const EdgeColumn& c : columns) lumen.push_back(c.lumen);
    least = std::min(least, enclosedArea(lumen, x) / enclosedArea(lumen, m.mesh.vertices));
  }
  return least;
}

/// Raises the pressure until something gives.
void raisePressure(const Model& m, const LeakTest& test, State& s, Outcome& out) {
  StepInput input = stillHands(s);
  StepOutput seen;
  const std::int32_t tears = s.metrics.tears;
  const double dt = m.params.dt;               // [s]
  double gap = 0.0;                            // [m]
  for (double time = 0.0; out.leakPressure < test.most; time += dt) {
    out.leakPressure = std::clamp((time - test.settle) * test.rate, 0.0, test.most);
    input.lumenPressure = out.leakPressure * kPascalPerMmhg;
    step(m, input, s, seen);
    if (s.metrics.tears > tears) { out.end = LeakEnd::kTear; return; }
    if (s.step % kLook == 0 || time == 0.0) gap = measureWholeSeam(m, s).wallGap;
    if (gap <= test.gap) continue;
    out.end = out.leakPressure > 0.0 ? LeakEnd::kGap : LeakEnd::kOpen;
    if (time > test.settle) return;            // what is open while the tissue settles may still close
  }
  out.end = LeakEnd::kHeld;
}

}  // namespace

Outcome testOutcome(const Model& m, State s, const LeakTest& test) {
  Outcome out;
  if (!s.metrics.seam || s.cut) return out;    // of a prolapse the mucosa still lies outside: no pressure stands on it as it would in a lumen
  const JoinMetrics join = measureWholeSeam(m, s);
  if (join.crossings == 0) return out;
  out.tested = true;
  out.rimGap = join.rimGap;
  out.wallGap = join.wallGap;
  out.sewnShare = join.sewnShare;
  out.narrowing = 1.0 - openShare(m, s.tissue.position);
  raisePressure(m, test, s, out);
  return out;
}

void gatherPressure(const Model& m, const State& s, double pressure, std::vector<Vec3>& nodal) {
  if (!(pressure > 0.0)) return;
  for (std::size_t f = 0; f < m.surface.triangles.size(); ++f) {
    if (m.mesh.triangleLayer[f] != 1 || !exposed(m.surface, s.tissue.gone, static_cast<int>(f))) continue;
    const auto& v = m.surface.triangles[f];
    const auto& x = s.tissue.position;
    const Vec3 push = -pressure / 6.0 * (x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]);   // [N] on each corner, away from the lumen
    for (int corner : v) nodal[corner] += push;
  }
}

std::vector<std::pair<std::string, double>> summarise(const Outcome& o) {
  if (!o.tested) return {};
  return {{"leak_pressure_mmhg", o.leakPressure},
          {"leak_end_code", static_cast<double>(o.end)},
          {"outcome_rim_gap_m", o.rimGap},
          {"outcome_wall_gap_m", o.wallGap},
          {"sewn_share_1", o.sewnShare},
          {"lumen_narrowing_1", o.narrowing}};
}

}  // namespace halsted
