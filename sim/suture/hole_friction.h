#pragma once
/// What holds thread or needle back at a hole of the strand, by its number. Used by holes.cpp only. Physics thread; no heap.
#include <optional>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline constexpr double kMostSlide = 1e-3;     // [m] a step: 1 m/s of thread through a hole

inline bool onNeedle(const Model& m, const Hole& h) { return h.coordinate > m.strand.length; }

/// Largest friction along the strand at a hole: capstan on the thread (Euler-Eytelwein), Coulomb on the needle, plus drag.  [N]
double frictionBound(const Model&, const StrandState&, int hole);

/// Whether the drag of the channel alone, a part of that bound, holds this force [N] along the strand: mostly so, and known without a tangent.
bool dragHolds(const Model&, const StrandState&, int hole, double along);

/// Turned back sharply at a hole, as a crossed tail is, thread's mean direction there leads nowhere, and it would stick however hard one leg
/// pulls: it creeps round by what the tauter leg pulls more than the other and friction hold. None where it is not turned so.  [m] a step
std::optional<double> creepRound(const Model&, const StrandState&, int hole);

}  // namespace halsted
