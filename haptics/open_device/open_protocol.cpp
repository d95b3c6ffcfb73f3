#include "haptics/open_device/open_protocol.h"

#include <algorithm>
#include <utility>

#include "haptics/usb/known_devices.h"

namespace halsted::haptics {
namespace {

constexpr std::uint8_t kEnable = 1, kHome = 2;
constexpr double kTransfer = 50e-3;            // [s]
constexpr int kTries = 20, kPacketsATry = 8;   // a device that still streams has packets on their way before its answer

}  // namespace

bool OpenProtocol::matches(const UsbDeviceInfo& info) const noexcept {
  return info.vendor == kOpenDeviceVendor && info.product == kOpenDeviceProduct && info.productName == kOpenDeviceName;
}

DeviceProblem OpenProtocol::bringUp(UsbLink& link) {
  size_ = 0;
  anyState_ = homed_ = false;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    std::array<std::uint8_t, kOpenMaxFrame> packet;
    const std::size_t hello = sealOpenFrame(kOpenHello, sequence_++, {}, packet);
    const UsbStatus sent = link.write(pipes().out, {packet.data(), hello}, kTransfer);
    if (sent == UsbStatus::kGone) return DeviceProblem::kUnplugged;
    for (int i = 0; i < kPacketsATry; ++i) {
      std::size_t got = 0, size = 0;
      OpenFrame frame;
      if (link.read(pipes().in, packet, got, kTransfer) != UsbStatus::kOk) break;
      if (parseOpenFrame({packet.data(), got}, frame, size) != OpenParse::kFrame) continue;
      if (frame.type == kOpenRefused || frame.version != kOpenVersion) return DeviceProblem::kOtherVersion;
      if (frame.type != kOpenIdentity || !decodeIdentity(frame.payload, identity_)) continue;
      return identity_.oldest <= kOpenVersion && kOpenVersion <= identity_.newest ? DeviceProblem::kNone : DeviceProblem::kOtherVersion;
    }
  }
  return DeviceProblem::kNotAnswering;
}

void OpenProtocol::take(const OpenFrame& frame, UsbMeasurement& measurement, PacketOutcome& outcome) noexcept {
  OpenState state;
  if (frame.version == kOpenVersion && frame.type != kOpenState) return;
  if (frame.version != kOpenVersion || !decodeState(frame.payload, state)) {
    ++outcome.broken;
    return;
  }
  if (anyState_ && frame.sequence == lastState_) return;          // sent twice
  anyState_ = true;
  lastState_ = frame.sequence;
  homed_ = (state.status & kOpenHomed) != 0 && (state.status & kOpenFault) == 0;
  measurement.presses += (state.buttons & ~buttons_ & ~1) != 0;
  buttons_ = state.buttons;
  measurement.pose = state.pose;
  measurement.jaw = state.buttons & 1 ? 0.0 : state.jaw;
  measurement.calibrated = homed_;
  measurement.limits = identity_.limits;
  outcome.reading = true;
}

/// A packet is a frame, but a broken stream may cut it anywhere: what is left over waits for the next packet.
PacketOutcome OpenProtocol::received(std::span<const std::uint8_t> packet, UsbMeasurement& measurement) noexcept {
  PacketOutcome outcome;
  for (const std::uint8_t byte : packet) {
    buffer_[size_++] = byte;
    for (OpenParse parsed = OpenParse::kFrame; size_ > 0 && parsed != OpenParse::kMore;) {
      OpenFrame frame;
      std::size_t size = 1;                    // what is no frame is searched byte by byte
      parsed = parseOpenFrame({buffer_.data(), size_}, frame, size);
      if (parsed == OpenParse::kMore) break;
      if (parsed == OpenParse::kFrame) take(frame, measurement, outcome);
      else size = 1;
      outcome.broken += parsed == OpenParse::kWrong && !std::exchange(lost_, true);
      if (parsed == OpenParse::kFrame) lost_ = false;
      std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(size), buffer_.begin() + static_cast<std::ptrdiff_t>(size_), buffer_.begin());
      size_ -= size;
    }
  }
  return outcome;
}

std::size_t OpenProtocol::command(const Vec3& force, bool enabled, std::span<std::uint8_t> packet) noexcept {
  const auto flags = static_cast<std::uint8_t>((enabled ? kEnable : 0) | (homed_ ? 0 : kHome));
  const auto payload = forcePayload(enabled ? force : Vec3(Vec3::Zero()), flags);
  return sealOpenFrame(kOpenForce, sequence_++, payload, packet);
}

}  // namespace halsted::haptics
