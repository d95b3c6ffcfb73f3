#pragma once
/// Nested surfaces under a skin: the same harmonics, moved inward along the normal by what lies above them.
#include <string>
#include <vector>

#include "sim/harmonics/surface.h"

namespace halsted::scenes {

/// Directions spread evenly over the sphere (spiral points of Rakhmanov, Saff and Zhou 1994), from z = 1 down.
std::vector<Vec3> spreadDirections(int count);

/// One surface for each depth, the skin's own order: depth 0 is the skin itself. depths [m], rising. Throws InputError "origin: ..." for
/// a negative thickness and for a layer deeper than the skin's smallest radius of curvature allows, where it would fold.
std::vector<HarmonicSurface> nestedSurfaces(const HarmonicSurface& skin, const std::vector<double>& depths, const std::string& origin);

}  // namespace halsted::scenes
