#pragma once
/// What a program reads of a device, in the units of the HD API, and how it follows from a reading. Pure; servo and client threads.
#include <cstddef>

#include "haptics/device.h"
#include "haptics/kinematics.h"

namespace halsted::haptics::hd {

/// One snapshot. Written by advanceState; the commands below `force` by the frame.
struct DeviceState {
  double position[3] = {};                     // [mm]
  double velocity[3] = {};                     // [mm/s] smoothed
  double transform[16] = {};                   // [1], [mm] in [12..14]; column-major
  double angularVelocity[3] = {};              // [rad/s] smoothed, device frame
  double jacobian[36] = {};                    // [mm/rad] upper, [1] lower three rows; row-major; over joints and gimbal
  double jointAngles[3] = {};                  // [rad]
  double gimbalAngles[3] = {};                 // [rad]
  long encoders[6] = {};                       // counts
  int buttons = 0;
  bool safetySwitch = true;
  bool inkwellSwitch = true;                   // false: the stylus is in the inkwell
  double force[3] = {};                        // [N] commanded
  double torque[3] = {};                       // [mN m] commanded
  double jointTorque[3] = {};                  // [mN m] commanded
  double gimbalTorque[3] = {};                 // [mN m] commanded
  long motors[6] = {};                         // DAC values
};

/// What the smoothing remembers between two readings.
struct MotionFilter {
  Vec3 position = Vec3::Zero();                // [m] last
  Quat orientation = Quat::Identity();         // last
  Vec3 velocity = Vec3::Zero();                // [m/s]
  Vec3 turnRate = Vec3::Zero();                // [rad/s]
  bool started = false;
};

/// What the reading of a device does not say.
struct StylusState {
  int buttons = 0;
  bool docked = false;                         // in the inkwell
  TouchJoints encoderError = Vec3::Zero();     // [rad] of a device that has not been calibrated
};

/// Replaces the measured part of `state`; `dt` [s] since the last reading.
void advanceState(const Pose& reading, const StylusState&, double dt, MotionFilter&, DeviceState& state) noexcept;

/// Joint angles of the arm stretched toward `position` when it is out of reach.
TouchJoints jointsTowards(const Vec3& position) noexcept;  // [m]
/// The nearest point that the arm reaches with something to spare, inside the mechanical workspace.
Vec3 withinReach(const Vec3& position) noexcept;           // [m]

/// The pose as a column-major 4x4 with millimetres.
void writeTransform(const Vec3& position, const Quat& orientation, double* transform) noexcept;  // [m] -> [mm]

}  // namespace halsted::haptics::hd
