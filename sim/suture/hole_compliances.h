#pragma once
/// How far the tissue gives at the holes of a thread. Used by holes.cpp only. Physics thread; no heap.
#include "sim/model.h"
#include "sim/work.h"

namespace halsted {

/// Own compliance, and an upper bound for the coupled system: with it the incremental exchange of force can only undershoot.
void holeCompliances(const Model&, const StrandState&, HoleWork&);   // fills `self` and `bound` [m/N]

}  // namespace halsted
