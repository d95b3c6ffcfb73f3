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

/// With the jaws as long, thick and far apart as the simulated ones.
Instrument makeInstrument(ToolKind, const JawShape& = {});
/// Corners of the triangles that a half casts its shadow with: an operating lamp is wide, so the core of a shadow narrows with the
/// distance of what casts it, and an instrument thins toward the hand (as the shadow map draws it). [m], three a triangle
std::vector<Vec3> shadowTriangles(const Shape& half);
/// Where a half stands for an opening of 0 to 1.
Pose halfPose(const Instrument&, int half, double jaw, const Pose& tool);   // jaw [1]

/// A rod with rounded ends and two grooves, as the shaft of a stapler's anvil.
void addRod(Shape&, const CapsuleShape&);

}  // namespace halsted::render
