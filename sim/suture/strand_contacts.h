#pragma once
/// Thread and needle lying against tissue, tools and the rod: unilateral contacts with Coulomb friction at the thread's nodes and at
/// samples of the needle. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

/// Where the solids were before the tools moved in this step: friction needs their motion.
struct SolidMotion {
  std::array<CapsuleShape, kHands * 3 + 1> before, now;
};

/// Finds contacts at the predicted positions and adds a link for each, after the links already there.
void linkContacts(const Model&, const SolidMotion&, State&);

/// After the solve: adds a link for each node that it has taken through a face of the tissue of which nothing was known. True when there are any: the
/// step is to be solved once more, from where it began.
bool linkMetTissue(const Model&, State&);

/// After the solve: forces kept for the next step, forces on tools, change of force on the tissue; puncture by the tip.
void settleContacts(const Model&, State&, StepOutput&);

double contactFriction(const Model&, const StrandContact&);   // [1]

void gatherContactForces(const Model&, const StrandState&, std::vector<Vec3>& nodal);

}  // namespace halsted
