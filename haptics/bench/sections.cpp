#include "haptics/bench/bench.h"

namespace halsted::haptics::bench {

std::vector<Section> sections() {
  constexpr int kCrossings = 10000;
  return {{"1 Z-width", measureZWidth},
          {"1 nominal wall", measureNominalWall},
          {"2 energy of a press", measurePressEnergy},
          {"3 continuity", measureContinuity},
          {"4 held contact", measureHeldContact},
          {"5 pop-through", [] { return measurePopThrough(kCrossings); }},
          {"6 rate invariance", measureRateInvariance},
          {"7 latency", measureLatency},
          {"9 accuracy", measureAccuracy},
          {"9 friction", measureContactFriction},
          {"10 faults", measureFaults},
          {"10 thermal", measureThermal},
          {"coupling limits", measureCouplingLimits}};
}

}  // namespace halsted::haptics::bench
