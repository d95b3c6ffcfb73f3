#include "scenes/harmonics/layers.h"

#include <cmath>

#include "scenes/harmonics/fit.h"
#include "scenes/input_text.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

/// Largest curvature toward the inside: a layer at depth d folds where d times it exceeds 1.
double sharpestBend(const HarmonicSurface& s, const Vec3& unit) {   // [1/m]
  const SurfaceFrame f = frameAt(s, unit);
  const SurfaceBend bend = bendAt(s, f);
  const double e = f.tangent1.squaredNorm(), g = f.tangent1.dot(f.tangent2), h = f.tangent2.squaredNorm();         // [m^2]
  const double l = bend.along11.dot(f.normal), m = bend.along12.dot(f.normal), n = bend.along22.dot(f.normal);     // [m]
  const double det = e * h - g * g;            // [m^4]
  const double mean = 0.5 * (e * n - 2.0 * g * m + h * l) / det, gauss = (l * n - m * m) / det;                    // [1/m], [1/m^2]
  return -mean + std::sqrt(std::max(mean * mean - gauss, 0.0));     // an outward normal sees a sphere bend away: negative
}

}  // namespace

std::vector<Vec3> spreadDirections(int count) {
  std::vector<Vec3> units;
  double angle = 0.0;                          // [rad]
  for (int k = 0; k < count; ++k) {
    const double z = 1.0 - 2.0 * k / (count - 1.0), across = std::sqrt(std::max(1.0 - z * z, 0.0));   // [1]
    if (k > 0 && k < count - 1) angle += 3.6 / (std::sqrt(static_cast<double>(count)) * across);
    if (angle > 2.0 * kPi) angle -= 2.0 * kPi;
    units.push_back(Vec3(across * cosine(angle), across * sine(angle), z));
  }
  return units;
}

std::vector<HarmonicSurface> nestedSurfaces(const HarmonicSurface& skin, const std::vector<double>& depths, const std::string& origin) {
  const int order = skin.tables.order;
  const std::vector<Vec3> units = spreadDirections(4 * harmonicCount(order));
  double above = 0.0, bend = 0.0;              // [m], [1/m]
  for (const Vec3& u : units) bend = std::max(bend, sharpestBend(skin, u));
  std::vector<HarmonicSurface> surfaces;
  for (double depth : depths) {
    if (!(depth >= above)) throw InputError(origin + ": a layer has a negative thickness, " + plainNumber(1e3 * (depth - above)) + " mm");
    if (depth * bend >= 1.0)
      throw InputError(origin + ": a layer " + plainNumber(1e3 * depth) + " mm deep folds under a bend of radius " +
                       plainNumber(1e3 / bend) + " mm");
    above = depth;
    if (depth == 0.0) { surfaces.push_back(skin); continue; }
    FitSamples samples;
    for (const Vec3& u : units) {
      const SurfaceFrame f = frameAt(skin, u);
      samples.unit.push_back(u);
      samples.position.push_back(f.position - depth * f.normal);
      samples.weight.push_back(1.0);
    }
    surfaces.push_back(fitHarmonics(samples, order, origin).surface);
  }
  return surfaces;
}

}  // namespace halsted::scenes
