#pragma once
/// How far thread can be drawn through a hole: to the end of what lies between it and its neighbours, and not through a knot. Physics
/// thread; no heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline constexpr double kOutOfHole = 0.3e-3;   // [m] the tip is this far out of a hole before the hole counts as left

/// The strand between two holes cannot be shorter than the straight way between them: how far hole i may go toward a coordinate.  [m]
double withinReach(const Model&, const State&, int i, double wanted);   // [m]

/// Does the thread go from hole i over to the other bowel, on the side of larger (+1) or smaller (-1) coordinates?
bool leadsToOtherBowel(const Model&, const StrandState&, int i, int way);

/// Does it go there over the beginner's knot? True of the first and the last hole of a stitch between two bowels.
bool leadsOverKnot(const Model&, const State&, int i);

/// Can no thread come through hole i from the side that `along` pulls it to? At a knot, or at the other bowel, it carries the pull instead.
bool blocked(const Model&, const State&, int i, double along);   // [N]

}  // namespace halsted
