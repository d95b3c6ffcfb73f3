#pragma once
/// Scenes with two bowel ends, made of one: side by side, both open ends facing the surgeon, as they are held for an anastomosis.
#include "sim/mesh.h"

namespace halsted::scenes {

/// `one` to the surgeon's left, and the same turned by half a turn about the line of sight to the right of it, so that the same side of
/// both walls meets in the middle, `gap` [m] apart. Vertices of the left end come first.
TetMesh twoEnds(const TetMesh& one, double gap);

/// The same two in one line across the surgeon's view, rim facing rim `gap` [m] apart, the top of both walls at y = 0: an anastomosis end to
/// end. Vertices of the left end come first.
TetMesh endToEnd(const TetMesh& one, double gap);

}  // namespace halsted::scenes
