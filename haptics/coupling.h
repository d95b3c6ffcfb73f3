#pragma once
/// From a local contact model to the force of this instant. Pure functions, haptic thread, noexcept, bounded.
/// physics.md B7: the haptic thread never sees particles, only the first-order model of what the tool feels.
#include "haptics/device.h"
#include "sim/exchange.h"

namespace halsted::haptics {

/// What one hand's device can be asked to show; a model beyond it is scaled down, never refused.
struct CouplingCaps {
  double stiffness = 2000.0;                   // [N/m] twice the weakest axis of the Touch; 0 in a loop's configuration: twice its device's
  double damping = 5.0;                        // [N s/m] with the velocity filter 45 g would ring from some 10 on
  double force = 10.0;                         // [N] three times the peak: keeps the blend from remembering what no motor showed
};

/// The caps of a loop on this device: its nominal stiffness and nothing of the scene says how stiff the hand may be shown the world.
/// Twice the nominal is quiet with every grip up to 2 ms of delay (haptics/README.md). `scale` magnifies motion, and with it what is felt.
CouplingCaps couplingCaps(const CouplingCaps& configured, const DeviceLimits&, double scale) noexcept;  // [1]

/// Every number finite, normals of unit length, plane count in range. What is not usable gives zero force and a fault.
bool usable(const LocalContact&) noexcept;

/// F = force - stiffness (x - x0) - damping v, within the caps, without adhesion.
/// A model that is not touching gives zero, but for one whose planes were published `ahead` of the contact: beyond one the force is
/// the stiffness along its normal times the depth. So the first millisecond of a fast touch is already felt, and the blend has
/// nothing to hide.
/// Finite for every usable model of a size that a scene can have; what overflows must be caught by the caller.
Vec3 modelForce(const LocalContact&, const Vec3& x, const Vec3& v, const CouplingCaps&) noexcept;     // [m] [m/s] -> [N]

/// Takes out what would pull along the normal of a plane that pushed when the model was made, unless another plane pushes that way.
/// A model without planes may pull: needle, thread, grasp. Where `last` pulled already, the force leaves it by `step` only: a needle
/// that lets go while the shaft rests on tissue must not jump.
Vec3 withoutAdhesion(const LocalContact&, const Vec3& force, const Vec3& last, double step) noexcept;  // [N] [N] [N]

/// The force of the last tick, moved on by what motion changes in the model (`drift`): the pushes follow it, a pull stays as it was.
/// As `last` of withoutAdhesion it lets a force that still holds a trace of a pull fall as fast as the tool leaves.
Vec3 carriedOn(const LocalContact&, const Vec3& last, const Vec3& drift) noexcept;                    // [N] [N]

/// One tick of decay of the blend offset: exponential for small ones, never more than `step` at once.
Vec3 decayedOffset(const Vec3& offset, double step, double share) noexcept;                           // [N] [N] [1]

/// Share of the force that a model of this age may still show: 1 until `fadeAfter`, then linear to 0 over `fadeOver`.
double freshness(double age, double fadeAfter, double fadeOver) noexcept;                             // [s] [s] [s] -> [1]

}  // namespace halsted::haptics
