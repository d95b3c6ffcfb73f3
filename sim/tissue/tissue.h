#pragma once
/// One tissue step, the same three calls whatever the solver (tissue.solver):
///   predictTissue   position := where inertia, gravity, `force` and elasticity take the tissue in dt
///   applyForceChange  position += A^-1 change: what contacts found out in between
///   finishTissue    velocity := (position - previous) / dt
/// Physics thread; no heap.
#include <span>

#include "sim/state.h"
#include "sim/tissue/tissue_model.h"
#include "sim/work.h"

namespace halsted {

TissueState restState(const TissueModel&);
TissueWork prepareWork(const TissueModel&);

/// force [N] per particle, kept constant during the step.
void predictTissue(const TissueModel&, std::span<const Vec3> force, TissueState&, TissueWork&);
/// Moves the tissue by A^-1 `change`, the response of this step to a change of force [N] (contacts, holes, grasps).
void applyForceChange(const TissueModel&, std::span<const Vec3> change, TissueState&, TissueWork&);
void finishTissue(const TissueModel&, TissueState&, const TissueWork&);

/// After the projective solver's local step: what the tets that are gone add to its right-hand side (sim/tissue/projective_gone.cpp).
void relaxGone(const TissueModel&, TissueState&, TissueWork&);

/// Elastic energy of the material that the solver stands for (shape matching: the corotated one that its constants come from).  [J]
double elasticEnergy(const TissueModel&, const TissueState&);

/// The solvers behind predictTissue; each reads work.previous.
void predictProjective(const TissueModel&, std::span<const Vec3> force, TissueState&, TissueWork&);
void predictXpbd(const TissueModel&, std::span<const Vec3> force, TissueState&, TissueWork&);
void predictShapeMatching(const TissueModel&, std::span<const Vec3> force, TissueState&, TissueWork&);

}  // namespace halsted
