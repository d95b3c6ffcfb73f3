#include "sim/outcome.h"

#include <algorithm>

#include "sim/cutting/edge.h"
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

/// The mucosa at the edge of a bowel, round its opening.
std::vector<int> mucosaAtEdge(const Model& m, const State& s, int bowel) {
  std::vector<int> lumen;
  const std::span<const int> edge = edgeOf(m, s, bowel);
  for (std::size_t column = 0; column < edge.size(); ++column) {
    lumen.push_back(m.join.columns[bowel][column].lumen);
    if (!s.cut) continue;
    for (const EdgeRow& row : m.cut.edge[bowel][column])         // the rim's own may be burnt
      if (row.vertex == edge[column]) lumen.back() = row.mucosa;
  }
  return lumen;
}

/// Smallest share of a lumen's cross-section at the edge that is left.  [1]
double openShare(const Model& m, const State& s) {
  double least = 1.0;                          // [1]
  for (int bowel = 0; bowel < 2; ++bowel) {
    const std::vector<int> lumen = mucosaAtEdge(m, s, bowel);
    least = std::min(least, enclosedArea(lumen, s.tissue.position) / enclosedArea(lumen, m.mesh.vertices));
  }
  return least;
}

bool onFreePiece(const Model& m, const State& s, int triangle) { return s.cut && s.cut->piece[m.surface.triangleTet[triangle]] != 0; }

/// Raises the pressure until something gives.
void raisePressure(const Model& m, const LeakTest& test, State& s, Outcome& out) {
  StepInput input = stillHands(s);
  StepOutput seen;
  const std::int32_t tears = s.metrics.tears;
  const double dt = m.params.dt;               // [s]
  const int settling = static_cast<int>(test.settle / dt + 0.5);   // steps
  double gap = 0.0;                            // [m]
  for (int k = 0; out.leakPressure < test.most; ++k) {
    out.leakPressure = std::min(test.most, std::max(0, k - settling) * dt * test.rate);
    input.lumenPressure = out.leakPressure * kPascalPerMmhg;
    step(m, input, s, seen);
    if (s.metrics.tears > tears) { out.end = LeakEnd::kTear; return; }
    if (s.step % kLook == 0 || k == 0) gap = measureWholeSeam(m, s).wallGap;
    if (gap <= test.gap) continue;
    out.end = out.leakPressure > 0.0 ? LeakEnd::kGap : LeakEnd::kOpen;
    if (k >= settling) return;                 // what is open while the tissue settles may still close
  }
  out.end = LeakEnd::kHeld;
}

}  // namespace

Outcome testOutcome(const Model& m, State s, const LeakTest& test) {
  Outcome out;
  if (!s.metrics.seam) return out;
  const JoinMetrics join = measureWholeSeam(m, s);
  if (join.crossings == 0) return out;
  out.tested = true;
  out.rimGap = join.rimGap;
  out.wallGap = join.wallGap;
  out.sewnShare = join.sewnShare;
  out.narrowing = 1.0 - openShare(m, s);
  raisePressure(m, test, s, out);
  return out;
}

void gatherPressure(const Model& m, const State& s, double pressure, std::vector<Vec3>& nodal) {
  if (!(pressure > 0.0)) return;
  for (std::size_t f = 0; f < m.surface.triangles.size(); ++f) {
    const int triangle = static_cast<int>(f);
    if (m.mesh.triangleLayer[f] != 1 || !exposed(m.surface, s.tissue.gone, triangle) || onFreePiece(m, s, triangle)) continue;
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
