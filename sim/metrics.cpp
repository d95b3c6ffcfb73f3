#include "sim/metrics.h"

#include <algorithm>
#include <cmath>

namespace halsted {
namespace {

using Rows = std::vector<std::pair<std::string, double>>;

struct Spread { double mean = 0.0, deviation = 0.0; };   // unit of the values

/// Mean and sample standard deviation (n - 1) of one quantity of bites first..count-1.
template <class Quantity> Spread spread(const MetricsState& m, int first, int count, Quantity quantity) {
  const int n = count - first;
  Spread out;
  if (n <= 0) return out;
  for (int i = first; i < count; ++i) out.mean += quantity(m.bites[i]) / n;
  if (n == 1) return out;
  double sum = 0.0;                                      // [unit^2]
  for (int i = first; i < count; ++i) sum += (quantity(m.bites[i]) - out.mean) * (quantity(m.bites[i]) - out.mean);
  out.deviation = std::sqrt(sum / (n - 1));
  return out;
}

void addSpread(Rows& rows, const std::string& name, const std::string& unit, const Spread& value) {
  rows.emplace_back(name + "_mean_" + unit, value.mean);
  rows.emplace_back(name + "_sd_" + unit, value.deviation);
}

/// Angle between needle and inward normal, for reports: never inside a step, so acos is allowed as it is at load time (DESIGN 7.2).
double degrees(double cosine) {                          // [1]
  constexpr double kDegreesPerRadian = 57.295779513082323;   // [deg/rad]
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * kDegreesPerRadian;   // reports are made at load time or after a run
}

void addBites(Rows& rows, const MetricsState& m) {
  const int count = std::clamp<int>(m.biteCount, 0, kMaxBites);
  addSpread(rows, "bite_depth", "m", spread(m, 0, count, [](const BiteMetrics& b) { return b.depth; }));
  addSpread(rows, "bite_width", "m", spread(m, 0, count, [](const BiteMetrics& b) { return b.width; }));
  addSpread(rows, "wall_share", "1", spread(m, 0, count, [](const BiteMetrics& b) { return b.wallShare; }));
  // The first bite has no predecessor to be spaced from.
  addSpread(rows, "bite_spacing", "m", spread(m, 1, count, [](const BiteMetrics& b) { return b.spacing; }));
  addSpread(rows, "entry_angle", "deg", spread(m, 0, count, [](const BiteMetrics& b) { return degrees(b.entryAngle); }));
}

/// Of a scene with two ends.
void addJoin(Rows& rows, const JoinMetrics& join) {
  if (join.rimGap == 0.0 && join.wallGap == 0.0 && join.crossings == 0) return;
  rows.emplace_back("crossings", join.crossings);
  rows.emplace_back("rim_gap_m", join.rimGap);
  rows.emplace_back("wall_gap_m", join.wallGap);
  rows.emplace_back("inversion_deg", 90.0 - degrees(join.inversion));
  rows.emplace_back("tail_difference_m", join.tailDifference);
}

}  // namespace

Rows summarise(const MetricsState& m, double time) {     // time [s]
  Rows rows;
  rows.emplace_back("time_s", time);
  const char* const side[kHands] = {"left", "right"};
  for (int h = 0; h < kHands; ++h) {
    const HandMetrics& hand = m.hands[h];
    rows.emplace_back(std::string("path_length_") + side[h] + "_m", hand.pathLength);
    rows.emplace_back(std::string("peak_force_") + side[h] + "_n", hand.peakForce);
    rows.emplace_back(std::string("mean_force_") + side[h] + "_n", hand.forceSteps > 0.0 ? hand.forceSum / hand.forceSteps : 0.0);
  }
  rows.emplace_back("bites", m.biteCount);
  rows.emplace_back("stitches_across_opening", m.acrossOpening);
  rows.emplace_back("tears", m.tears);
  addBites(rows, m);
  rows.emplace_back("peak_stretch_1", m.peakStretch);
  rows.emplace_back("peak_tension_n", m.peakTension);
  rows.emplace_back("opening_area_m2", m.openingArea);
  rows.emplace_back("opening_fraction_1", m.restOpeningArea > 0.0 ? m.openingArea / m.restOpeningArea : 1.0);
  rows.emplace_back("full_thickness_bites", m.fullThickness);
  rows.emplace_back("thread_cuts", m.threadCuts);
  addJoin(rows, m.join);
  return rows;
}

}  // namespace halsted
