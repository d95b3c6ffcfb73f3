#include "haptics/falcon/falcon_model.h"

#include <algorithm>

#include "haptics/falcon/falcon_kinematics.h"
#include "haptics/falcon/falcon_protocol.h"
#include "haptics/usb/ftdi.h"

namespace halsted::haptics {
namespace {

constexpr int kHomeCounts = -900;              // an arm passes its mark here: 16 mm behind the middle, reached by pushing the grip in
constexpr std::array<int, 3> kUnhomed{310, -140, 95};

/// Grip and arms as one mass; tuned: 0.15 kg and half a newton of friction are near what users report.
TouchDynamics falconDynamics() {
  TouchDynamics falcon;
  falcon.mass = 0.15;
  falcon.friction = 0.5;
  falcon.positionStep = 0.0;                   // the encoders do that
  falcon.peakForce = 12.0;
  falcon.halfExtent = Vec3(0.045, 0.045, 0.045);
  return falcon;
}

}  // namespace

FalconModel::FalconModel(const FalconModelOptions& options) : options_(options), grip_({}, falconDynamics(), {}, "falcon model") {
  moveHand(Vec3::Zero());
  attach();
}

UsbDeviceInfo FalconModel::info() const {
  UsbDeviceInfo info;
  info.vendor = kFalconVendor;
  info.product = kFalconProduct;
  info.serial = options_.serial;
  info.productName = "FALCON HAPTIC";
  return info;
}

std::vector<std::uint8_t> FalconModel::descriptors() const {
  return bulkDescriptors({kFalconVendor, kFalconProduct, 0x0400, 0xff, 0x81, 0x02, !options_.serial.empty()});
}

/// Its own power supply keeps the firmware through a pulled USB cable; a Falcon that never had one loses nothing either.
void FalconModel::attach() {
  toDevice_.clear();
  toHost_.clear();
  if (mode_ != Mode::kRunning) mode_ = options_.firmware.empty() ? Mode::kRunning : Mode::kWaiting;
  if (commands_ == 0) {
    homed_ = options_.homed ? kFalconAllHomed : 0;
    offset_ = options_.homed ? std::array<int, 3>{} : kUnhomed;
  }
}

UsbStatus FalconModel::control(const UsbControl& request, std::span<std::uint8_t>) {
  if (request.type != kFtdiRequestType) return UsbStatus::kStalled;
  switch (request.request) {
    case kFtdiReset:
      if (request.value == kFtdiPurgeIn) toHost_.clear();
      if (request.value == kFtdiPurgeOut) toDevice_.clear();
      break;
    case kFtdiModem:
      if (request.value & 0x0100) {
        const bool high = request.value & 1;
        resetPulse_ = resetPulse_ || (high && !dtr_);
        dtr_ = high;
      }
      break;
    case kFtdiBaud:
      divisor_ = request.value;
      bytesPerSecond_ = divisor_ == kFtdiBaud1500000 ? 150000.0 : divisor_ == kFtdiBaud140000 ? 14000.0 : 960.0;
      break;
    case kFtdiLatency: latency_ = request.value * 1e-3; break;
    case kFtdiFlow:
    case kFtdiData: break;
    default: return UsbStatus::kStalled;
  }
  return UsbStatus::kOk;
}

void FalconModel::out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes) {
  if (endpoint == 0x02) toDevice_.insert(toDevice_.end(), bytes.begin(), bytes.end());
}

/// A packet leaves when it is full or when the latency timer runs out, with nothing but its status bytes if need be.
std::size_t FalconModel::in(std::uint8_t endpoint, std::span<std::uint8_t> bytes) {
  if (endpoint != 0x81 || bytes.size() < kFtdiStatusBytes || (toHost_.size() < kFtdiPayload && sincePacket_ < latency_)) return 0;
  sincePacket_ = 0.0;
  bytes[0] = 0x01;
  bytes[1] = 0x60;
  const std::size_t size = std::min({toHost_.size(), kFtdiPayload, bytes.size() - kFtdiStatusBytes});
  std::copy_n(toHost_.begin(), size, bytes.begin() + kFtdiStatusBytes);
  toHost_.erase(toHost_.begin(), toHost_.begin() + static_cast<std::ptrdiff_t>(size));
  return kFtdiStatusBytes + size;
}

