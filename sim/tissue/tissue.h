#pragma once
/// One tissue step, the same three calls whatever the solver (tissue.solver):
///   predictTissue   position := where inertia, gravity, `force` and elasticity take the tissue in dt
///   applyForceChange  position += A^-1 change: what contacts found out in between
///   finishTissue    velocity := (position - previous) / dt
/// Physics thread; no heap.
#include <span>

#include "sim/state.h"
#include "sim/tissue/tissue_model.h"

namespace halsted {

/// Scratch memory, sized once; contents are meaningless between steps and are not part of the state's hash.
struct TissueWork {
  std::vector<Vec3> previous;                  // [m] positions at the start of the step
  std::vector<Vec3> target;                    // per particle: right-hand side, or predicted position; by solver
  std::vector<double> rows;                    // per particle: four doubles for the factored solve
  std::vector<double> scratch;                 // by solver
};

TissueState restState(const TissueModel&);
TissueWork prepareWork(const TissueModel&);

/// force [N] per particle, kept constant during the step.
void predictTissue(const TissueModel&, std::span<const Vec3> force, TissueState&, TissueWork&);
/// Moves the tissue by A^-1 `change`, the response of this step to a change of force [N] (contacts, holes, grasps).
void applyForceChange(const TissueModel&, std::span<const Vec3> change, TissueState&, TissueWork&);
void finishTissue(const TissueModel&, TissueState&, const TissueWork&);

/// Elastic energy of the projective and xpbd material: mu |F - R|^2 + lambda/2 (det F - 1)^2, integrated.  [J]
double elasticEnergy(const TissueModel&, const TissueState&);

/// The solvers behind predictTissue; each reads work.previous.
void predictProjective(const TissueModel&, std::span<const Vec3> force, TissueState&, TissueWork&);
void predictXpbd(const TissueModel&, std::span<const Vec3> force, TissueState&, TissueWork&);
void predictShapeMatching(const TissueModel&, std::span<const Vec3> force, TissueState&, TissueWork&);

}  // namespace halsted
