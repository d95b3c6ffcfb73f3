#pragma once
/// Tools against tissue: contacts with Coulomb friction and grasps, solved together on the tissue's true compliance and the tools'
/// coupling (physics.md 0.8, B7; Duriez 2006). Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

/// Finds what touches, solves for the forces, and writes them to the tools and to `work.change`.
/// `before`: the tools' proxies at the start of the step.
void solveTouch(const Model&, const std::array<Pose, kHands>& before, State&);

void gatherTouchForces(const Model&, const State&, std::vector<Vec3>& nodal);

/// The tool lets go of what it touches, but not of what its jaws hold: those forces are no longer the tissue's.
void dropContacts(const Model&, int hand, State&);

/// A point of a surface triangle.
struct SurfacePlace {
  int triangle;
  const std::array<double, 3>& weight;         // [1]
};

/// How far a newton at one place of the surface moves another within a step.  [m/N]
double surfaceCompliance(const Model&, const SurfacePlace&, const SurfacePlace&);

/// What the tissue gives at one point when it is pushed there for one step [m/N].
double touchCompliance(const Model&, const TouchPoint&);

/// Force of the tissue on a tool [N]: where it touches, and with what its jaws hold.
Vec3 contactForce(const ToolState&);
Vec3 touchForce(const ToolState&);

/// Condensed stiffness of what the tool touches, as seen by a rigid translation of the tool [N/m].
Mat3 touchStiffness(const Model&, const State&, int hand);

}  // namespace halsted
