#pragma once
/// What the scripted surgeon sees of a bite under way: whether the needle has gone in, where it came out, and whether it went astray.
/// Private to scenes/.
#include "scenes/expert_state.h"

namespace halsted::scenes {

/// Has the tip gone in?
bool entered(const State&, std::int32_t bite);
/// Has the tip slid along the wall instead, so far from its place that it would go in elsewhere, or off the edge into the other wall?
bool slidAway(const Scene&);
/// The exit hole of the bite under way, once the tip has come out; nullptr before.
const Hole* exitHole(const State&, std::int32_t bite);
/// Has it come out and caught the wall again?
bool tipInWall(const State&);
/// How often the tip has come out of the wall in the bite under way: through the lumen it does twice.
int exits(const Scene&);
/// Has the tip come out where it should not: so near to where it went in that it is through the wall, in the lumen; or, where that is
/// wanted, on the outside at once?
bool astray(const Scene&);

}  // namespace halsted::scenes
