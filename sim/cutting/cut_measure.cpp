#include "sim/cutting/cut_measure.h"

#include <cmath>

#include "sim/model.h"
#include "sim/state.h"
#include "sim/union_find.h"

namespace halsted {
namespace {

/// Joins what is left of a bin by shared corners, then asks whether the two sides are still one.
bool cutThrough(const Model& m, int bin, State& s) {
  auto& parent = s.work.cut.parent;
  auto& label = s.work.cut.label;              // per root: bit 1 touches the side that stays, bit 2 the specimen's
  const int from = m.cut.binStart[bin], to = m.cut.binStart[bin + 1];
  for (int i = from; i < to; ++i)
    for (int v : m.tissue.tets[m.cut.binTet[i]]) { parent[v] = v; label[v] = 0; }
  for (int i = from; i < to; ++i) {
    const int t = m.cut.binTet[i];
    if (s.tissue.gone[t]) continue;
    for (int c = 1; c < 4; ++c) join(parent, m.tissue.tets[t][0], m.tissue.tets[t][c]);
  }
  for (int i = from; i < to; ++i) {
    const int t = m.cut.binTet[i];
    if (s.tissue.gone[t] || m.cut.side[i] == CutSide::kWithin) continue;
    std::int32_t& sides = label[rootOf(parent, m.tissue.tets[t][0])];
    sides |= m.cut.side[i] == CutSide::kStays ? 1 : 2;
    if (sides == 3) return false;
  }
  return true;
}

void measureError(const Model& m, const State& s, CutMetrics& metrics) {
  double sum = 0.0, volume = 0.0;              // [m^4], [m^3]
  metrics.errorWorst = 0.0;
  for (std::size_t t = 0; t < m.mesh.cutLine.size(); ++t) {
    if (s.tissue.gone[t] != static_cast<std::uint8_t>(Gone::kBurnt)) continue;
    const double off = std::fabs(m.mesh.cutLine[t].fromLine);    // [m]
    sum += m.tissue.restVolume[t] * off;
    volume += m.tissue.restVolume[t];
    metrics.errorWorst = std::fmax(metrics.errorWorst, off);
  }
  metrics.errorMean = volume > 0.0 ? sum / volume : 0.0;
}

}  // namespace

void measureCut(const Model& m, State& s) {
  CutMetrics& metrics = *s.metrics.cut;
  if (m.cut.binStart.empty()) return;
  for (int wall = 0; wall < kCutWalls; ++wall) {
    const int from = m.cut.wallStart[wall], to = m.cut.wallStart[wall + 1];
    int through = 0;
    for (int bin = from; bin < to; ++bin) through += cutThrough(m, bin, s);
    metrics.share[wall] = to > from ? static_cast<double>(through) / (to - from) : 0.0;
  }
  measureError(m, s, metrics);
}

void observe(const CutMetrics& cut, Observation& seen) {
  const auto set = [&](Quantity q, double value) { seen[static_cast<int>(q)] = value; };
  set(Quantity::kCutShareOuter, cut.share[0]);
  set(Quantity::kCutShareInner, cut.share[1]);
  set(Quantity::kCutError, cut.errorWorst);
  set(Quantity::kOvershoot, cut.overshoot);
  set(Quantity::kCutTime, cut.time);
  set(Quantity::kCutEnergy, cut.energy);
  set(Quantity::kCurrent, cut.current);
  set(Quantity::kSpecimenFree, cut.freePieces + cut.taken);
  set(Quantity::kSpecimenTaken, cut.taken);
}

}  // namespace halsted
