#pragma once
/// As much of a Touch as is public: it tells firmware and serial number and stays silent on everything else.
#include <deque>

#include "haptics/touch/touch_identity.h"
#include "haptics/usb/usb_model.h"

namespace halsted::haptics {

enum class TouchType { kSerial, kSerialEarly, kHid };

class TouchModel final : public UsbModel {
 public:
  explicit TouchModel(TouchType type = TouchType::kSerial) : type_(type) {}

  UsbDeviceInfo info() const override;
  std::vector<std::uint8_t> descriptors() const override;
  void attach() override { toHost_.clear(); }
  UsbStatus control(const UsbControl&, std::span<std::uint8_t> data) override;
  void out(std::uint8_t endpoint, std::span<const std::uint8_t>) override;
  std::size_t in(std::uint8_t endpoint, std::span<std::uint8_t>) override;
  void advance(double) override {}                               // [s]

 private:
  TouchType type_;
  TouchFramer framer_;
  std::deque<std::uint8_t> toHost_;
};

}  // namespace halsted::haptics
