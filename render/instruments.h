#pragma once
/// Shapes of the surgeon's instruments in the tool frame (ToolSample): origin between the jaw tips, +z to the hand, jaws open
/// along +-x. An instrument is two mirrored halves that turn about an axis parallel to y.
#include <array>

#include "render/shape.h"
#include "sim/exchange.h"

namespace halsted::render {

struct Instrument {
  std::array<Shape, 2> halves;               // the jaw on +x, the jaw on -x
  double hinge = 0.0;                        // [m] z of the axis
  double openAngle = 0.0;                    // [rad] turn of each half when fully open
};

Instrument makeInstrument(ToolKind);
/// Where a half stands for an opening of 0 to 1.
Pose halfPose(const Instrument&, int half, double jaw, const Pose& tool);   // jaw [1]

/// A rod with rounded ends and two grooves, as the shaft of a stapler's anvil.
void addRod(Shape&, const CapsuleShape&);

}  // namespace halsted::render
