#pragma once
/// Time-domain passivity of one hand's loop (Hannaford & Ryu 2002; the reference energy after Ryu, Preusche, Hannaford & Hirzinger
/// 2005). Pure functions on one number, haptic thread, noexcept, bounded, no heap. They stand between coupling and limits, and give
/// zero where the loop has created nothing.
#include "sim/types.h"

namespace halsted::haptics {

struct PassivityConfig {
  double maxDamping = 4.0;                     // [N s/m] added at most; far below mass / period = 45 N s/m of the bare device
  double maxForce = 0.5;                       // [N] added at most
  double forceStep = 0.020;                    // [N] a tick: it comes and goes half as fast as a new model may, so that it is not felt as a click
  double minSpeed = 2e-3;                      // [m/s] below it quantisation, not motion, is what the velocity shows
  double storage = 50e-3;                      // [J] energy the environment may have taken and can give back: 3.3 N on 110 N/m
  double forget = 0.5;                         // [s] a deficit is forgotten: the other hand may rightly feed energy into this one
};

/// `energy` is what the environment took from the hand, exact for a held force: E += -F dx. Below zero it gave more than it took.
double observeEnergy(double energy, const Vec3& heldForce, const Vec3& moved, double dt, const PassivityConfig&) noexcept;  // [J] [N] [m] [s]

/// What a spring of this stiffness that pushes with `force` still holds: f^2 / 2 k along it. While the hand gives way the account must
/// cover that too: to wait until it is empty is to wait until the touch is nearly over, with a millimetre left to pay it back in.
double heldEnergy(const Mat3& stiffness, const Vec3& force) noexcept;                                 // [N/m] [N] -> [J]

/// Damping that pays a deficit back.
Vec3 passivityDamping(double energy, const Vec3& v, double dt, const PassivityConfig&) noexcept;      // [J] [m/s] [s] -> [N]

}  // namespace halsted::haptics
