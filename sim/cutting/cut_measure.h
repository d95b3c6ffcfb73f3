#pragma once
/// How the cut lies to its line. A measurement, no physics. Physics thread; no heap.
#include "sim/procedure.h"

namespace halsted {

struct Model;
struct State;
struct CutMetrics;

/// Shares and errors from what is gone: after a tet went. A part of the circumference counts as cut through when, within it, nothing that
/// is left leads from the side that stays to the specimen's.
void measureCut(const Model&, State&);

void observe(const CutMetrics&, Observation&);

}  // namespace halsted
