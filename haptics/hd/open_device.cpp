#include "haptics/hd/open_device.h"

#include <strings.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace halsted::haptics::hd {

namespace {

constexpr int kIdleTicks = 50;                  // so long a device keeps its last force when no frame comes
constexpr double kLongestGap = 0.1;             // [s] a motion does not run on while nobody reads
constexpr int kDeepestFrame = 1000;             // a begin without an end, in a loop, is a mistake

/// The Touch between its mechanical stops, not only in the usable part of its workspace.
TouchDynamics mechanism() noexcept {
  TouchDynamics touch;
  touch.workspaceCentre = {0.0, 0.0475, 0.0225};
  touch.halfExtent = {0.210, 0.1575, 0.1075};
  return touch;
}

HandDynamics handOf(const DeviceSettings& settings) noexcept {
  HandDynamics hand;
  if (!settings.motion.empty()) {               // a recorded hand may be quicker than the surgeon's
    hand.maxSpeed = 2.0;
    hand.maxAcceleration = 100.0;
    hand.aimTime = 2e-3;
  }
  if (settings.hand == HandKind::kLight) {
    hand.stiffness = 100.0;
    hand.damping = 4.2;
    hand.visualGain = 600.0;
  }
  if (settings.hand == HandKind::kNone) hand.stiffness = hand.damping = hand.visualGain = 0.0;
  return hand;
}

/// A text that stays: programs keep what hdGetString gave them beyond hdDisableDevice. Few and short.
const char* interned(const std::string& text) {
  static InheritingMutex mutex;
  static std::set<std::string>& texts = *new std::set<std::string>;
  const Hold hold(mutex);
  return texts.insert(text).first->c_str();
}

}  // namespace

void OpenDevice::open(const DeviceSettings& settings, Moment now) {
  std::unique_ptr<const Motion> motion;
  if (!settings.motion.empty()) motion = std::make_unique<const Motion>(readMotion(settings.motion));
  MotionSample first{0.0, {settings.start, Quat::Identity()}};
  if (motion) first = motion->samples.front();
  first.pose.position = withinReach(first.pose.position);

  const Hold hold(mutex_);
  settings_ = settings;
  motion_ = std::move(motion);
  device_.emplace(first.pose, mechanism(), handOf(settings), "virtual");
  cursor_ = 0;
  motionTime_ = 0.0;
  filter_ = {};
  capabilities_ = kCapabilityDefaults;
  safety_ = {};
  path_ = {};
  command_ = kCommandNone;
  statusLight_ = 0;
  depth_ = idleTicks_ = 0;
  frameTick_ = 0;
  calibrated_ = settings.calibrated;
  model_ = interned(settings.model);
  serial_ = interned(settings.serial);
  lastRead_ = lastSnapshot_ = lastSent_ = now.time;
  current_ = {};
  move(now.time);
  takeSnapshot();
  last_ = current_;
  open_.store(true, std::memory_order_release);
}

bool OpenDevice::close() noexcept {
  std::unique_ptr<const Motion> motion;         // freed after the lock
  const Hold hold(mutex_);
  if (!isOpen()) return false;
  device_->write(Vec3::Zero());
  device_.reset();
  motion.swap(motion_);
  depth_ = 0;
  open_.store(false, std::memory_order_release);
  return true;
}

bool OpenDevice::isNamed(const std::string& name) noexcept {
  const Hold hold(mutex_);
  return isOpen() && strcasecmp(settings_.name.c_str(), name.c_str()) == 0;
}

StylusState OpenDevice::followMotion(double dt) noexcept {  // [s]
  StylusState stylus;
  // After power-on the encoders count from wherever the arm was.
  if (!calibrated_) stylus.encoderError = {0.05, -0.04, 0.03};
  if (!motion_) return stylus;
  motionTime_ += std::min(dt, kLongestGap);
  if (settings_.loop && motionTime_ > motion_->duration()) motionTime_ = 0.0;
  const MotionSample now = sampleAt(*motion_, motionTime_, cursor_);
  device_->setTarget({{withinReach(now.pose.position), now.pose.orientation}, 1.0, true});
  stylus.buttons = static_cast<int>(now.buttons);
  stylus.docked = now.inkwell;
  return stylus;
}

