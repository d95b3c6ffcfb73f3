#pragma once
/// The strand's part of a step where thread meets itself (`thread.knots`): several substeps of one coupled solve in which thread touches
/// thread and tools; tools and grips move evenly through the step. Links to tissue and holes are those of the whole step, so what is
/// settled after the last substep is as if the step had been one. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"
#include "sim/suture/strand_contacts.h"
#include "sim/tools/grasp.h"

namespace halsted {

/// How tools and grips move in this step.
struct KnottingMotion {
  SolidMotion solids;
  std::array<Pose, kHands> toolBefore;
  std::array<GraspLinks, kHands> grasps;
};

/// Solves the strand's step; false if a substep could not be solved: then the thread stays where those before it have taken it. Thread that is
/// pulled too hard breaks.
bool solveKnottedStrand(const Model&, const KnottingMotion&, State&, StepOutput&);

/// After the contacts are settled: the push of the thread on the tools it lies against, where the last substep has left them.
void settleToolForces(State&);

/// Whether the thread is parted at a coordinate: what slides or grips there has come to an end.
bool partedAt(const Model&, const State&, double coordinate);   // [m]

/// Where the thread comes to an end on the needle's side of a coordinate: at the swage, or where it is parted.  [m]
double threadEnd(const Model&, const State&, double coordinate);   // [m]

}  // namespace halsted
