#pragma once
/// How hands stand to a stitch. Private to scenes/.
#include "scenes/expert_state.h"

namespace halsted::scenes {

/// `side` leads from the tail's hole to the long end's; `up` away from the walls, out of the tissue and of the openings between two ends,
/// toward the surgeon elsewhere; `front` along the wound, square to both.
struct StitchFrame { Vec3 middle, side, up, front; };   // [m], [1]

/// Of a thread that lies in two holes at least.
StitchFrame stitchFrame(const Scene&);

}  // namespace halsted::scenes