void FalconModel::advance(double dt) {         // [s]
  sincePacket_ += dt;
  credit_ = toDevice_.empty() ? 0.0 : credit_ + bytesPerSecond_ * dt;
  while (credit_ >= 1.0 && !toDevice_.empty()) {
    credit_ -= 1.0;
    const std::uint8_t byte = toDevice_.front();
    toDevice_.pop_front();
    serialByte(byte);
  }
  grip_.write(motorForce());
  grip_.read(dt);
  if (const auto legs = falconLegs(grip_.position())) home(*legs);
}

Vec3 FalconModel::motorForce() const { return mode_ == Mode::kRunning ? falconForce(grip_.position(), command_.motors) : Vec3(Vec3::Zero()); }

void FalconModel::moveHand(const Vec3& position) {
  HandTarget target;
  target.pose.position = position;
  target.valid = true;
  grip_.setTarget(target);
}

void FalconModel::serialByte(std::uint8_t byte) {
  if (mode_ == Mode::kRunning) {
    if (divisor_ == kFtdiBaud1500000) runByte(byte);
  } else {
    bootByte(byte);
  }
}

void FalconModel::bootByte(std::uint8_t byte) {
  if (mode_ == Mode::kWaiting) {
    if (divisor_ != kFtdiBaud9600 || !resetPulse_) return;
    greeting_.push_back(byte);
    if (byte != 0x0d) return;
    const bool right = greeting_.size() >= 3 && greeting_[greeting_.size() - 3] == 0x0a && greeting_[greeting_.size() - 2] == 0x43;
    greeting_.clear();
    if (!right) return;
    for (const int answer : {0x00, 0x0a, 0x44, 0x2c, 0x0d}) toHost_.push_back(static_cast<std::uint8_t>(answer));
    mode_ = Mode::kGreeted;
  } else if (mode_ == Mode::kGreeted) {
    if (divisor_ != kFtdiBaud140000 || dtr_ || byte != 0x41) return;
    toHost_.push_back(byte);
    loaded_.clear();
    mode_ = Mode::kLoading;
  } else {
    toHost_.push_back(byte);
    loaded_.push_back(byte);
    if (loaded_ == options_.firmware) mode_ = Mode::kRunning;
    else if (loaded_.size() >= options_.firmware.size()) mode_ = Mode::kWaiting, resetPulse_ = false;
  }
}

void FalconModel::runByte(std::uint8_t byte) {
  if (!framer_.push(byte)) return;
  const auto command = decodeFalconCommand(framer_.frame());
  if (!command) return;
  command_ = *command;
  ++commands_;
  const FalconFrame answer = encode(reply());
  toHost_.insert(toHost_.end(), answer.begin(), answer.end());
}

/// In homing mode an arm that passes its mark learns where it stands.
void FalconModel::home(const Vec3& legs) {
  if (mode_ != Mode::kRunning || !command_.homing) return;
  for (int i = 0; i < 3; ++i) {
    if (falconLegCounts(legs[i]) > kHomeCounts) continue;
    homed_ |= static_cast<std::uint8_t>(1 << i);
    offset_[i] = 0;
  }
}

FalconReply FalconModel::reply() const {
  FalconReply reply;
  const auto legs = falconLegs(grip_.position());
  for (int i = 0; i < 3; ++i) reply.encoders[i] = (legs ? falconLegCounts((*legs)[i]) : 0) + offset_[i];
  reply.buttons = buttons_;
  reply.homed = homed_;
  return reply;
}

}  // namespace halsted::haptics
