#include <algorithm>
#include <cmath>

#include "scenes/harmonics/sphere_map.h"
#include "sim/harmonics/surface.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

/// Coarse first: what a low order evens out needs no small steps.
struct Stage { int order, mostSteps; };
constexpr Stage kStages[] = {{6, 40}, {12, 40}, {24, 30}};
constexpr double kStep = 0.25;                 // [1] share of the excess density to remove in a step
constexpr double kLongest = 0.7;               // [rad] of one step times the order: a tenth of the finest harmonic's wave
constexpr double kEven = 0.03;                 // [1] a stage ends when the density it sees is even to this,
constexpr double kGain = 0.99;                 // [1] or when a step no longer gains a hundredth
constexpr double kLeastDensity = 0.2;          // [1] floor of the divisor, so that empty regions do not fly

/// Share of order l that is kept: a smooth fall to a third at the highest order holds the ringing down.
double smoothing(int l, int order) {           // [1]
  const double s = l / (order + 1.0);          // [1]
  return 1.0 / (1.0 + 2.0 * s * s * s * s);
}

/// Density of the area on the sphere, mean 1, and the potential whose gradient carries the excess away: x and y components of one
/// harmonic surface, so that one evaluation gives both.
struct Field { HarmonicSurface both; double unevenness = 0.0; };   // [1]

Field fieldOf(const HarmonicTables& tables, const std::vector<double>& share, const std::vector<Vec3>& unit) {   // share [1]
  std::vector<double> density(harmonicCount(tables.order), 0.0), values(harmonicCount(tables.order));   // [1]
  for (std::size_t v = 0; v < unit.size(); ++v) {
    harmonics(tables, unit[v], values);
    for (std::size_t i = 0; i < values.size(); ++i) density[i] += share[v] * values[i];
  }
  std::vector<Vec3> c(density.size(), Vec3::Zero());
  double sum = 0.0;                            // [1]
  for (int l = 0; l <= tables.order; ++l)
    for (int m = -l; m <= l; ++m) {
      const int i = harmonicIndex(l, m);
      const double kept = 4.0 * kPi * smoothing(l, tables.order) * density[i];   // [1]
      c[i] = Vec3(kept, l > 0 ? -kept / (l * (l + 1.0)) : 0.0, 0.0);   // Laplacian of Y_lm: -l (l + 1) Y_lm
      if (l > 0) sum += kept * kept / (4.0 * kPi);
    }
  return {harmonicSurface(tables.order, c), std::sqrt(sum)};
}

/// One step along the field; returns nothing but the moved directions.
void follow(const Field& field, int order, std::vector<Vec3>& unit) {
  std::vector<Vec3> velocity(unit.size());     // [1] per step
  double fastest = 0.0;                        // [1]
  for (std::size_t v = 0; v < unit.size(); ++v) {
    const SurfaceFrame f = frameAt(field.both, unit[v]);
    velocity[v] = (f.tangent1.y() * f.direction1 + f.tangent2.y() * f.direction2) / std::max(f.position.x(), kLeastDensity);
    fastest = std::max(fastest, velocity[v].squaredNorm());
  }
  const double scale = std::min(kStep, kLongest / order / std::sqrt(std::max(fastest, 1e-300)));   // [1]
  for (std::size_t v = 0; v < unit.size(); ++v) unit[v] = (unit[v] + scale * velocity[v]).normalized();
}

}  // namespace

int equaliseArea(const std::vector<double>& area, std::vector<Vec3>& unit) {
  double total = 0.0;                          // [m^2]
  for (double a : area) total += a;
  std::vector<double> share(area.size());      // [1]
  for (std::size_t v = 0; v < area.size(); ++v) share[v] = area[v] / total;
  int steps = 0;
  for (const Stage& stage : kStages) {
    const HarmonicTables tables = harmonicTables(stage.order);
    double before = 1e300;                     // [1]
    for (int step = 0; step < stage.mostSteps; ++step, ++steps) {
      const Field field = fieldOf(tables, share, unit);
      if (field.unevenness < kEven || field.unevenness > kGain * before) break;
      before = field.unevenness;
      follow(field, stage.order, unit);
    }
  }
  return steps;
}

}  // namespace halsted::scenes
