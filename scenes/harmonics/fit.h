#pragma once
/// Least-squares fit of a closed surface by spherical harmonics (acupuncture-force-net 2021, eq. 4), at load time.
#include "scenes/harmonics/sphere_map.h"
#include "sim/harmonics/surface.h"

namespace halsted::scenes {

/// Places of a surface and where they lie on the sphere; `weight` is each one's share of the area.
struct FitSamples {
  std::vector<Vec3> unit, position;            // [1], [m]
  std::vector<double> weight;                  // [1] any scale
};

struct FitReport {
  int order = 0, samples = 0, flipped = 0;
  double condition = 0.0;                      // [1] of the weighted matrix of eq. 4, largest over smallest singular value
  double rms = 0.0, largest = 0.0;             // [m] between each sample and the point of the surface nearest to it
  double residual = 0.0;                       // [m] root mean square of eq. 4's own residual, along the surface too
  double areaSpread = 0.0;                     // [1] see SphereMap
};

struct HarmonicFit { HarmonicSurface surface; FitReport report; };

/// Throws InputError "origin: ..." when there are fewer than two samples a coefficient, or when they leave a coefficient undetermined.
HarmonicFit fitHarmonics(const FitSamples&, int order, const std::string& origin);

/// The samples of a surface: its vertices on the sphere, weighted by area.
FitSamples samplesOf(const Surface&, const SphereMap&);

/// All of it: refine, map to the sphere, fit. Throws InputError "origin: ..." also when the map is not one to one but for slivers.
HarmonicFit fitSurface(const Surface&, int order, const std::string& origin);

}  // namespace halsted::scenes
