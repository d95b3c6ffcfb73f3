#pragma once
/// The nearest of all surface vertices, found without a look at each: what lies in a box that is farther away than one already known is passed over. Physics
/// thread; no heap.
#include "sim/contact/surface.h"
#include "sim/work.h"

namespace halsted {

/// Where the vertices are now; to be filled anew once they have moved.
void fillBoxes(const SurfaceModel&, const SurfaceNow&, VertexBoxes&);

/// What nearestVertex (sim/contact/surface.h) finds, to the bit. `near`: a vertex that may be the one; only the time depends on it.
int nearestVertex(const SurfaceModel&, const SurfaceNow&, const VertexBoxes&, const Vec3& p, int near);   // p [m]

}  // namespace halsted
