#pragma once
/// A tool that has come free follows its hand. Its coupling has no mass and would take it there at once, past all that is on the way. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// What pulled or pushed at the tool with this force has come free: it follows its hand, but no faster than a hand moves.  [N]
void comeFree(const Model&, int hand, const Vec3& force, ToolState&);

/// The same for what thread and needle have done to it since it was here (parted, slid off) where it would run into tissue: contacts with tissue are looked
/// for a millimetre ahead. Anywhere else nothing is met on the way.  [m]
void followSlowly(const Model&, int hand, const Vec3& from, State&);

/// A step's way after the hand.
void catchUp(double dt, ToolState&);           // [s]

}  // namespace halsted
