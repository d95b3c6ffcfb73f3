#pragma once
/// On which side of a wall each sample of the strand is, once a hole has led it through. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline constexpr double kLedSegments = 1.2;    // [1] of the thread: so far past itself a hole leads it

/// Is a hole on the inside of its wall, in the lumen?
bool onMucosa(const Model&, const Hole&);

/// After the holes have settled: a sample that a hole leads remembers the side that hole is on. A wall is thinner than the depth to which
/// a sample may be pressed in: one that has gone through into the lumen would else be pushed back out through the serosa.
void rememberSides(const Model&, State&);

}  // namespace halsted
