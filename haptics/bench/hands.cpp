#include "haptics/bench/hands.h"

namespace halsted::haptics::bench {

namespace {

HandDynamics grip(double mass, double damping, double stiffness) {   // [kg] [N s/m] [N/m]
  HandDynamics hand;
  hand.mass = mass;
  hand.damping = damping;
  hand.stiffness = stiffness;
  hand.visualGain = stiffness / 57e-3;         // the eye is as slow for every grip
  hand.visualForce = 0.6;                      // [N] so that 2 mm into a wall stays below the peak of the Touch
  return hand;
}

}  // namespace

std::array<NamedHand, 3> threeHands() {
  return {{{"light grip", grip(3.5e-3, 4.0, 255.0)}, {"normal grip", grip(6e-3, 5.7, 600.0)}, {"tight grip", grip(8.7e-3, 7.4, 1255.0)}}};
}

}  // namespace halsted::haptics::bench
