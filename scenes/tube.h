#pragma once
/// A piece of real bowel: a triangle surface of a tube, cut to a segment with an open rim, as wall tetrahedra.
#include "scenes/mesh_readers/surface.h"
#include "sim/mesh.h"
#include "sim/params.h"

namespace halsted::scenes {

/// Rim centred at the origin facing +z, tube running to -z, the file's +y as near to +y as that allows; never deformed, only moved.
/// Holes are closed from their surroundings while at most a fifth of the wall is missing.
/// Throws InputError, without the file's name: not a tube, wrong scale, too short, too sharply bent, non-manifold, too many holes.
TetMesh tubeSegment(const Surface&, const AnatomyParams&);

}  // namespace halsted::scenes
