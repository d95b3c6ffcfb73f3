#include "haptics/touch/touch_model.h"

#include <algorithm>
#include <string_view>

namespace halsted::haptics {
namespace {

std::vector<std::uint8_t> padded(std::string_view text, std::size_t size) {
  std::vector<std::uint8_t> bytes(text.begin(), text.end());
  bytes.resize(size, 0);
  return bytes;
}

}  // namespace

UsbDeviceInfo TouchModel::info() const {
  UsbDeviceInfo info;
  info.vendor = type_ == TouchType::kSerialEarly ? 0x0301 : 0x2988;
  info.product = type_ == TouchType::kHid ? 0x0304 : type_ == TouchType::kSerial ? 0x0302 : 0x2988;
  info.productName = "Touch";
  return info;
}

/// Serial: a CDC pair, line settings on interface 0 and bytes on interface 1. HID: one interface with a report endpoint.
std::vector<std::uint8_t> TouchModel::descriptors() const {
  const UsbDeviceInfo id = info();
  const auto low = [](std::uint16_t v) { return static_cast<std::uint8_t>(v & 0xff); };
  const auto high = [](std::uint16_t v) { return static_cast<std::uint8_t>(v >> 8); };
  std::vector<std::uint8_t> bytes{18, 1, 0x00, 0x02, type_ == TouchType::kHid ? std::uint8_t{0} : std::uint8_t{2}, 0, 0, 64, low(id.vendor),
                                  high(id.vendor), low(id.product), high(id.product), 0x00, 0x01, 1, 2, 0, 1};
  const std::vector<std::uint8_t> serial{9, 2, 48, 0, 2, 1, 0, 0xc0, 50, 9, 4, 0, 0, 1, 2, 2, 1, 0, 7, 5, 0x83, 3, 8, 0, 16,
                                         9, 4, 1, 0, 2, 10, 0, 0, 0, 7, 5, kTouchIn, 2, 64, 0, 0, 7, 5, kTouchOut, 2, 64, 0, 0};
  const std::vector<std::uint8_t> hid{9, 2, 34, 0, 1, 1, 0, 0xc0, 50, 9, 4, 0, 0, 1, 3, 0, 0, 0,
                                      9, 0x21, 0x11, 0x01, 0, 1, 0x22, 52, 0, 7, 5, 0x81, 3, 64, 0, 1};
  const auto& configuration = type_ == TouchType::kHid ? hid : serial;
  bytes.insert(bytes.end(), configuration.begin(), configuration.end());
  return bytes;
}

UsbStatus TouchModel::control(const UsbControl& request, std::span<std::uint8_t>) {
  return type_ != TouchType::kHid && request.type == 0x21 && (request.request == 0x20 || request.request == 0x22) ? UsbStatus::kOk
                                                                                                                 : UsbStatus::kStalled;
}

void TouchModel::out(std::uint8_t endpoint, std::span<const std::uint8_t> bytes) {
  if (type_ == TouchType::kHid || endpoint != kTouchOut) return;
  for (const std::uint8_t byte : bytes) {
    const auto frame = framer_.push(byte);
    if (!frame) continue;
    std::vector<std::uint8_t> answer;
    if (frame->command == kTouchAskFirmware) answer = encode({kTouchFirmware, padded("Touch model 1.0", 32)});
    if (frame->command == kTouchAskSerial) answer = encode({kTouchSerial, padded("TM-0001", 97)});
    toHost_.insert(toHost_.end(), answer.begin(), answer.end());
  }
}

std::size_t TouchModel::in(std::uint8_t endpoint, std::span<std::uint8_t> bytes) {
  if (endpoint != kTouchIn) return 0;
  const std::size_t size = std::min({toHost_.size(), bytes.size(), std::size_t{64}});
  std::copy_n(toHost_.begin(), size, bytes.begin());
  toHost_.erase(toHost_.begin(), toHost_.begin() + static_cast<std::ptrdiff_t>(size));
  return size;
}

}  // namespace halsted::haptics
