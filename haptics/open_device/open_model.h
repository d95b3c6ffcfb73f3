#pragma once
/// A self-built device in software: the reference firmware as it stands, on a mechanism that a simulated hand holds.
#include <deque>
#include <string>

#include "haptics/open_device/firmware/open_device.h"
#include "haptics/usb/usb_model.h"
#include "haptics/virtual_device.h"

namespace halsted::haptics {

struct OpenModelOptions {
  std::string serial = "OPEN0";
  bool homed = true;
  std::uint8_t version = kHodVersion;          // another one: a device of another time
};

class OpenModel final : public UsbModel {
 public:
  explicit OpenModel(const OpenModelOptions& = {});

  UsbDeviceInfo info() const override;
  std::vector<std::uint8_t> descriptors() const override;
  void attach() override;
  void detach() override;
  UsbStatus control(const UsbControl&, std::span<std::uint8_t>) override { return UsbStatus::kStalled; }
  void out(std::uint8_t endpoint, std::span<const std::uint8_t>) override;
  std::size_t in(std::uint8_t endpoint, std::span<std::uint8_t>) override;
  void advance(double dt) override;                              // [s]

  VirtualDevice& stylus() { return stylus_; }
  void moveHand(const Vec3& position);                           // [m]
  void setButtons(std::uint16_t buttons) { buttons_ = buttons; }
  void setHomed(bool homed) { options_.homed = homed; }
  const Vec3& motorForce() const { return force_; }              // [N]
  const HodDevice& firmware() const { return firmware_; }

 private:
  void servo();

  OpenModelOptions options_;
  HodDevice firmware_{};
  VirtualDevice stylus_;
  std::deque<std::vector<std::uint8_t>> toHost_;
  Vec3 force_ = Vec3::Zero();                  // [N]
  double time_ = 0.0, nextServo_ = 0.0;        // [s]
  std::uint16_t buttons_ = 0;
  bool powered_ = false;
};

}  // namespace halsted::haptics
