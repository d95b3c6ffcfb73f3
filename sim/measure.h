#pragma once
/// Measures a step: motion, force, bites, opening. Fills the observation that the procedure table looks at. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

void measure(const Model&, const StepInput&, State&, StepOutput&);

/// Area enclosed by the rim's outline [m^2].
double openingArea(const TetMesh&, std::span<const Vec3> tissue);


}  // namespace halsted
