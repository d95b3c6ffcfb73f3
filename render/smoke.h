#pragma once
/// Smoke over an electrocautery pen that is switched on where tissue is charred: soft discs that rise from the electrode, swell and thin out. It is of the
/// picture alone. Where they are follows from the time and the pen's place, so that a frame is the same whatever was drawn before it.
#include <array>

#include "sim/exchange.h"

namespace halsted::render {

class Discs;

struct Puff {
  Vec3 centre = Vec3::Zero();                // [m]
  double radius = 0.0, strength = 0.0;       // [m], [1] how much of what is behind its middle it hides
};

inline constexpr int kPuffs = 16;            // of one pen

/// `up` is a unit vector against gravity.
std::array<Puff, kPuffs> plumeOver(const Vec3& electrode, const Vec3& up, double time);   // [m], [1], [s]

/// Of each pen that smokes, turned to the eye.
void laySmoke(const RenderSnapshot&, const Vec3& up, const CameraView&, Discs&);   // [1]

}  // namespace halsted::render
