#pragma once
/// The blades behind the jaws of a needle driver (Olsen-Hegar): thread that lies across them as the jaws close is cut through. A cut is a
/// flag of the thread's segment; nothing is resized. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

/// First segment of thread that lies between the open blades of a hand's tool and would be cut if they closed; -1: none, or no blades.
int threadBetweenBlades(const Model&, int hand, const State&);

/// The jaws of a hand are closing. True when thread was between the blades and is cut.
bool cutThread(const Model&, int hand, State&, StepOutput&);

}  // namespace halsted
