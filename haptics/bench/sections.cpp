#include "haptics/bench/bench.h"

namespace halsted::haptics::bench {

namespace {

constexpr int kThrows = 10000;                 // devices.md 5

std::function<Measurements(const Heard&)> silent(Measurements (*measure)()) {
  return [measure](const Heard&) { return measure(); };
}

}  // namespace

std::vector<Section> sections() {
  return {{"1 Z-width", measureZWidth},
          {"1 nominal wall", silent(measureNominalWall)},
          {"1 coupling limits", silent(measureCouplingLimits)},
          {"2 energy of a press", silent(measurePressEnergy)},
          {"3 continuity", silent(measureContinuity)},
          {"4 held contact", silent(measureHeldContact)},
          {"5 pop-through", [](const Heard& heard) { return measurePopThrough(kThrows, heard); }},
          {"6 rate invariance", silent(measureRateInvariance)},
          {"7 latency", silent(measureLatency)},
          {"9 accuracy", silent(measureAccuracy)},
          {"9 friction", silent(measureContactFriction)},
          {"10 faults", silent(measureFaults)},
          {"10 thermal", silent(measureThermal)}};
}

}  // namespace halsted::haptics::bench
