#include "haptics/hd/force_path.h"

#include <algorithm>
#include <cmath>

namespace halsted::haptics::hd {

namespace {

TouchJoints anglesOf(const double* angles) noexcept { return {angles[0], angles[1], angles[2]}; }  // [rad]

/// F = J^-T tau; NaN near a singular arm, so that the limits cut it.
Vec3 forceOfTorque(const double* jointAngles, const Vec3& torque) noexcept {  // [rad] [N m]
  if (torque == Vec3::Zero()) return torque;
  const Mat3 transposed = touchJacobian(anglesOf(jointAngles)).transpose();
  const double determinant = transposed.determinant();  // [m^3]
  if (!(std::abs(determinant) > 1e-6)) return Vec3::Constant(std::nan(""));
  return transposed.inverse() * torque;
}

std::uint32_t cutWhen(bool exceeded, std::uint32_t error, std::uint32_t& errors) noexcept {
  if (!exceeded) return kFaultNone;
  errors |= error;
  return kFaultVelocity;  // any bit that cuts: zero now, held, then ramped in
}

LimitConfig limitConfig(const ForceContext& context) noexcept {
  LimitConfig config;
  config.rate = 1e9;  // [N/s] the impulse limit of the API cuts instead of shaping
  const bool ramps = (context.capabilities & kForceRamping) != 0;
  config.ramp = ramps ? context.device.peakForce / context.safety.rampRate : 1e-9;
  if (!ramps) config.holdAfterFault = 0.0;
  return config;
}

}  // namespace

Vec3 commandedForce(const DeviceState& state, CommandKind kind) noexcept {
  if (kind == kCommandMotors) {
    Vec3 torque;
    for (int i = 0; i < 3; ++i) torque[i] = static_cast<double>(state.motors[i]) / -kMotorLeast * kMotorTorque[i];
    return forceOfTorque(state.jointAngles, torque);
  }
  if (kind == kCommandNone) return Vec3::Zero();
  const Vec3 torque = Vec3(state.jointTorque[0], state.jointTorque[1], state.jointTorque[2]) * 1e-3;
  return Vec3(state.force[0], state.force[1], state.force[2]) + forceOfTorque(state.jointAngles, torque);
}

Vec3 shapeForce(const Vec3& wanted, const double* velocity, const ForceContext& context, ForcePathState& state,
                std::uint32_t& errors) noexcept {  // [N] [mm/s]
  const std::uint32_t on = context.capabilities;
  std::uint32_t faults = cutWhen(!allFinite(wanted), kErrorForce, errors);
  Vec3 force = allFinite(wanted) ? wanted : Vec3(Vec3::Zero());

  if (on & kForceClamping) force = clampLength(force, context.device.peakForce);
  const bool tooMuch = force != clampLength(force, context.device.peakForce);
  faults |= cutWhen((on & kForceLimit) && tooMuch, kErrorMaxForce, errors);

  const double milliseconds = std::max(1.0, context.dt * 1e3);  // [ms] a short period is no excuse for a jump, a long one is
  const double jump = std::sqrt((force - state.lastWanted).squaredNorm()) / milliseconds;  // [N/ms]
  faults |= cutWhen((on & kImpulseLimit) && jump > context.safety.impulse * (1.0 + 1e-9), kErrorImpulse, errors);

  const double speed = std::sqrt(velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2]);  // [mm/s]
  faults |= cutWhen((on & kVelocityLimit) && speed > context.safety.velocity, kErrorVelocity, errors);

  state.lastWanted = force;
  const Vec3 sent = limitForce(force, context.device, limitConfig(context), context.dt, state.limits, faults);
  const bool warm = state.limits.heat >= 0.999;
  if (warm && !state.warm) errors |= kErrorWarm;
  state.warm = warm;
  return sent;
}

void storeMotors(const double* jointAngles, const Vec3& force, long* motors) noexcept {
  const Vec3 torque = touchTorque(anglesOf(jointAngles), force);
  for (int i = 0; i < 3; ++i)
    motors[i] = std::clamp(std::lround(torque[i] / kMotorTorque[i] * -static_cast<double>(kMotorLeast)), kMotorLeast, kMotorMost);
}

}  // namespace halsted::haptics::hd
