#pragma once
/// Outcome and motion metrics, accumulated step by step (physics.md C1). `MetricsState` is part of `State`.
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "sim/join.h"
#include "sim/types.h"

namespace halsted {

struct HandMetrics {
  double pathLength = 0.0;                     // [m] sum |dx| of the tool tip
  double peakForce = 0.0;                      // [N]
  double forceSum = 0.0;                       // [N] over steps with force > 0.02 N
  double forceSteps = 0.0;                     // [1] count of those steps
  Vec3 lastPosition = Vec3::Zero();            // [m]
  bool started = false;
};

struct BiteMetrics {
  double depth = 0.0;                          // [m] entry to the rim
  double spacing = 0.0;                        // [m] from the previous exit
  double entryAngle = 0.0;                     // [1] cosine of the angle between needle tangent and inward normal at entry
  double width = 0.0;                          // [m] entry to exit
  double wallShare = 0.0;                      // [1] deepest point of the needle's way: 0 serosa, 1 mucosa
};

inline constexpr int kMaxBites = 24;

struct MetricsState {
  std::array<HandMetrics, kHands> hands;
  std::array<BiteMetrics, kMaxBites> bites{};
  std::int32_t biteCount = 0;                  // completed bites
  Vec3 lastExit = Vec3::Zero();                // [m] rest position of the last bite's exit
  std::int32_t acrossOpening = 0;              // bites not adjacent to the last
  std::int32_t tears = 0;
  double peakStretch = 1.0;                    // [1] largest edge length / rest length on the surface
  double peakTension = 0.0;                    // [N]
  double openingArea = 0.0;                    // [m^2] now
  double restOpeningArea = 0.0;                // [m^2] at the first step
  JoinMetrics join;                            // of two ends that are being joined
  std::int32_t fullThickness = 0;              // bites that went through the mucosa
  double deepestTip = 0.0;                     // [1] share of the wall that the needle's tip has reached since the last bite
  std::int32_t threadCuts = 0;                 // with blades, not torn
  std::int32_t lastBowel = 0;                  // of the last bite
};

/// Name (with its unit as a suffix) and value, for `replay --json` and reports; read on any thread that owns a copy.  time [s]
std::vector<std::pair<std::string, double>> summarise(const MetricsState&, double time);

}  // namespace halsted
