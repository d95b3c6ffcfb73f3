#pragma once
/// From what a frame commanded to what the motors get: sum, safety, limits (haptics/limits.h). Pure on its own state; no heap or lock.
#include <cstdint>

#include "haptics/hd/device_state.h"
#include "haptics/limits.h"

namespace halsted::haptics::hd {

/// Capabilities as bits; the defaults are those of a device that has just been opened.
enum Capability : std::uint32_t {
  kForceOutput = 1u << 0,
  kForceClamping = 1u << 1,
  kForceRamping = 1u << 2,
  kForceLimit = 1u << 3,
  kOneFrameLimit = 1u << 4,
  kVelocityLimit = 1u << 5,
  kImpulseLimit = 1u << 6,
  kStatusLight = 1u << 7,
  kCapabilityDefaults = kForceClamping | kForceRamping | kForceLimit | kOneFrameLimit | kVelocityLimit | kImpulseLimit,
};

struct SafetyLimits {
  double velocity = 1500.0;                    // [mm/s] no hand at work is near it
  double impulse = 3.3;                        // [N/ms] peak force may come at once, but not change its sign
  double rampRate = 33.0;                      // [N/s] peak force 0.1 s after the start
};

/// What a program set in this frame.
enum CommandKind : std::uint8_t { kCommandNone = 0, kCommandForce = 1, kCommandMotors = 2 };

struct ForcePathState {
  LimitState limits;
  Vec3 lastWanted = Vec3::Zero();              // [N] clamped
  bool warm = false;                           // WARM_MOTORS was said
};

/// Errors of the API that a frame raised; bits, in the order in which they are pushed.
enum ForceError : std::uint32_t {
  kErrorForce = 1u << 0,
  kErrorMaxForce = 1u << 1,
  kErrorImpulse = 1u << 2,
  kErrorVelocity = 1u << 3,
  kErrorWarm = 1u << 4,
};

/// Full scale of the motors: what 3.3 N need at the origin, J^T F on each axis alone.
inline constexpr double kMotorTorque[3] = {0.556, 0.324, 0.374};  // [N m]
inline constexpr long kMotorLeast = -32767, kMotorMost = 32766;

/// Cartesian force that a frame asks for: force plus the force that its joint torques make at the wrist, or that of its DAC values.
/// NaN where the arm cannot turn torque into force (stretched out).
Vec3 commandedForce(const DeviceState&, CommandKind) noexcept;                    // [N]

/// What a program allows, and when.
struct ForceContext {
  std::uint32_t capabilities = kCapabilityDefaults;
  SafetyLimits safety;
  DeviceLimits device;
  double dt = 1e-3;                            // [s] since the last frame
};

/// `velocity` [mm/s] of the device. Returns the force for the device [N]; sets bits in `errors`.
Vec3 shapeForce(const Vec3& wanted, const double* velocity, const ForceContext&, ForcePathState&, std::uint32_t& errors) noexcept;

/// Torque on the three motors as DAC values, for LAST_MOTOR_DAC_VALUES.
void storeMotors(const double* jointAngles, const Vec3& force, long* motors) noexcept;  // [rad] [N]

}  // namespace halsted::haptics::hd
