#pragma once
/// Kinematics of the Novint Falcon: three legs, each a driven arm and a parallelogram, carry a grip that only translates.
/// Stamper 1997 (PhD 97-4, University of Maryland), with the second offset of the Falcon's legs. Pure, bounded, no heap; uses libm.
///
/// Two frames. The legs' own: z out of the front plate, origin in the plane of the leg axes. The device frame of every driver: x
/// right, y up, z toward the user, origin at the middle of the workspace. They differ by 0.11 m along z and by nothing else; public
/// drivers use the axes so, and no Falcon was at hand to check it.
#include <optional>

#include "sim/types.h"

namespace halsted::haptics {

/// Public measurements of the mechanism.
struct FalconLinks {
  double arm = 0.060;                          // [m] a: leg axis to knee
  double shin = 0.1025;                        // [m] b: side of the parallelogram
  double gripU = 0.01443;                      // [m] c: shin to grip centre, radially
  double knee = 0.0225;                        // [m] d + e: the two short links beside the parallelogram
  double gripV = -0.025;                       // [m] f: shin to grip centre, along the axis of the leg
  double baseU = 0.0400;                       // [m] r: origin to leg axis, radially
  double baseV = -0.02309;                     // [m] s: origin to leg axis, along it
  double middle = 0.110;                       // [m] of the workspace before the plane of the legs
};

using FalconLegs = Vec3;                       // [rad] angle of each arm from the plate

inline constexpr double kFalconLegStep = 0.6359e-3;     // [rad] one encoder count, about; the exact value is in the .cpp

double falconLegAngle(int counts) noexcept;                                                 // [rad]
int falconLegCounts(double angle) noexcept;                                                 // [rad] nearest count

/// Leg angles that put the grip at `position`, or nothing where no leg reaches. Closed form.
std::optional<FalconLegs> falconLegs(const Vec3& position, const FalconLinks& = {}) noexcept;              // [m]
/// d legs / d position at a reachable position.
std::optional<Mat3> falconLegRates(const Vec3& position, const FalconLinks& = {}) noexcept;                // [m] -> [rad/m]
/// Grip position of these leg angles, by Newton's method from `near`; nothing when it does not settle to 1e-9 rad in 24 turns.
std::optional<Vec3> falconPosition(const FalconLegs&, const Vec3& near, const FalconLinks& = {}) noexcept;  // [m]
/// Motor torques that hold `force` at the grip: (d position / d legs)^T F.
std::optional<Vec3> falconTorque(const Vec3& position, const Vec3& force, const FalconLinks& = {}) noexcept;  // [m] [N] -> [N m]

}  // namespace halsted::haptics
