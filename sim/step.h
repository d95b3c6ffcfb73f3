#pragma once
/// The physics step: a function of its arguments only (DESIGN 1). Physics thread; no heap, clock, lock or file inside.
#include <array>

#include "sim/exchange.h"
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

struct StepInput {
  std::array<ToolSample, kHands> tools;
  double lumenPressure = 0.0;                  // [Pa] on the lumen's wall; only a leak test raises it (sim/outcome.h)
  Command command;
};

struct StepOutput {
  static constexpr int kMaxEvents = 32;
  std::array<LocalContact, kHands> contact;
  std::array<Event, kMaxEvents> events{};
  int eventCount = 0;
  int droppedEvents = 0;
  Observation seen{};
};

void step(const Model&, const StepInput&, State&, StepOutput&);

/// The state at rest, before the first step; tools at `start`.
State initialState(const Model&, const std::array<Pose, kHands>& start);

/// Sizes the vectors of a snapshot once, then fills it without allocating.
void prepareSnapshot(const Model&, RenderSnapshot&);
void fillSnapshot(const Model&, const State&, RenderSnapshot&);

}  // namespace halsted
