#pragma once
/// What the head-up display shows beside the snapshot. All fields may stay at their defaults.
#include <array>
#include <string>

#include "sim/exchange.h"

namespace halsted::render {

struct HudInput {
  bool visible = true;
  bool live = false;                         // a real-time session: show rates and lateness. Off in capture: they differ per run
  HapticStatus haptic;
  PhysicsStatus physics;
  double hapticRate = 0.0;                   // [Hz]
  double hapticLateness = 0.0;               // [us] 99th percentile
  double framesPerSecond = 0.0;              // [Hz]
  bool stale = false;                        // physics stalled: forces are faded out
  bool late = false;                         // physics cannot keep up with the clock
  bool otherView = false;                    // a layered body: cut open where the scene opens whole, and the reverse
  std::string message;                       // one line, e.g. the last fault or event; empty = none
};

}  // namespace halsted::render
