#pragma once
/// Tissue against itself and against the fixed rod: many slow contacts, each with a force kept from step to step that grows while the
/// gap is negative. One Jacobi sweep a step on a bound of the compliance that counts every contact pushing at once, so it can only
/// undershoot, however many there are. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// Updates the forces from the tissue as it stands after the other contacts; adds the change to `work.change`.
void solveTissueContact(const Model&, State&);

void gatherTissueContact(const Model&, const State&, std::vector<Vec3>& nodal);

}  // namespace halsted
