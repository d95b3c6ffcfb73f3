#pragma once
/// Jaws close with a finite force and rest on the thread that lies between them: they are blocked, they do not crush it. Physics thread.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

/// The opening [1] at which jaws come to rest that are to be `wanted` open: that, or what lies between them allows. Only with `thread.knots`;
/// jaws that hold the needle rest on it and let thread pass (sim/suture/knotting.cpp).
double restingJaw(const Model&, int hand, const State&, double wanted);   // [1]

}  // namespace halsted
