/// 6, 7 and 9: the same force at every rate, in the tick that reads the device, and as large as it should be.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "haptics/bench/bench.h"
#include "haptics/bench/driven.h"

namespace halsted::haptics::bench {

namespace {

constexpr double kRateError = 5.0;             // [%] devices.md 6
constexpr double kJustNoticeable = 7.0;        // [%] of a force, devices.md 9

/// A press of 4 mm that comes and goes smoothly in 0.8 s: y = 1 mm - 5 mm (3 s^2 - 2 s^3).
Vec3 pathAt(double time) {                     // [s] -> [m]
  const double s = std::min(1.0, (time < 0.4 ? time : 0.8 - time) / 0.4);   // [1]
  return {0.0, 1e-3 - 5e-3 * s * s * (3.0 - 2.0 * s), 0.0};
}

/// Force on that path at every 2 ms.
template <typename Environment>
std::vector<double> forceCurve(Environment environment, double period, int every) {   // [s] -> [N]
  DrivenRig rig;
  rig.config.period = period;
  std::vector<double> curve;                   // [N]
  const int perPoint = static_cast<int>(2e-3 / period + 0.5);
  for (int i = 0; i * period < 0.8; ++i) {
    const double force = rig.advanceAt(pathAt((i + 1) * period), environment, every).y();   // [N]
    if ((i + 1) % perPoint == 0) curve.push_back(force);
  }
  return curve;
}

double differenceInPercent(const std::vector<double>& a, const std::vector<double>& b) {   // [N] -> [%] of the largest
  double most = 0.0, largest = 0.0;            // [N]
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return 100.0 * most / largest;
}

template <typename Environment>
void compareRates(const char* name, const Environment& surface, Measurements& all) {
  const std::vector<double> reference = forceCurve(surface, 1e-3, 1);   // [N]
  for (const double rate : {500.0, 2000.0}) {  // [Hz]
    char text[64];
    std::snprintf(text, sizeof text, "%s, %.0f Hz against 1000 Hz", name, rate);
    all.push_back({"difference of force", text, differenceInPercent(forceCurve(surface, 1.0 / rate, 1), reference), "%", Bound::kAtMost, kRateError});
  }
  for (const int every : {16, 50}) {
    char text[64];
    std::snprintf(text, sizeof text, "%s, physics at %d Hz against 1000 Hz", name, 1000 / every);
    all.push_back({"difference of force", text, differenceInPercent(forceCurve(surface, 1e-3, every), reference), "%"});
  }
}

}  // namespace

Measurements measureRateInvariance() {
  Measurements all;
  compareRates("wall of 600 N/m", SpringWall{600.0, 0.5, 2e-3}, all);
  compareRates("tissue of 300 N/m", SoftTissue{}, all);
  return all;
}

Measurements measureLatency() {
  // One count of the encoder on a wall of 1 N/mm: after how many ticks does the written force show it?
  SpringWall wall{1000.0, 0.0, 2e-3};
  DrivenRig rig;
  const Vec3 outside(0.0, 0.055e-3, 0.0), inside(0.0, -0.055e-3, 0.0);   // [m]
  for (int i = 0; i < 100; ++i) rig.advanceAt(outside, wall);
  int ticks = 0;
  while (ticks < 100 && rig.advanceAt(inside, wall).y() <= 0.0) ++ticks;
  return {{"ticks from a sample in contact to its force", "wall of 1 N/mm", static_cast<double>(ticks), "ticks", Bound::kAtMost, 0.0}};
}

namespace {

struct SpringError { double steady = 0.0, moving = 0.0, counts = 0.0; };   // [%] at rest, on the move, and by what the counts hide

/// 3 mm in and out of a spring, 1 mm/s and then still for 60 ms at every fifth of a millimetre, read in counts of 0.055 mm.
SpringError springError(double stiffness) {    // [N/m]
  SpringWall wall{stiffness, 0.0, 2e-3};
  DrivenRig rig;
  SpringError error;
  for (int i = 0; i < 6000; ++i) {
    const double depth = 1e-6 * (i < 3000 ? i : 6000 - i) - 0.1e-3;              // [m]
    const double read = std::floor(depth / 0.055e-3 + 0.5) * 0.055e-3;           // [m]
    const bool rests = i % 200 == 0;
    double force = rig.advanceAt(Vec3(0.0, -read, 0.0), wall).y();               // [N]
    for (int k = 0; rests && k < 60; ++k) force = rig.advanceAt(Vec3(0.0, -read, 0.0), wall).y();
    if (force < 0.2 || force > 3.2) continue;
    double& worst = rests ? error.steady : error.moving;                         // [%]
    worst = std::max(worst, 100.0 * std::abs(force - stiffness * read) / (stiffness * read));
    if (rests) error.counts = std::max(error.counts, 100.0 * std::abs(force - stiffness * depth) / (stiffness * depth));
  }
  return error;
}

}  // namespace

Measurements measureAccuracy() {
  Measurements all;
  for (const double stiffness : {100.0, 300.0, 1020.0}) {
    const SpringError error = springError(stiffness);
    char text[64];
    std::snprintf(text, sizeof text, "spring of %.0f N/m, 0.2 to 3.2 N", stiffness);
    all.push_back({"error of a steady force against K x as read", text, error.steady, "%", Bound::kAtMost, kJustNoticeable});
    all.push_back({"the same on the move, 1 mm/s in and out", text, error.moving, "%"});
    all.push_back({"error of a steady force against K x as it is", text, error.counts, "%"});
  }
  return all;
}

}  // namespace halsted::haptics::bench
