#pragma once
/// The needle tip inside the wall: a material point that the tip pushes through the tissue, tet by tet.
#include <span>

#include "sim/model.h"
#include "sim/strand/strand_state.h"

namespace halsted {

struct CutLimits {
  double cut = 0.0, exit = 0.0, withdraw = 0.0;   // [N] forward inside, forward through the far surface, backward
};

enum class CutResult { kMoved, kAtSurface };

/// Moves the hole's material point by `step` [m] in the deformed tissue; it stops on the surface when the path leaves the wall.
CutResult advanceCut(const Model&, const SurfaceNow& tissue, const Vec3& step, Hole&);

}  // namespace halsted
