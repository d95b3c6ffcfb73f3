#include "haptics/falcon/falcon_protocol.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "haptics/falcon/falcon_kinematics.h"
#include "haptics/usb/ftdi.h"

namespace halsted::haptics {
namespace {

constexpr double kCountsPerTorque = 10000.0;   // [1/(N m)] of public drivers; 8 N need about their limit of 4096 then, as they should
constexpr int kLargestJump = 200;              // counts between two replies: 0.13 rad, some 6 mm; a hand makes 10 a millisecond
constexpr std::uint8_t kIn = 0x81, kOut = 0x02;
constexpr double kTransfer = 50e-3;            // [s]
constexpr int kPatience = 20;                  // packets without a byte

bool ok(UsbStatus status) { return status == UsbStatus::kOk; }

bool exchangeBytes(UsbLink& link, std::span<const std::uint8_t> sent, std::span<std::uint8_t> answer, std::size_t& got) {
  if (!ok(link.write(kOut, sent, kTransfer))) return false;
  ftdiRead(link, {kIn, kTransfer, kPatience}, answer, got);
  return true;
}

/// All of `settings` in turn, stopping at the first that fails.
bool setAll(UsbLink& link, std::initializer_list<std::pair<FtdiRequest, std::uint16_t>> settings) {
  return std::all_of(settings.begin(), settings.end(), [&](const auto& setting) { return ok(ftdiSet(link, setting.first, setting.second)); });
}

}  // namespace

std::array<int, 3> falconMotors(const Vec3& position, const Vec3& force) noexcept {
  const auto torque = falconTorque(position, force);
  if (!torque) return {};
  const Vec3 counts = -*torque * kCountsPerTorque;
  const double largest = counts.cwiseAbs().maxCoeff();
  const double share = largest > kFalconMotorLimit ? kFalconMotorLimit / largest : 1.0;
  std::array<int, 3> motors;
  for (int i = 0; i < 3; ++i) motors[i] = static_cast<int>(std::lround(counts[i] * share));
  return motors;
}

Vec3 falconForce(const Vec3& position, const std::array<int, 3>& motors) noexcept {
  const auto rates = falconLegRates(position);
  if (!rates) return Vec3::Zero();
  return rates->transpose() * Vec3(motors[0], motors[1], motors[2]) / -kCountsPerTorque;
}

/// chai3d's limits for the Falcon: 8 N and 3000 N/m. No continuous force is published: 2.5 N is this project's own caution. The step is
/// what one count moves the grip at the middle of the workspace, along the weakest direction.
DeviceLimits FalconProtocol::limits() const noexcept { return {8.0, 2.5, 3000.0, 0.05e-3}; }

DeviceProblem FalconProtocol::bringUp(UsbLink& link) {
  framer_ = {};
  replies_ = 0;
  homed_ = false;
  last_ = {};
  buttons_ = homedLegs_ = 0;
  if (!enterRunMode(link)) return DeviceProblem::kNotAnswering;
  if (answers(link)) return DeviceProblem::kNone;
  if (firmware_.empty()) return DeviceProblem::kFirmwareMissing;
  constexpr int kAttempts = 3;
  for (int attempt = 0; attempt < kAttempts; ++attempt)
    if (enterFirmwareMode(link) && upload(link) && enterRunMode(link) && answers(link)) return DeviceProblem::kNone;
  return DeviceProblem::kFirmwareRefused;
}

bool FalconProtocol::enterRunMode(UsbLink& link) {
  return setAll(link, {{kFtdiLatency, 1}, {kFtdiBaud, kFtdiBaud1500000}, {kFtdiReset, kFtdiPurgeIn}, {kFtdiReset, kFtdiPurgeOut}});
}

/// The firmware answers a command without force; a Falcon that waits for firmware does not.
bool FalconProtocol::answers(UsbLink& link) {
  constexpr int kTries = 3;
  for (int i = 0; i < kTries; ++i) {
    const FalconFrame question = encode(FalconCommand{});
    std::array<std::uint8_t, kFalconFrame> answer;
    std::size_t got = 0;
    if (!exchangeBytes(link, question, answer, got)) return false;
    if (decodeFalconReply({answer.data(), got})) return true;
    ftdiPurge(link);
  }
  return false;
}

bool FalconProtocol::enterFirmwareMode(UsbLink& link) {
  constexpr int kTries = 100, kBootPatience = 3;                 // 3 packets are 48 ms here
  constexpr std::array<std::uint8_t, 3> kHello{0x0a, 0x43, 0x0d};
  constexpr std::array<std::uint8_t, 4> kWelcome{0x0a, 0x44, 0x2c, 0x0d};
  if (!setAll(link, {{kFtdiReset, kFtdiPurgeIn}, {kFtdiReset, kFtdiPurgeOut}, {kFtdiLatency, 16}, {kFtdiBaud, kFtdiBaud9600},
                     {kFtdiData, kFtdi8n1}, {kFtdiFlow, 0}, {kFtdiModem, kFtdiRtsLow}, {kFtdiModem, kFtdiDtrLow}, {kFtdiModem, kFtdiDtrHigh}}))
    return false;
  bool welcome = false;
  for (int i = 0; i < kTries && !welcome; ++i) {
    // A zero from the change of speed may come first, so the answer is four bytes or five.
    std::array<std::uint8_t, 5> answer{};
    std::size_t got = 0;
    if (!ok(link.write(kOut, kHello, kTransfer))) return false;
    ftdiRead(link, {kIn, kTransfer, kBootPatience}, answer, got);
    const std::size_t skipped = got == 5 && answer[0] == 0 ? 1 : 0;
    welcome = got >= kWelcome.size() && std::equal(kWelcome.begin(), kWelcome.end(), answer.begin() + static_cast<std::ptrdiff_t>(skipped));
    if (!welcome) ftdiPurge(link);
  }
  if (!welcome || !setAll(link, {{kFtdiModem, kFtdiDtrLow}, {kFtdiBaud, kFtdiBaud140000}})) return false;
  std::array<std::uint8_t, 1> echo{};
  std::size_t got = 0;
  constexpr std::array<std::uint8_t, 1> kReady{0x41};
  return exchangeBytes(link, kReady, echo, got) && got == 1 && echo[0] == kReady[0];
}

bool FalconProtocol::upload(UsbLink& link) {
  for (std::size_t at = 0; at < firmware_.size(); at += kFtdiPayload) {
    const std::span<const std::uint8_t> block(firmware_.data() + at, std::min(kFtdiPayload, firmware_.size() - at));
    std::array<std::uint8_t, kFtdiPayload> echo;
    std::size_t got = 0;
    if (!exchangeBytes(link, block, {echo.data(), block.size()}, got)) return false;
    if (got != block.size() || !std::equal(block.begin(), block.end(), echo.begin())) return false;
  }
  return true;
}

/// A reply far from the one before is held back once: a turned-over bit is gone by the next, a real jump is confirmed by it.
bool FalconProtocol::plausible(const FalconReply& reply) noexcept {
  if (replies_++ == 0) return true;
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(reply.encoders[i] - last_.encoders[i]) > kLargestJump) return false;
  return true;
}

