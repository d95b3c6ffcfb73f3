#include "haptics/usb/usb.h"

#include "haptics/usb/usb_model.h"

namespace halsted::haptics {

const char* name(UsbStatus status) noexcept {
  switch (status) {
    case UsbStatus::kOk: return "ok";
    case UsbStatus::kTimeout: return "no answer in time";
    case UsbStatus::kStalled: return "endpoint stalled";
    case UsbStatus::kGone: return "unplugged";
    case UsbStatus::kOverflow: return "packet too long";
    case UsbStatus::kNoPermission: return "no permission";
    case UsbStatus::kBusy: return "in use by another program";
    case UsbStatus::kNotFound: return "not attached";
    case UsbStatus::kFailed: return "transfer failed";
  }
  return "unknown";
}

std::vector<std::uint8_t> bulkDescriptors(const BulkPair& pair) {
  const auto low = [](std::uint16_t v) { return static_cast<std::uint8_t>(v & 0xff); };
  const auto high = [](std::uint16_t v) { return static_cast<std::uint8_t>(v >> 8); };
  const std::uint8_t serialIndex = pair.hasSerial ? 3 : 0;
  return {18, 1, 0x00, 0x02, 0, 0, 0, 64, low(pair.vendor), high(pair.vendor), low(pair.product), high(pair.product),
          low(pair.version), high(pair.version), 1, 2, serialIndex, 1,
          9, 2, 32, 0, 1, 1, 0, 0xa0, 50,
          9, 4, 0, 0, 2, pair.interfaceClass, 0xff, 0xff, 2,
          7, 5, pair.in, 2, 64, 0, 0,
          7, 5, pair.out, 2, 64, 0, 0};
}

}  // namespace halsted::haptics
