#pragma once
/// The line down the middle of a tube-like surface.
#include <vector>

#include "scenes/mesh_readers/surface.h"

namespace halsted::scenes {

/// Points at equal distances along the line.
struct Centreline {
  std::vector<Vec3> points;        // [m]
  double spacing = 0.0;            // [m]

  double length() const { return spacing * static_cast<double>(points.size() - 1); }
  Vec3 at(double distance) const;                     // [m] from the start, clamped to the line
  Vec3 tangent(double distance) const;                // [1] over one spacing to either side
  double nearest(const Vec3& place) const;            // [m] along the line, of the point of the line nearest to a place
};

/// The connected piece with the largest bounding box: of a double wall that is the outer one, of a body's parts the longest.
/// Throws InputError when too many of its edges join more than two triangles.
Surface largestPart(const Surface&);

/// First guess, good to about a radius: centres of the level sets of the distance along the surface from one end. The end with the
/// vertex of lower index comes first. Works on open, holed and non-manifold surfaces.
Centreline traceCentreline(const Surface&);

/// The same line with its points at `spacing`, averaged over `window` to both sides. The ends stay.
Centreline resampled(const Centreline&, double spacing);          // [m]
Centreline smoothed(const Centreline&, double window);            // [m]

}  // namespace halsted::scenes
