#include "haptics/hd/parameters.h"

#include <algorithm>
#include <cmath>

namespace halsted::haptics::hd {

namespace {

constexpr double kMaxWorkspace[6] = {-210.0, -110.0, -85.0, 210.0, 205.0, 130.0};   // [mm] mechanical, from a device
constexpr double kUsableWorkspace[6] = {-80.0, -60.0, -35.0, 80.0, 60.0, 35.0};     // [mm] data sheet: 160 x 120 x 70
constexpr double kTabletopOffset = 110.0;                                          // [mm] from the kinematics at zero angles
constexpr double kNominalStiffness = 0.5;                                          // [N/mm] printed by a device
constexpr double kNominalDamping = 0.004;                                          // [N/(mm/s)] a public driver's value for it
constexpr double kNominalForce = 3.3, kNominalContinuousForce = 0.88;              // [N] printed by a device
constexpr double kFirmware = 1.0;                                                  // [1] there is none to number

HDerror reals(const double* values, int count, Value& out) noexcept {
  out.type = ValueType::kReal;
  out.count = count;
  std::copy_n(values, count, out.real);
  return HD_SUCCESS;
}

HDerror real(double value, Value& out) noexcept { return reals(&value, 1, out); }

HDerror whole(ValueType type, const long* values, int count, Value& out) noexcept {
  out.type = type;
  out.count = count;
  std::copy_n(values, count, out.whole);
  return HD_SUCCESS;
}

HDerror integer(long value, Value& out) noexcept { return whole(ValueType::kInteger, &value, 1, out); }
HDerror boolean(bool value, Value& out) noexcept {
  const long number = value ? 1 : 0;
  return whole(ValueType::kBoolean, &number, 1, out);
}

/// The snapshots. A LAST parameter is 0x200 above its CURRENT one, up to the gimbal angles.
HDerror readMeasured(HDenum name, const DeviceState& state, Value& out) noexcept {
  switch (name) {
    case HD_CURRENT_BUTTONS: return integer(state.buttons, out);
    case HD_CURRENT_SAFETY_SWITCH: return boolean(state.safetySwitch, out);
    case HD_CURRENT_INKWELL_SWITCH: return boolean(state.inkwellSwitch, out);
    case HD_CURRENT_ENCODER_VALUES: return whole(ValueType::kLong, state.encoders, 6, out);
    case HD_CURRENT_POSITION: return reals(state.position, 3, out);
    case HD_CURRENT_VELOCITY: return reals(state.velocity, 3, out);
    case HD_CURRENT_TRANSFORM: return reals(state.transform, 16, out);
    case HD_CURRENT_ANGULAR_VELOCITY: return reals(state.angularVelocity, 3, out);
    case HD_CURRENT_JACOBIAN: return reals(state.jacobian, 36, out);
    case HD_CURRENT_JOINT_ANGLES: return reals(state.jointAngles, 3, out);
    case HD_CURRENT_GIMBAL_ANGLES: return reals(state.gimbalAngles, 3, out);
    default: return HD_INVALID_ENUM;
  }
}

HDerror readCommanded(HDenum name, const OpenDevice::View& device, Value& out) noexcept {
  switch (name) {
    case HD_CURRENT_FORCE: return reals(device.current.force, 3, out);
    case HD_CURRENT_TORQUE: return reals(device.current.torque, 3, out);
    case HD_CURRENT_JOINT_TORQUE: return reals(device.current.jointTorque, 3, out);
    case HD_CURRENT_GIMBAL_TORQUE: return reals(device.current.gimbalTorque, 3, out);
    case HD_CURRENT_MOTOR_DAC_VALUES: return whole(ValueType::kLong, device.current.motors, 3, out);
    case HD_LAST_FORCE: return reals(device.last.force, 3, out);
    case HD_LAST_TORQUE: return reals(device.last.torque, 3, out);
    case HD_LAST_JOINT_TORQUE: return reals(device.last.jointTorque, 3, out);
    case HD_LAST_GIMBAL_TORQUE: return reals(device.last.gimbalTorque, 3, out);
    case HD_LAST_MOTOR_DAC_VALUES: return whole(ValueType::kLong, device.last.motors, 3, out);
    case HD_JOINT_ANGLE_REFERENCES:
      std::copy_n(device.current.gimbalAngles, 3, out.real + 3);
      reals(device.current.jointAngles, 3, out);
      out.count = 6;
      return HD_SUCCESS;
    default: return HD_INVALID_ENUM;
  }
}

HDerror readConstant(HDenum name, const OpenDevice::View& device, Value& out) noexcept {
  switch (name) {
    case HD_DEVICE_FIRMWARE_VERSION: return real(kFirmware, out);
    case HD_MAX_WORKSPACE_DIMENSIONS: return reals(kMaxWorkspace, 6, out);
    case HD_USABLE_WORKSPACE_DIMENSIONS: return reals(kUsableWorkspace, 6, out);
    case HD_TABLETOP_OFFSET: return real(kTabletopOffset, out);
    case HD_INPUT_DOF: return integer(6, out);
    case HD_OUTPUT_DOF: return integer(3, out);
    case HD_CALIBRATION_STYLE: return integer(device.calibrationStyle, out);
    case HD_NOMINAL_MAX_STIFFNESS: return real(kNominalStiffness, out);
    case HD_NOMINAL_MAX_FORCE: return real(kNominalForce, out);
    case HD_NOMINAL_MAX_CONTINUOUS_FORCE: return real(kNominalContinuousForce, out);
    case HD_NOMINAL_MAX_DAMPING: return real(kNominalDamping, out);
    case HD_NOMINAL_MAX_TORQUE_STIFFNESS:
    case HD_NOMINAL_MAX_TORQUE_DAMPING:
    case HD_NOMINAL_MAX_TORQUE_FORCE:
    case HD_NOMINAL_MAX_TORQUE_CONTINUOUS_FORCE: return real(0.0, out);  // no motor turns the stylus
    default: return HD_INVALID_ENUM;
  }
}

HDerror readLimit(HDenum name, const OpenDevice::View& device, Value& out) noexcept {
  switch (name) {
    case HD_MOTOR_TEMPERATURE: {
      const double heat[3] = {device.heat, device.heat, device.heat};
      return reals(heat, 3, out);
    }
    case HD_SOFTWARE_VELOCITY_LIMIT: return real(device.safety.velocity, out);
    case HD_SOFTWARE_FORCE_IMPULSE_LIMIT: return real(device.safety.impulse, out);
    case HD_FORCE_RAMPING_RATE: return real(device.safety.rampRate, out);
    case HD_USER_STATUS_LIGHT: return integer(device.statusLight, out);
    default: return HD_INVALID_ENUM;
  }
}

bool allFiniteIn(const Value& value) noexcept {
  return std::all_of(value.real, value.real + value.count, [](double x) { return std::isfinite(x); });
}

/// Forces add up to one command; DAC values are another one: a frame holds one of the two.
HDerror writeCommand(double* target, const Value& value, const OpenDevice::View& device) noexcept {
  if (!device.inFrame) return HD_FRAME_ERROR;
  if (device.command == kCommandMotors) return HD_FORCE_ERROR;
  device.command = kCommandForce;
  std::copy_n(value.real, 3, target);
  return HD_SUCCESS;
}

HDerror writeMotors(const Value& value, const OpenDevice::View& device) noexcept {
  if (!device.inFrame) return HD_FRAME_ERROR;
  if (device.command == kCommandForce) return HD_FORCE_ERROR;
  const bool inRange = std::all_of(value.whole, value.whole + 3, [](long x) { return x >= kMotorLeast && x <= kMotorMost; });
  if (!inRange) return HD_INVALID_VALUE;
  device.command = kCommandMotors;
  std::copy_n(value.whole, 3, device.current.motors);
  return HD_SUCCESS;
}

HDerror writeLimit(double& target, const Value& value) noexcept {
  if (!allFiniteIn(value) || !(value.real[0] > 0.0)) return HD_INVALID_VALUE;
  target = value.real[0];
  return HD_SUCCESS;
}

HDerror writeLight(const Value& value, const OpenDevice::View& device) noexcept {
  if (value.whole[0] < 0 || value.whole[0] > LED_MASK) return HD_INVALID_VALUE;
  device.statusLight = static_cast<int>(value.whole[0]);
  return HD_SUCCESS;
}

}  // namespace

HDerror readParameter(HDenum name, const OpenDevice::View& device, Value& out) noexcept {
  constexpr HDenum kLastOffset = HD_LAST_BUTTONS - HD_CURRENT_BUTTONS;
  if (readMeasured(name, device.current, out) == HD_SUCCESS) return HD_SUCCESS;
  const bool last = name >= HD_LAST_BUTTONS && name <= HD_LAST_GIMBAL_ANGLES;
  if (last && readMeasured(name - kLastOffset, device.last, out) == HD_SUCCESS) return HD_SUCCESS;
  if (readCommanded(name, device, out) == HD_SUCCESS) return HD_SUCCESS;
  if (readConstant(name, device, out) == HD_SUCCESS) return HD_SUCCESS;
  return readLimit(name, device, out);
}

HDerror settableParameter(HDenum name, Value& value) noexcept {
  switch (name) {
    case HD_CURRENT_FORCE:
    case HD_CURRENT_TORQUE:
    case HD_CURRENT_JOINT_TORQUE:
    case HD_CURRENT_GIMBAL_TORQUE: value.type = ValueType::kReal; value.count = 3; return HD_SUCCESS;
    case HD_CURRENT_MOTOR_DAC_VALUES: value.type = ValueType::kLong; value.count = 3; return HD_SUCCESS;
    case HD_SOFTWARE_VELOCITY_LIMIT:
    case HD_SOFTWARE_FORCE_IMPULSE_LIMIT:
    case HD_FORCE_RAMPING_RATE: value.type = ValueType::kReal; value.count = 1; return HD_SUCCESS;
    case HD_USER_STATUS_LIGHT: value.type = ValueType::kInteger; value.count = 1; return HD_SUCCESS;
    default: return HD_INVALID_ENUM;
  }
}

HDerror writeParameter(HDenum name, const Value& value, const OpenDevice::View& device) noexcept {
  switch (name) {
    case HD_CURRENT_FORCE: return writeCommand(device.current.force, value, device);
    case HD_CURRENT_TORQUE: return writeCommand(device.current.torque, value, device);
    case HD_CURRENT_JOINT_TORQUE: return writeCommand(device.current.jointTorque, value, device);
    case HD_CURRENT_GIMBAL_TORQUE: return writeCommand(device.current.gimbalTorque, value, device);
    case HD_CURRENT_MOTOR_DAC_VALUES: return writeMotors(value, device);
    case HD_SOFTWARE_VELOCITY_LIMIT: return writeLimit(device.safety.velocity, value);
    case HD_SOFTWARE_FORCE_IMPULSE_LIMIT: return writeLimit(device.safety.impulse, value);
    case HD_FORCE_RAMPING_RATE: return writeLimit(device.safety.rampRate, value);
    case HD_USER_STATUS_LIGHT: return writeLight(value, device);
    default: return HD_INVALID_ENUM;
  }
}

std::uint32_t capabilityBit(HDenum name) noexcept {
  switch (name) {
    case HD_FORCE_OUTPUT: return kForceOutput;
    case HD_MAX_FORCE_CLAMPING: return kForceClamping;
    case HD_FORCE_RAMPING: return kForceRamping;
    case HD_SOFTWARE_FORCE_LIMIT: return kForceLimit;
    case HD_ONE_FRAME_LIMIT: return kOneFrameLimit;
    case HD_SOFTWARE_VELOCITY_LIMIT: return kVelocityLimit;
    case HD_SOFTWARE_FORCE_IMPULSE_LIMIT: return kImpulseLimit;
    case HD_USER_STATUS_LIGHT: return kStatusLight;
    default: return 0;
  }
}

}  // namespace halsted::haptics::hd
