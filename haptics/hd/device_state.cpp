#include "haptics/hd/device_state.h"

#include <algorithm>
#include <cmath>

#include "haptics/limits.h"

namespace halsted::haptics::hd {

namespace {

constexpr double kSmoothing = 3e-3;                    // [s] tuned: encoder steps of 0.055 mm stay below 20 mm/s of noise
constexpr double kTwoPi = 6.283185307179586;           // [rad]
constexpr double kJointCounts = 15000.0 / kTwoPi;      // [1/rad] incremental encoders, signs + - +
constexpr double kGimbalCounts = 2048.0 / kTwoPi;      // [1/rad] 11 usable bits of the potentiometers over a turn
constexpr double kLow[3] = {-0.200, -0.100, -0.080};   // [m] the mechanical workspace, with room for a push
constexpr double kHigh[3] = {0.200, 0.195, 0.125};     // [m]

void store(const Vec3& v, double scale, double* out) noexcept {  // [1]
  for (int i = 0; i < 3; ++i) out[i] = v[i] * scale;
}

Vec3 smoothed(const Vec3& before, const Vec3& now, double dt) noexcept {  // [s]
  const Vec3 next = before + (now - before) * (dt / (kSmoothing + dt));
  return next.dot(next) > 1e-18 ? next : Vec3(Vec3::Zero());
}

/// Angular velocity in the device frame from two orientations.
Vec3 turnRate(const Quat& from, const Quat& to, double dt) noexcept {  // [s]
  Quat turn = to * from.conjugate();
  if (turn.w() < 0.0) turn.coeffs() = -turn.coeffs();
  const double sine = turn.vec().norm();  // [1]
  if (!(sine > 1e-12)) return Vec3::Zero();
  return turn.vec() * (2.0 * std::atan2(sine, turn.w()) / (sine * dt));
}

void filterMotion(const Pose& pose, double dt, MotionFilter& filter) noexcept {  // [s]
  if (filter.started && dt > 0.0) {
    filter.velocity = smoothed(filter.velocity, (pose.position - filter.position) / dt, dt);
    filter.turnRate = smoothed(filter.turnRate, turnRate(filter.orientation, pose.orientation, dt), dt);
  }
  filter.position = pose.position;
  filter.orientation = pose.orientation;
  filter.started = true;
}

/// Columns: turret, thigh, shin, then the three gimbal axes; rows: linear, angular. The shin's angle is absolute, so the thigh turns
/// nothing behind the elbow.
void storeJacobian(const TouchJoints& joints, const TouchGimbal& gimbal, double* out) noexcept {
  Eigen::Matrix<double, 6, 6, Eigen::RowMajor> jacobian = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>::Zero();
  jacobian.topLeftCorner<3, 3>() = touchJacobian(joints) * 1e3;
  const Quat turret(Eigen::AngleAxisd(-joints[0], Vec3::UnitY()));
  const Quat shin = turret * Quat(Eigen::AngleAxisd(-joints[2], Vec3::UnitX()));
  const Quat yaw = shin * Quat(Eigen::AngleAxisd(gimbal[0], Vec3::UnitY()));
  const Quat pitch = yaw * Quat(Eigen::AngleAxisd(-gimbal[1], Vec3::UnitX()));
  jacobian.block<3, 1>(3, 0) = -Vec3::UnitY();
  jacobian.block<3, 1>(3, 2) = turret * -Vec3::UnitX();
  jacobian.block<3, 1>(3, 3) = shin * Vec3::UnitY();
  jacobian.block<3, 1>(3, 4) = yaw * -Vec3::UnitX();
  jacobian.block<3, 1>(3, 5) = pitch * -Vec3::UnitZ();
  std::copy_n(jacobian.data(), 36, out);
}

void storeEncoders(const TouchJoints& joints, const TouchGimbal& gimbal, long* out) noexcept {
  constexpr double kSign[3] = {1.0, -1.0, 1.0};
  for (int i = 0; i < 3; ++i) out[i] = std::lround(kSign[i] * joints[i] * kJointCounts);
  for (int i = 0; i < 3; ++i) out[3 + i] = 1024 + std::lround(gimbal[i] * kGimbalCounts);
}

}  // namespace

TouchJoints jointsTowards(const Vec3& position) noexcept {
  if (const auto joints = touchJoints(position)) return *joints;
  const TouchLinks links;
  const Vec3 shoulder(0.0, links.height, -links.depth);
  const Vec3 arm = position - shoulder;
  const double length = arm.norm();  // [m]
  if (!(length > 1e-6)) return Vec3::Zero();
  const double reach = std::min(length, links.upperArm + links.forearm - 1e-6);  // [m]
  return touchJoints(shoulder + arm * (reach / length)).value_or(TouchJoints(Vec3::Zero()));
}

Vec3 withinReach(const Vec3& position) noexcept {
  const TouchLinks links;
  const Vec3 shoulder(0.0, links.height, -links.depth);
  Vec3 inside;
  for (int axis = 0; axis < 3; ++axis) inside[axis] = std::clamp(position[axis], kLow[axis], kHigh[axis]);
  const Vec3 arm = inside - shoulder;
  return shoulder + clampLength(arm, links.upperArm + links.forearm - 5e-3);
}

void writeTransform(const Vec3& position, const Quat& orientation, double* transform) noexcept {
  const Mat3 turn = orientation.toRotationMatrix();
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) transform[4 * column + row] = turn(row, column);
    transform[4 * column + 3] = 0.0;
    transform[12 + column] = position[column] * 1e3;
  }
  transform[15] = 1.0;
}

void advanceState(const Pose& reading, const StylusState& stylus, double dt, MotionFilter& filter, DeviceState& state) noexcept {
  TouchJoints joints = jointsTowards(reading.position);
  const TouchGimbal gimbal = touchGimbal(joints, reading.orientation);
  Pose pose = reading;
  if (stylus.encoderError != Vec3::Zero()) {  // the device believes its encoders
    joints += stylus.encoderError;
    pose = {touchPosition(joints), touchOrientation(joints, gimbal)};
  }
  filterMotion(pose, dt, filter);
  store(pose.position, 1e3, state.position);
  store(filter.velocity, 1e3, state.velocity);
  store(filter.turnRate, 1.0, state.angularVelocity);
  store(joints, 1.0, state.jointAngles);
  store(gimbal, 1.0, state.gimbalAngles);
  writeTransform(pose.position, pose.orientation, state.transform);
  storeJacobian(joints, gimbal, state.jacobian);
  storeEncoders(joints, gimbal, state.encoders);
  state.buttons = stylus.buttons;
  state.inkwellSwitch = !stylus.docked;
}

}  // namespace halsted::haptics::hd
