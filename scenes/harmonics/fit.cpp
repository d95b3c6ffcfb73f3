#include "scenes/harmonics/fit.h"

#include <algorithm>
#include <cmath>

#include "scenes/harmonics/normal_matrix.h"
#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

/// Distances from the samples to the surface; the parametrisation's own slip along the surface is not an error of shape.
void measure(const FitSamples& s, const HarmonicSurface& surface, FitReport& report) {
  double sum = 0.0, along = 0.0, total = 0.0;  // [m^2], [m^2], [1]
  for (std::size_t v = 0; v < s.unit.size(); ++v) {
    const SurfaceFrame near = nearestPoint(surface, s.position[v], s.unit[v], 3);
    const double gap = (s.position[v] - near.position).norm();   // [m]
    sum += s.weight[v] * gap * gap;
    along += s.weight[v] * (s.position[v] - positionAt(surface, s.unit[v])).squaredNorm();
    total += s.weight[v];
    report.largest = std::max(report.largest, gap);
  }
  report.rms = std::sqrt(sum / total);
  report.residual = std::sqrt(along / total);
}

void requireSamples(int order, int given, const std::string& origin) {
  if (order < 1 || order > kMaxHarmonicOrder)
    throw InputError(origin + ": harmonic order " + std::to_string(order) + " is outside 1 to " + std::to_string(kMaxHarmonicOrder));
  if (given < 2 * harmonicCount(order))
    throw InputError(origin + ": order " + std::to_string(order) + " needs at least " + std::to_string(2 * harmonicCount(order)) +
                     " samples, there are " + std::to_string(given));
}

}  // namespace

HarmonicFit fitHarmonics(const FitSamples& samples, int order, const std::string& origin) {
  const int count = harmonicCount(order), given = static_cast<int>(samples.unit.size());
  requireSamples(order, given, origin);
  const HarmonicTables tables = harmonicTables(order);
  NormalMatrix matrix;
  if (!factorNormal(tables, samples, matrix))
    throw InputError(origin + ": order " + std::to_string(order) + " is too high: the samples leave parts of the sphere empty");
  // Solved twice: the second solve, for what the first left over, takes out the rounding of the normal equations.
  std::vector<Vec3> c(count, Vec3::Zero());
  for (int pass = 0; pass < 2; ++pass) {
    std::vector<Vec3> change = normalSide(tables, samples, c);
    solveNormal(matrix, change);
    for (int i = 0; i < count; ++i) c[i] += change[i];
  }
  HarmonicFit fit{harmonicSurface(order, c), {}};
  fit.report.order = order;
  fit.report.samples = given;
  fit.report.condition = matrix.condition;
  measure(samples, fit.surface, fit.report);
  return fit;
}

FitSamples samplesOf(const Surface& surface, const SphereMap& map) {
  const std::vector<double> area = vertexAreas(surface);   // [m^2]
  double total = 0.0;                          // [m^2]
  for (double a : area) total += a;
  FitSamples samples{map.unit, surface.vertices, area};
  for (double& w : samples.weight) w /= total;
  return samples;
}

HarmonicFit fitSurface(const Surface& surface, int order, const std::string& origin) {
  requireSphereLike(surface, origin);
  requireSamples(order, static_cast<int>(surface.vertices.size()), origin);   // of the surface as given: splitting adds no shape
  const Surface fine = refined(surface);
  const SphereMap map = mapToSphere(fine, origin);
  if (map.flipped > static_cast<int>(fine.triangles.size() / 200))
    throw InputError(origin + ": the surface folds over itself on the sphere in " + std::to_string(map.flipped) +
                     " triangles; cut a simpler region from it");
  HarmonicFit fit = fitHarmonics(samplesOf(fine, map), order, origin);
  fit.report.flipped = map.flipped;
  fit.report.areaSpread = map.areaSpread;
  return fit;
}

}  // namespace halsted::scenes
