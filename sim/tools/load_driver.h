#pragma once
/// A needle driver as it is handed over: the needle across the jaws, a third of the way from the swage, the ratchet shut, the thread hanging
/// straight down. No heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// Where the right hand begins with a pen the needled thread lies on the instrument table, out of the field, and does not move until a
/// thread has been handed.
bool beginsWithNeedle(const Model&);
bool threadOnTable(const Model&, const State&);
Pose needleOnTable();

/// The needle's frame in the driver's.
Pose loadedNeedle(const StrandModel&);

/// Puts the needle into this tool's jaws and says where that is in the world; the strand itself is the caller's.
Pose loadDriver(const Model&, ToolState&);

}  // namespace halsted
