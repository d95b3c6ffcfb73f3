#pragma once
/// Novint Falcon over its FTDI chip: firmware upload from a file of the user's (none is shipped), homing, exchange, forces.
/// Facts from public drivers (devices.md); numbers that no public source gives are marked where they stand.
#include <vector>

#include "haptics/falcon/falcon_wire.h"
#include "haptics/usb/usb_device.h"

namespace halsted::haptics {

inline constexpr std::uint16_t kFalconVendor = 0x0403, kFalconProduct = 0xcb48;

class FalconProtocol final : public UsbProtocol {
 public:
  /// `firmware` may be empty: a Falcon that runs some already needs none.
  explicit FalconProtocol(std::vector<std::uint8_t> firmware) : firmware_(std::move(firmware)) {}

  const char* kind() const noexcept override { return "falcon"; }
  bool matches(const UsbDeviceInfo& info) const noexcept override { return info.vendor == kFalconVendor && info.product == kFalconProduct; }
  UsbPipes pipes() const noexcept override { return {1, 0x81, 0x02}; }
  DeviceLimits limits() const noexcept override;
  DeviceProblem bringUp(UsbLink&) override;
  PacketOutcome received(std::span<const std::uint8_t> packet, UsbMeasurement&) noexcept override;
  std::size_t command(const Vec3& force, bool enabled, std::span<std::uint8_t> packet) noexcept override;  // [N]

 private:
  bool answers(UsbLink&);
  bool enterRunMode(UsbLink&);
  bool enterFirmwareMode(UsbLink&);
  bool upload(UsbLink&);
  bool plausible(const FalconReply&) noexcept;
  bool take(const FalconReply&, UsbMeasurement&) noexcept;

  std::vector<std::uint8_t> firmware_;
  FalconFramer framer_;
  FalconReply last_;                           // newest reply, plausible or not: the next one is compared with it
  std::uint64_t replies_ = 0;
  Vec3 position_ = Vec3::Zero();               // [m] of the grip
  bool homed_ = false;
  std::uint8_t buttons_ = 0, homedLegs_ = 0;   // as two replies in a row said
};

/// Counts for the motors that push with `force` [N] at `position` [m]: all three shrink together at the limit, so that the direction stays.
std::array<int, 3> falconMotors(const Vec3& position, const Vec3& force) noexcept;
/// The force [N] that these motors make at `position` [m]; what a model of the device feels.
Vec3 falconForce(const Vec3& position, const std::array<int, 3>& motors) noexcept;

}  // namespace halsted::haptics
