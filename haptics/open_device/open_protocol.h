#pragma once
/// Driver of a self-built device that speaks the open wire protocol (PROTOCOL.md).
#include "haptics/open_device/open_wire.h"
#include "haptics/usb/usb_device.h"

namespace halsted::haptics {

class OpenProtocol final : public UsbProtocol {
 public:
  const char* kind() const noexcept override { return "open"; }
  bool matches(const UsbDeviceInfo&) const noexcept override;
  UsbPipes pipes() const noexcept override { return {1, 0x81, 0x01}; }
  DeviceLimits limits() const noexcept override { return identity_.limits; }
  DeviceProblem bringUp(UsbLink&) override;
  PacketOutcome received(std::span<const std::uint8_t> packet, UsbMeasurement&) noexcept override;
  std::size_t command(const Vec3& force, bool enabled, std::span<std::uint8_t> packet) noexcept override;  // [N]

  const OpenIdentity& identity() const noexcept { return identity_; }   // of the device brought up last

 private:
  void take(const OpenFrame&, UsbMeasurement&, PacketOutcome&) noexcept;

  OpenIdentity identity_;
  std::array<std::uint8_t, kOpenMaxFrame> buffer_{};              // a frame that came in pieces
  std::size_t size_ = 0;
  std::uint8_t sequence_ = 0, lastState_ = 0;
  bool anyState_ = false, homed_ = false;
  std::uint16_t buttons_ = 0;
  bool lost_ = false;                          // between frames that are none
};

}  // namespace halsted::haptics
