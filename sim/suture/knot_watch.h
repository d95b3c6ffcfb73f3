#pragma once
/// Looks ten times a second at what the thread has been tied to: throws with their senses, where the knot sits, turns about the tools.
/// It only looks: nothing in the physics depends on it. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

inline constexpr double kKnotInterval = 0.1;     // [s] between looks: what is read of a knot is no older

void watchKnots(const Model&, State&, StepOutput&);

}  // namespace halsted
