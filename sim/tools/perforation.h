#pragma once
/// A blunt instrument that goes through the wall. A pig's colon bears 13.5 (sd 3.7) N of a sphere of 1.5 mm, human small bowel 10.3 (sd 2.9)
/// (Heijnsdijk 2003, physics.md C1). Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

/// After `solveTouch`. An instrument that pushes harder than `tissue.perforation_force`, that pushes a part of the wall through to its other
/// side, or that has sunk in by one face of it and out by another, is through: until it lies in no tissue any more it meets neither tissue nor
/// thread (it would take that along), and what it pushed springs back. What its jaws hold they go on holding.
void settlePerforation(const Model&, int hand, State&, StepOutput&);

}  // namespace halsted
