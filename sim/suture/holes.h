#pragma once
/// The strand through the tissue: puncture, the cut that follows the needle's tip, and holes through which needle and thread slide
/// with friction (physics.md B4). A hole is a material point of the tissue and a material coordinate of the strand; pulling changes
/// the coordinate, never a position. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"
#include "sim/suture/tissue_point.h"

namespace halsted {

/// Before the strand's solve: one link per hole, in hole order, starting at link 0.
void linkHoles(const Model&, State&);

/// After it: friction and slip, the tip's advance, exits and removals; adds the change of force to `work.change`.
void settleHoles(const Model&, State&, StepOutput&);

/// The tip has pressed through the surface at a point of a triangle: opens an entry hole and a cut at the tip.
/// `normal` [1] points out of the tissue there.
bool openEntry(const Model&, int triangle, const std::array<double, 3>& weight, const Vec3& normal, State&, StepOutput&);

/// A hole in a tet that is gone has torn, and its bite with it.
void tearHolesInGone(const Model&, State&, StepOutput&);

/// True when a coordinate lies inside the wall: between the holes of one bite, behind a tip that is still inside, or between a hole and an end
/// of the thread that is on its way through. Within a step, after `linkHoles`.
bool insideWall(const Model&, const State&, double coordinate, double margin);   // [m]

/// Adds force (on the strand: negated) of every hole to the tissue's nodal forces.
void gatherHoleForces(const Model&, const StrandState&, std::vector<Vec3>& nodal);

inline TissuePoint placeOf(const Hole& h) { return {h.tet, h.weight}; }
Vec3 holePoint(const Model&, const Hole&, std::span<const Vec3> tissue);

/// exp(mu phi) - 1 for the turn between two unit tangents, without libm: phi from its chord.  [1]
double capstanExcess(const Vec3& before, const Vec3& after, double friction);

void pushEvent(StepOutput&, const Event&);

}  // namespace halsted
