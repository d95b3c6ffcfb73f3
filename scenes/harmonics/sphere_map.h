#pragma once
/// Lays a closed surface without holes or handles on the unit sphere, one to one and nearly uniformly: the parametrisation that a
/// harmonic fit needs. Two published flows, at load time:
/// 1. Conformalised mean curvature flow (Kazhdan, Solomon and Ben-Chen 2012) until the surface is star-shaped about its centre, then
///    projection on the sphere.
/// 2. Density-equalising flow on the sphere (Lyu, Lui and Choi 2024; the velocity is that of Dacorogna and Moser 1990): area that lies
///    too dense spreads out along the gradient of a potential, here a sum of harmonics.
#include <vector>

#include "scenes/mesh_readers/surface.h"

namespace halsted::scenes {

/// Throws InputError "origin: ..." unless the surface is one piece, closed, and has no handle (Euler characteristic 2).
void requireSphereLike(const Surface&, const std::string& origin);

/// A third of the triangles round each vertex.  [m^2]
std::vector<double> vertexAreas(const Surface&);

/// The same surface with its long edges split at their middles, so that its vertices sample it evenly: flat parts of a decimated
/// surface, and cuts that were closed, have few vertices of their own.
Surface refined(const Surface&);

struct SphereMap {
  std::vector<Vec3> unit;          // per vertex
  int flowSteps = 0, areaSteps = 0;
  double areaSpread = 0.0;         // [1] standard deviation of (area on the sphere / area of the surface), both as shares of the whole
  int flipped = 0;                 // triangles turned over by the map: 0 when it is one to one
};

/// Throws InputError "origin: ..." for what requireSphereLike refuses and for a surface that does not become star-shaped.
SphereMap mapToSphere(const Surface&, const std::string& origin);

/// The two parts of it, for tests. `flow` returns a star-shaped surface's directions; `equaliseArea` moves them.
std::vector<Vec3> flowToSphere(const Surface&, const std::string& origin, int& steps);
int equaliseArea(const std::vector<double>& area, std::vector<Vec3>& unit);   // area [any], returns the number of steps

}  // namespace halsted::scenes
