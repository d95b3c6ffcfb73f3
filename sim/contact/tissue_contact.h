#pragma once
/// Tissue against itself and against the fixed rod: many slow contacts, each with a force kept from step to step that grows while the
/// gap is negative. One Jacobi sweep a step on a bound of the compliance that counts every contact pushing at once, so it can only
/// undershoot, however many there are. Of tissue against itself half of what is missing is made good at once and only a little of it
/// kept: sewn walls then lie still, and come to bear what presses them over some hundreds of steps. What a free piece meets answers with
/// nearly twice the bound, below which a sweep still converges. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// Steps between two sweeps; in between every force is held, and the search for pairs goes on. 1 with the solvers that have a material.
/// Shape matching has none (physics.md 0.2): what a contact means there is set by the frame of the paper, and two sweeps in its eight
/// substeps bring the force up as the frame sees it, at a quarter of the cost. A closing of 0.1 m/s goes 0.6 mm between two sweeps of
/// the paper's step of 1.5 ms, less than what still counts as contact (kPairBehind).
int tissueContactInterval(const Model&);

/// Updates the forces from the tissue as it stands after the other contacts; adds the change to `work.change`.
void solveTissueContact(const Model&, State&);

void gatherTissueContact(const Model&, const State&, std::vector<Vec3>& nodal);

}  // namespace halsted
