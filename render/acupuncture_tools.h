#pragma once
/// The filiform needle with its wound handle, and the tip of the finger that presses beside it.
#include "render/shape.h"
#include "render/tube.h"
#include "sim/exchange.h"

namespace halsted::render {

/// Along +z of the tool frame, the tip at the origin.
Tube makeShaft(const StraightNeedle&);
Tube makeHandle(const StraightNeedle&);
/// The eye at the end of the handle: a loop of wire in a plane through the axis, which shows a turn.
Shape makeHandleLoop(const StraightNeedle&);

constexpr double kFingerLength = 9.0;                    // [1] radii that are drawn
/// An index finger along +z, the middle of its last joint's ball at the origin, the pad toward -y; `radius` is half its width.  [m]
Shape makeFinger(double radius);
/// Skin that a finger presses: where it touches, the way out, and the side that the hand comes from.
struct FingerTouch { Vec3 place, normal, from; };        // [m] [1] [1]
Pose fingerPose(const FingerTouch&, double radius);      // [m]

}  // namespace halsted::render