void OpenDevice::move(Nanoseconds time) noexcept {
  const double dt = std::max(0.0, seconds(time - lastRead_));  // [s]
  lastRead_ = std::max(time, lastRead_);
  stylus_ = followMotion(dt);
  pose_ = device_->read(dt).pose;
}

void OpenDevice::takeSnapshot() noexcept {
  last_ = current_;
  advanceState(pose_, stylus_, seconds(lastRead_ - lastSnapshot_), filter_, current_);
  lastSnapshot_ = lastRead_;
}

void OpenDevice::beginCommands() noexcept {
  std::fill_n(current_.force, 3, 0.0);
  std::fill_n(current_.torque, 3, 0.0);
  std::fill_n(current_.jointTorque, 3, 0.0);
  std::fill_n(current_.gimbalTorque, 3, 0.0);
  std::fill_n(current_.motors, 6, 0L);
  command_ = kCommandNone;
}

HDerror OpenDevice::beginFrame(Moment now) noexcept {
  const Hold hold(mutex_);
  if (!isOpen()) return HD_BAD_HANDLE;
  if (depth_ > 0) {
    if (depth_ >= kDeepestFrame) return HD_ILLEGAL_BEGIN;
    ++depth_;
    return HD_SUCCESS;
  }
  if (now.tick != 0 && now.tick == frameTick_ && (capabilities_ & kOneFrameLimit)) return HD_ILLEGAL_BEGIN;
  depth_ = 1;
  frameTick_ = now.tick;
  move(now.time);
  takeSnapshot();
  beginCommands();
  return HD_SUCCESS;
}

HDerror OpenDevice::endFrame(Moment now, std::uint32_t& errors) noexcept {
  const Hold hold(mutex_);
  if (!isOpen()) return HD_BAD_HANDLE;
  if (depth_ == 0) return HD_ILLEGAL_END;
  if (--depth_ > 0) return HD_SUCCESS;
  idleTicks_ = 0;
  sendForce(now, errors);
  return HD_SUCCESS;
}

void OpenDevice::sendForce(Moment now, std::uint32_t& errors) noexcept {
  const bool motors = command_ == kCommandMotors;
  const Vec3 wanted = commandedForce(current_, command_);
  Vec3 sent = Vec3::Zero();
  if (now.forces && (capabilities_ & kForceOutput)) {
    const double dt = std::clamp(seconds(now.time - lastSent_), 0.0, kLongestGap);  // [s]
    sent = shapeForce(wanted, current_.velocity, {capabilities_, safety_, device_->limits(), dt}, path_, errors);
  } else if (!allFinite(wanted)) {
    errors |= kErrorForce;
  }
  lastSent_ = std::max(now.time, lastSent_);
  device_->write(sent);
  if (!motors) storeMotors(current_.jointAngles, sent, current_.motors);
}

HDerror OpenDevice::endTick(Moment now) noexcept {
  const Hold hold(mutex_);
  if (!isOpen()) return HD_SUCCESS;
  if (depth_ > 0 && frameTick_ == now.tick) {   // what it commanded is unfinished: nothing is sent
    depth_ = 0;
    device_->write(Vec3::Zero());
    path_.limits.ramp = 0.0;
    return HD_FRAME_ERROR;
  }
  if (depth_ > 0 || frameTick_ == now.tick) return HD_SUCCESS;
  idle(now.time);
  return HD_SUCCESS;
}

void OpenDevice::idle(Nanoseconds time) noexcept {
  move(time);
  if (idleTicks_ == kIdleTicks) {               // nobody opens frames: the snapshot follows the device by itself
    takeSnapshot();
    return;
  }
  if (++idleTicks_ < kIdleTicks) return;        // the motors hold
  device_->write(Vec3::Zero());
  path_.limits.ramp = 0.0;
  path_.lastWanted = Vec3::Zero();
  beginCommands();
}

void OpenDevice::relax() noexcept {
  const Hold hold(mutex_);
  if (!isOpen()) return;
  device_->write(Vec3::Zero());
  path_.limits.ramp = 0.0;
  path_.limits.hold = 0.0;
  path_.lastWanted = Vec3::Zero();
}

void OpenDevice::engage() noexcept {
  const Hold hold(mutex_);
  path_.limits.ramp = 0.0;
  path_.lastWanted = Vec3::Zero();
}

}  // namespace halsted::haptics::hd