/// False for a reply that cannot be believed.
bool FalconProtocol::take(const FalconReply& reply, UsbMeasurement& measurement) noexcept {
  const bool believed = plausible(reply);
  const bool confirmed = reply.buttons == last_.buttons && reply.homed == last_.homed;   // a turned-over bit does not say it twice
  last_ = reply;
  if (!believed) return false;
  const FalconLegs legs(falconLegAngle(reply.encoders[0]), falconLegAngle(reply.encoders[1]), falconLegAngle(reply.encoders[2]));
  const std::uint8_t buttonsBefore = buttons_;
  if (confirmed) {
    buttons_ = reply.buttons;
    homedLegs_ = reply.homed;
  }
  homed_ = homedLegs_ == kFalconAllHomed;
  if (const auto position = falconPosition(legs, position_)) position_ = *position;
  else if (homed_) return false;               // angles that the mechanism cannot have
  measurement.presses += (buttons_ & ~buttonsBefore & (kFalconPlus | kFalconForward | kFalconMinus)) != 0;
  measurement.pose.position = position_;
  measurement.jaw = buttons_ & kFalconCentre ? 0.0 : 1.0;
  measurement.calibrated = homed_;
  return true;
}

PacketOutcome FalconProtocol::received(std::span<const std::uint8_t> packet, UsbMeasurement& measurement) noexcept {
  PacketOutcome outcome;
  const std::uint64_t dropped = framer_.dropped();
  // A long read holds several chip packets, each with its own two status bytes.
  for (std::size_t at = 0; at < packet.size(); at += kFtdiPacket) {
    const auto chip = packet.subspan(at, std::min(kFtdiPacket, packet.size() - at));
    for (std::size_t i = kFtdiStatusBytes; i < chip.size(); ++i) {
      if (!framer_.push(chip[i])) continue;
      const auto reply = decodeFalconReply(framer_.frame());
      if (reply && take(*reply, measurement)) outcome.reading = true;
      else ++outcome.broken;
    }
  }
  outcome.broken += static_cast<int>(framer_.dropped() - dropped);
  return outcome;
}

std::size_t FalconProtocol::command(const Vec3& force, bool enabled, std::span<std::uint8_t> packet) noexcept {
  FalconCommand command;
  command.homing = !homed_;
  command.lights = homed_ ? (enabled ? kFalconGreen : kFalconBlue) : kFalconRed;
  if (enabled && homed_) command.motors = falconMotors(position_, force);
  const FalconFrame frame = encode(command);
  std::copy(frame.begin(), frame.end(), packet.begin());
  return frame.size();
}

}  // namespace halsted::haptics
