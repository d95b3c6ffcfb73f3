#pragma once
/// How a scripted hand moves: a commanded tool pose that travels at a bounded speed, and an eye that corrects for what force has
/// pushed aside.
#include "sim/exchange.h"

namespace halsted::scenes {

struct HandMotion {
  Pose command;                                // where the tool should be now
  Vec3 correction = Vec3::Zero();              // [m] added to the target by looking
  double jaw = 1.0;                            // [1]
};

/// Moves the command toward `goal`; true once it is there.  speed [m/s], turn [rad/s], dt [s]
bool travel(HandMotion&, const Pose& goal, double speed, double turn, double dt);

/// Integrates the difference between command and the tool seen; returns the target for the hand.
HandTarget look(HandMotion&, const Pose& seen, double dt);   // dt [s]

/// A force as a hand feels it: its mean over about `time`. What catches and slips would pull the hand to and fro.  [N] [s]
inline void feel(double& felt, double force, double dt, double time) { felt += dt / time * (force - felt); }

}  // namespace halsted::scenes
