#pragma once
/// Haptic devices that are known by their USB ids, and what this program can do with each.
#include <span>
#include <string_view>

#include "haptics/usb/usb.h"

namespace halsted::haptics {

enum class Drive : std::uint8_t {
  kDriven,                                     // a driver of our own
  kIdentified,                                 // framing known, servo stream not
  kListed                                      // nothing but its ids is public
};

struct KnownDevice {
  std::uint16_t vendor, product;
  std::string_view title;
  std::string_view driver;                     // as `--left` names it; empty: none
  Drive drive;
};

std::span<const KnownDevice> knownDevices() noexcept;
/// Null for a device that is not a haptic one. The open device's ids are shared by others: its product name decides.
const KnownDevice* knownDevice(const UsbDeviceInfo&) noexcept;

inline constexpr std::uint16_t kOpenDeviceVendor = 0x1209, kOpenDeviceProduct = 0x0001;
inline constexpr std::string_view kOpenDeviceName = "Halsted open device";

}  // namespace halsted::haptics
