#pragma once
/// Two places of the thread held at a distance from each other by a spring within the strand's own solve. What an assistance for
/// beginners ties with (sim/suture/assist_knot.h); a knot of friction needs none. Physics thread; no heap.
#include "sim/strand/coupled_solve.h"
#include "sim/strand/strand_model.h"
#include "sim/strand/thread_curve.h"

namespace halsted {

struct ThreadTie {
  CurveWeights first, second;
  Vec3 apart = Vec3::Zero();                   // [m] first minus second, as wanted
  double stiffness = 0.0;                      // [N/m] 0: there is no tie
};

/// Nodes that carry a material point of the thread, on its straight segment.  [m]
CurveWeights segmentWeights(const StrandModel&, double coordinate);

/// Force on the first place.  [N]
Vec3 tieForce(const ThreadTie&, const std::vector<Vec3>& nodes);

/// Adds force and stiffness at an iterate to the strand's system. The pair must be coupled there.
void assembleTie(const ThreadTie&, const std::vector<Vec3>& iterate, BandedMatrix&, std::vector<double>& rhs, CoupledSolve&);   // [N]

}  // namespace halsted
