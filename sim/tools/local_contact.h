#pragma once
/// What the haptic thread needs to render one hand's force by itself until the next step (physics.md B7).
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

void writeLocalContact(const Model&, const State&, int hand, std::uint64_t sampleTick, LocalContact&);

}  // namespace halsted
