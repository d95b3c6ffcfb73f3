#pragma once
/// Measures a step: motion, force, bites, opening. Fills the observation that the procedure table looks at. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

void measure(const Model&, const StepInput&, State&, StepOutput&);

}  // namespace halsted
