#pragma once
/// One press and release of a surface by a simulated hand, and what can be measured of it.
#include <algorithm>
#include <vector>

#include "tests/haptics/bench_rig.h"

namespace halsted::haptics {

struct NamedHand {
  const char* name;
  HandDynamics dynamics;
};

/// A hand without stiffness: it pushes with a force that looking builds up, 0.6 N, and with `damping`.
inline HandDynamics pushingHand(double damping) {  // [N s/m]
  HandDynamics hand;
  hand.stiffness = 0.0;
  hand.damping = damping;
  hand.visualGain = 1000.0;
  hand.visualForce = 0.6;
  return hand;
}

inline HandDynamics stiffHand() {
  HandDynamics hand;
  hand.stiffness = 1000.0;
  hand.damping = 13.4;  // critical with 45 g
  return hand;
}

/// The three hands of the stability measure, most dangerous last: damping only, pen grip, stiff grip.
inline std::vector<NamedHand> threeHands() {
  return {{"10 N s/m", pushingHand(10.0)}, {"400 N/m", HandDynamics{}}, {"1000 N/m", stiffHand()}};
}

struct Press {
  HandDynamics hand;
  double period = 1e-3;                        // [s]
  double depth = 2e-3;                         // [m] aimed at, below the surface
  double speed = 0.05;                         // [m/s]
  double hold = 3.0;                           // [s]
  int delay = 0, every = 1;                    // steps of the environment, ticks a step
  double friction = 0.26;                      // [N] of the device
  double stiffnessCap = 1e9;                   // [N/m] off, so that the wall itself is what is measured
};

struct PressResult {
  double buzz = 0.0;                           // [N] RMS above 30 Hz in the last second of the hold
  double wander = 0.0;                         // [m] peak to peak in that second
  double steady = 0.0;                         // [N] force at the end of the hold
  double energyTaken = 0.0;                    // [J] over the closed cycle
  double leastEnergy = 0.0;                    // [J] at any moment of it
  double mostAdhesive = 0.0;                   // [N] most negative force along the normal
  double peak = 0.0;                           // [N]
};

template <typename Environment>
PressResult pressAndRelease(Environment environment, const Press& press) {
  Pose start;
  start.position.y() = 10e-3;
  TouchDynamics touch;
  touch.friction = press.friction;
  HandDynamics hand = press.hand;
  hand.maxSpeed = press.speed;
  Rig rig(touch, hand, start);
  rig.config.period = press.period;
  rig.config.caps.stiffness = press.stiffnessCap;
  rig.delay = press.delay;
  rig.every = press.every;
  const auto ticks = [&](double seconds) { return static_cast<int>(seconds / press.period + 0.5); };  // [s]

  for (int i = 0; i < ticks(0.2); ++i) rig.advance(environment);  // the engagement ramp is over before the touch
  PressResult result;
  double low = 1.0, high = -1.0;  // [m]
  std::vector<double> forces;     // [N]
  rig.target.pose.position.y() = -press.depth;
  for (int i = 0, n = ticks(press.hold), last = ticks(press.hold - 1.0); i < n; ++i) {
    rig.advance(environment);
    forces.push_back(rig.output.force.y());
    result.mostAdhesive = std::min(result.mostAdhesive, rig.output.force.y());
    if (i < last) continue;
    low = std::min(low, rig.device.position().y());
    high = std::max(high, rig.device.position().y());
  }
  rig.target.pose.position.y() = start.position.y();
  for (int i = 0; i < ticks(1.0); ++i) {
    rig.advance(environment);
    result.mostAdhesive = std::min(result.mostAdhesive, rig.output.force.y());
  }
  result.buzz = rmsAbove30Hz(forces, 1.0 / press.period, forces.size() - static_cast<std::size_t>(ticks(1.0)));
  result.wander = high - low;
  result.steady = forces.back();
  result.energyTaken = rig.energyTaken;
  result.leastEnergy = rig.leastEnergy;
  result.peak = rig.peak;
  return result;
}

}  // namespace halsted::haptics
