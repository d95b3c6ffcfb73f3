#pragma once
/// Tissue against itself and against the fixed rod: many slow contacts, each with a force kept from step to step that grows while the
/// gap is negative (an incremental Jacobi sweep on an over-estimated compliance, so it can only undershoot). Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// Updates the forces from the tissue as it stands after the other contacts; adds the change to `work.change`.
void solveTissueContact(const Model&, State&);

void gatherTissueContact(const Model&, const State&, std::vector<Vec3>& nodal);

}  // namespace halsted
