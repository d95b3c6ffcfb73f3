#pragma once
/// What the haptic thread needs to render one hand's force by itself until the next step (physics.md B7).
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

/// `sample`: what the step was given for this hand. Nothing touched: the planes are where touching would begin, far enough ahead for
/// the hand's speed, so that the haptic tick feels a wall in the tick that reaches it.
void writeLocalContact(const Model&, const State&, int hand, const ToolSample& sample, LocalContact&);

}  // namespace halsted
