#pragma once
/// A needle driver as it is handed over: the needle across the jaws, a third of the way from the swage, the ratchet shut, the thread hanging
/// straight down. No heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// No hand holds a driver: the needled thread lies on the instrument table, out of the field, and does not move.
bool threadOnTable(const Model&);
Pose needleOnTable();

/// The needle's frame in the driver's.
Pose loadedNeedle(const StrandModel&);

/// Puts the needle into this tool's jaws and says where that is in the world; the strand itself is the caller's.
Pose loadDriver(const Model&, ToolState&);

}  // namespace halsted
