#pragma once
/// Three hands that hold the stylus, as spring, damper and mass about where they aim.
#include <array>

#include "haptics/virtual_device.h"

namespace halsted::haptics::bench {

struct NamedHand {
  const char* name;
  HandDynamics dynamics;
};

/// Light, normal and tight grip. Stiffness and damping rise steadily with the force of the grip while the mass hardly changes
/// (Hasser & Cutkosky 2002, pinch grasp of a knob; Fu & Cavusoglu 2012, stylus gripped with 1 to 3 N). The numbers are the low end,
/// the middle and the high end of Hajian & Howe 1997 for a fingertip: 3.5 to 8.7 g, 4.0 to 7.4 N s/m, 255 to 1255 N/m. One finger
/// stands for the whole grip, which is the careful side: a hand's damping is what keeps a wall quiet.
std::array<NamedHand, 3> threeHands();

}  // namespace halsted::haptics::bench
