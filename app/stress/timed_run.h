#pragma once
/// Steps with hands that hold still, timed or not.
#include "app/scenario.h"
#include "app/timing.h"
#include "haptics/realtime.h"
#include "sim/step.h"

namespace halsted::app {

struct TimedRun {
  const Model& model;
  State state;
  StepInput input;
  StepOutput output;

  TimedRun(const Model& m, const std::array<Pose, kHands>& hands) : model(m), state(initialState(m, hands)) {
    for (int hand = 0; hand < kHands; ++hand) {
      input.tools[hand].pose = hands[hand];
      input.tools[hand].jaw = state.tools[hand].jaw;
    }
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) step(model, input, state, output);
  }
  Percentiles time(int steps) {                // [ms]
    Durations durations;
    for (int k = 0; k < steps; ++k) {
      const haptics::Nanoseconds start = haptics::monotonicNow();
      step(model, input, state, output);
      durations.add(static_cast<double>(haptics::monotonicNow() - start) * 1e-9);
    }
    return durations.percentiles(1e3);
  }
};

inline constexpr int kSettle = 400;            // steps

}  // namespace halsted::app
