#pragma once
/// One press and release of a surface at y = 0 by a simulated hand on the virtual Touch, and what is measured of it.
#include <algorithm>

#include "haptics/bench/hands.h"
#include "haptics/bench/rig.h"

namespace halsted::haptics::bench {

struct PressPlan {
  HandDynamics hand;
  TouchDynamics touch;
  HandLoopConfig config;
  double depth = 2e-3;                         // [m] aimed at, below the surface
  double speed = 0.05;                         // [m/s]
  double hold = 3.0;                           // [s] the last second of it is what is judged
  double modelDelay = 0.0, forceDelay = 0.0;   // [s] age of the model beyond one step; of the force on its way to the motors
  int every = 1;                               // ticks per step of the environment
};

struct PressOutcome {
  double buzz = 0.0;                           // [N] RMS above 30 Hz
  double wander = 0.0;                         // [m] peak to peak of the tip
  double steady = 0.0;                         // [N] mean force
  double depth = 0.0;                          // [m] mean depth of the tip
  double leastEnergy = 0.0;                    // [J] the least that the surface had taken, over press and release
  double energyTaken = 0.0;                    // [J] at the end of the cycle
  double largestStep = 0.0;                    // [N] of the force in one tick
  double replaced = 0.0;                       // [N] largest change of a force by the model that was replaced in that tick
  double peak = 0.0;                           // [N]
};

/// Quiet: no buzz that a finger feels, and no swing wider than two counts of the encoder.
bool quiet(const PressOutcome&);

/// Collects what a press shows, tick by tick.
class PressJudge {
 public:
  PressJudge(const PressPlan&, Rig&);
  void approach();
  void beginRelease();
  int ticks(double seconds) const;             // [s]
  void seen(bool judged);                      // after each tick of the hold
  PressOutcome outcome() const;

 private:
  const PressPlan& plan_;
  Rig& rig_;
  std::vector<double> forces_;                 // [N] of the hold
  double low_ = 1.0, high_ = -1.0, depths_ = 0.0, sum_ = 0.0;   // [m] [m] [m] [N]
  int judged_ = 0;
};

Rig pressRig(const PressPlan&);

/// The tick, the environment, and what the same tick would have shown had its model not been replaced.
template <typename Environment>
double advanceWithTwin(Rig& rig, Environment& environment, LocalContact& used) {
  Rig twin = rig;
  twin.contact = used;
  used = rig.contact;
  twin.tickOnly();
  rig.advance(environment);
  return used.puncture ? 0.0 : (twin.output.force - rig.output.force).norm();
}

template <typename Environment>
PressOutcome press(Environment environment, const PressPlan& plan) {
  Rig rig = pressRig(plan);
  PressJudge judge(plan, rig);
  LocalContact used;
  double replaced = 0.0;                       // [N]
  const auto advance = [&](double seconds, bool hold) {   // [s]
    for (int i = 0, n = judge.ticks(seconds), last = judge.ticks(seconds - 1.0); i < n; ++i) {
      replaced = std::max(replaced, advanceWithTwin(rig, environment, used));
      if (hold) judge.seen(i >= last);
    }
  };
  advance(0.2, false);                         // the engagement ramp is over before the touch
  judge.approach();
  advance(plan.hold, true);
  judge.beginRelease();
  advance(1.0, false);
  PressOutcome outcome = judge.outcome();
  outcome.replaced = replaced;
  return outcome;
}

}  // namespace halsted::haptics::bench
