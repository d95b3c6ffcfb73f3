#pragma once
/// How much of a Newton correction is taken where thread touches. A contact is there or not, sticks or slides, and its linear model holds
/// only until that changes: a wire that weighs nothing is flung through its neighbour by what the model says, out of it again by the next,
/// and so on without end. So a correction is taken as far as its own direction goes downhill: to where the forces along it, the contacts'
/// as they are, all others' as their linear models say, come to balance. Physics thread; no heap.
#include "sim/strand/strand.h"
#include "sim/strand/thread_contacts.h"

namespace halsted {

/// Shortens the correction in `w.rhs`, which answers the forces in `w.load`, and moves the hands by theirs. Returns the share taken, in (0, 1].
double takeCorrection(StrandWork& w, ThreadContactWork&);   // [1]

}  // namespace halsted
