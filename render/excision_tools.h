#pragma once
/// Instruments of an excision in the tool frame: an Allis clamp and an electrocautery pen.
#include "render/shape.h"

namespace halsted::render {

inline constexpr double kAllisPin = 34e-3;   // [m] of the clamp's pin from its tips, drawn with jaws of 12 mm

/// One half: teeth that meet at the tip, a jaw bowed outward behind them, shank, ratchet arm and ring.
Shape allisHalf(double side);                // [1] +1 or -1: the side of the jaw

/// A blade as long as the simulated electrode, its sleeve, the pen with the buttons for cut and coagulation, and the beginning of the cable.
Shape cauteryPen(double blade);              // [m]

}  // namespace halsted::render
