#pragma once
/// Kinematics of the Touch (and of the Omni before it): three joints carry the wrist, three gimbal angles turn the stylus.
/// Device frame: x right, y up, z toward the user, origin at the middle of the workspace. Pure; uses libm, so it serves drivers,
/// the API shim and panels, never the loop of the virtual device.
/// The lengths reproduce a docked stylus recorded from a device to 1e-4 mm; the turret's part in the orientation is by convention
/// (that recording has the turret at zero).
#include <optional>

#include "sim/types.h"

namespace halsted::haptics {

struct TouchLinks {
  double upperArm = 0.13335;                   // [m] shoulder to elbow
  double forearm = 0.13335;                    // [m] elbow to gimbal centre
  double height = 0.02335;                     // [m] shoulder above the origin
  double depth = 0.16835;                      // [m] shoulder behind the origin
};

/// Turret (left positive), thigh (up positive) and shin (up positive). The shin's angle is absolute, not relative to the thigh.
using TouchJoints = Vec3;                      // [rad]
/// Stylus from neutral: right positive, up negative, clockwise positive.
using TouchGimbal = Vec3;                      // [rad]

Vec3 touchPosition(const TouchJoints&, const TouchLinks& = {}) noexcept;                 // [m]
Mat3 touchJacobian(const TouchJoints&, const TouchLinks& = {}) noexcept;                 // [m/rad] d position / d joints
/// Torques that hold `force` at the gimbal centre: J^T F.
Vec3 touchTorque(const TouchJoints&, const Vec3& force, const TouchLinks& = {}) noexcept;  // [N] -> [N m]
Quat touchOrientation(const TouchJoints&, const TouchGimbal&) noexcept;

/// Elbow up, in front of the turret. Nothing when the arm does not reach `position`, or when it is not finite.
std::optional<TouchJoints> touchJoints(const Vec3& position, const TouchLinks& = {}) noexcept;  // [m]
/// Of the two sets that turn the stylus the same way, the one with the stylus less than a right angle up or down.
TouchGimbal touchGimbal(const TouchJoints&, const Quat& orientation) noexcept;

}  // namespace halsted::haptics
