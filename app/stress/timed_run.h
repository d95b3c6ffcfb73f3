#pragma once
/// Steps with hands that hold still, timed or not.
#include <algorithm>

#include "app/scenario.h"
#include "app/stress/series.h"
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
  /// Times the steps that follow.
  StressPoint look(int stitches, int steps) {
    StressPoint p;
    p.stitches = stitches;
    Durations durations;
    for (int k = 0; k < steps; ++k) {
      const haptics::Nanoseconds start = haptics::monotonicNow();
      step(model, input, state, output);
      durations.add(static_cast<double>(haptics::monotonicNow() - start) * 1e-9);
      p.iterations += static_cast<double>(state.work.strand.iterations) / steps;
      p.threadSpeed += fastest() / steps;
    }
    const Percentiles step = durations.percentiles(1e3);
    p.stepMedian = step.p50;
    p.step99 = step.p99;
    return p;
  }

 private:
  double fastest() const {                     // [m/s]
    double most = 0.0;                         // [m/s]
    for (const Vec3& v : state.strand.velocity) most = std::max(most, v.norm());
    return most;
  }
};

inline constexpr int kSettle = 400;            // steps

}  // namespace halsted::app
