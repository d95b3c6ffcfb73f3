#pragma once
/// What instruments and thread do to the wall they press on (physics.md C1). The wall's surface at rest is divided into cells, one about each vertex.
/// Bowel that bears more than 330 kPa for 10 s is injured (BMJ SIT 2021); colon's muscle changes past 300 N s of force (s00464-018-6172-6).
/// Not counted: what thread presses inside its holes (it tears them), tied stitches, and faces that a cut has laid bare. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline constexpr double kTraumaPressure = 330e3;   // [Pa]
inline constexpr double kTraumaTime = 10.0;        // [s] in all, not at a stretch

/// Sizes `State::bruise` and the scratch for it.
void beginDamage(const Model&, State&);

/// Adds one step. An instrument's push is borne by the cells under it, what jaws hold by their pads (the pull on it; how hard they are squeezed is not
/// simulated), and thread or needle by the strip of a cell on which it lies.
void measureDamage(const Model&, State&);

}  // namespace halsted
