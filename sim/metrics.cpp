#include "sim/metrics.h"

#include <algorithm>
#include <cmath>

#include "sim/portable_math.h"

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

/// Angle between needle and inward normal.  cosine [1] -> [deg]
double degrees(double cosine) { return 90.0 - arcSine(cosine) * 180.0 / kPi; }

void addBites(Rows& rows, const MetricsState& m) {
  const int count = std::clamp<int>(m.biteCount, 0, kMaxBites);
  addSpread(rows, "bite_depth", "m", spread(m, 0, count, [](const BiteMetrics& b) { return b.depth; }));
  addSpread(rows, "bite_width", "m", spread(m, 0, count, [](const BiteMetrics& b) { return b.width; }));
  // The first bite has no predecessor to be spaced from.
  addSpread(rows, "bite_spacing", "m", spread(m, 1, count, [](const BiteMetrics& b) { return b.spacing; }));
  addSpread(rows, "entry_angle", "deg", spread(m, 0, count, [](const BiteMetrics& b) { return degrees(b.entryAngle); }));
}

/// Of a scene with two ends.
void addSeam(Rows& rows, const SeamMetrics& seam, int bites) {
  const JoinMetrics& join = seam.join;
  for (int i = 0; i < bites; ++i) rows.emplace_back("wall_share_" + std::to_string(i + 1) + "_1", seam.wallShare[i]);
  rows.emplace_back("full_thickness_bites", seam.fullThickness);
  rows.emplace_back("crossings", join.crossings);
  rows.emplace_back("rim_gap_m", join.rimGap);
  rows.emplace_back("wall_gap_m", join.wallGap);
  rows.emplace_back("inversion_deg", 90.0 - degrees(join.inversion));
  rows.emplace_back("tail_difference_m", join.tailDifference);
}

/// Of tissue that can be cut.
void addCut(Rows& rows, const CutMetrics& cut) {
  rows.emplace_back("cut_share_outer_1", cut.share[0]);
  rows.emplace_back("cut_share_inner_1", cut.share[1]);
  rows.emplace_back("cut_error_mean_m", cut.errorMean);
  rows.emplace_back("cut_error_worst_m", cut.errorWorst);
  rows.emplace_back("cut_energy_j", cut.energy);
  rows.emplace_back("cut_overshoot_j", cut.overshoot);
  rows.emplace_back("cut_time_s", cut.time);
  rows.emplace_back("burnt_tets", cut.burnt);
  rows.emplace_back("free_pieces", cut.freePieces);
  rows.emplace_back("pieces_taken", cut.taken);
  rows.emplace_back("crumbs", cut.crumbs);
}

/// Of instruments, and of thread and needle (`strand`).
void addDamage(Rows& rows, const DamageMetrics& d) {
  rows.emplace_back("force_time_left_n_s", d.forceTime[kLeft]);
  rows.emplace_back("force_time_right_n_s", d.forceTime[kRight]);
  const char* const presser[kPressers] = {"instruments", "strand"};
  for (int p = 0; p < kPressers; ++p) {
    rows.emplace_back(std::string("peak_pressure_") + presser[p] + "_pa", d.peakPressure[p]);
    rows.emplace_back(std::string("pressure_dose_") + presser[p] + "_n_s", d.dose[p]);
    rows.emplace_back(std::string("injured_area_") + presser[p] + "_m2", d.injured[p]);
  }
}

void addSuture(Rows& rows, const MetricsState& m) {
  rows.emplace_back("bites", m.biteCount);
  rows.emplace_back("stitches_across_opening", m.acrossOpening);
  rows.emplace_back("tears", m.tears);
  rows.emplace_back("perforations", m.perforations);
  addDamage(rows, m.damage);
  addBites(rows, m);
  rows.emplace_back("peak_stretch_1", m.peakStretch);
  rows.emplace_back("peak_tension_n", m.peakTension);
  rows.emplace_back("opening_area_m2", m.openingArea);
  rows.emplace_back("opening_fraction_1", m.restOpeningArea > 0.0 ? m.openingArea / m.restOpeningArea : 1.0);
  if (m.cut) addCut(rows, *m.cut);
  if (m.assistedKnots) rows.emplace_back("assisted_knots", *m.assistedKnots);
  if (m.seam) addSeam(rows, *m.seam, std::clamp<int>(m.biteCount, 0, kMaxBites));
}

constexpr double kDegrees = 57.295779513082323;          // [deg/rad]

Spread spread(double sum, double squares, int n) {       // unit of the values, squared
  if (n <= 0) return {};
  const double mean = sum / n;
  return {mean, n > 1 ? std::sqrt(std::max(0.0, (squares - n * mean * mean) / (n - 1))) : 0.0};
}

/// Regularity tells teachers from students (Tang 2017, physics.md C3): spread over mean of the amplitudes, and spread of the troughs.
void addStrokes(Rows& rows, const std::string& name, const std::string& unit, const Strokes& s, double scale) {   // scale [unit per m or rad]
  const Spread size = spread(s.amplitude, s.amplitudeSquares, s.counted), trough = spread(s.trough, s.troughSquares, s.troughs);
  rows.emplace_back(name + "_strokes", s.count);
  rows.emplace_back(name + "_strokes_in_range", s.counted);
  rows.emplace_back(name + "_amplitude_mean_" + unit, scale * size.mean);
  rows.emplace_back(name + "_amplitude_cv_1", size.mean > 0.0 ? size.deviation / size.mean : 0.0);
  rows.emplace_back(name + "_trough_sd_" + unit, scale * trough.deviation);
}

void addNeedling(Rows& rows, const NeedlingMetrics& m) {
  rows.emplace_back("entry_offset_m", m.entryOffset);
  rows.emplace_back("insertion_angle_deg", kDegrees * m.angle);
  rows.emplace_back("deepest_m", m.deepest);
  rows.emplace_back("depth_error_m", m.depthError);
  rows.emplace_back("insertion_time_s", m.reachedAt > 0.0 ? m.reachedAt - m.enteredAt : 0.0);
  rows.emplace_back("needling_time_s", m.left ? m.leftAt - m.enteredAt : 0.0);
  rows.emplace_back("peak_insertion_force_n", m.peakForce);
  rows.emplace_back("peak_pull_n", m.peakPull);
  rows.emplace_back("peak_grasp_1", m.peakGrasp);
  rows.emplace_back("peak_torque_nm", m.peakTorque);
  rows.emplace_back("peak_withdrawal_speed_m_s", m.peakWithdrawal);
  rows.emplace_back("turned_deg", kDegrees * m.turned);
  addStrokes(rows, "twirl", "deg", m.twirls, kDegrees);
  addStrokes(rows, "lift", "m", m.lifts, 1.0);
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
  if (m.needling) addNeedling(rows, *m.needling);
  else addSuture(rows, m);
  return rows;
}

}  // namespace halsted
