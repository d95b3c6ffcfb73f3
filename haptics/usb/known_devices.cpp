#include "haptics/usb/known_devices.h"

#include <array>

namespace halsted::haptics {
namespace {

/// Ids as seen in public drivers and reports. An early Touch shows vendor and product swapped.
constexpr std::array<KnownDevice, 6> kKnown{{
    {0x0403, 0xcb48, "Novint Falcon", "falcon", Drive::kDriven},
    {kOpenDeviceVendor, kOpenDeviceProduct, "self-built device, open protocol", "open", Drive::kDriven},
    {0x2988, 0x0302, "3D Systems Touch (USB, serial type)", "", Drive::kIdentified},
    {0x0301, 0x2988, "3D Systems Touch (USB, serial type, early unit)", "", Drive::kIdentified},
    {0x2988, 0x0304, "3D Systems Touch (USB, HID type)", "", Drive::kListed},
    {0x1451, 0x0402, "Force Dimension omega", "", Drive::kListed},
}};

}  // namespace

std::span<const KnownDevice> knownDevices() noexcept { return kKnown; }

const KnownDevice* knownDevice(const UsbDeviceInfo& info) noexcept {
  for (const KnownDevice& known : kKnown) {
    if (info.vendor != known.vendor || info.product != known.product) continue;
    const bool shared = known.vendor == kOpenDeviceVendor && known.product == kOpenDeviceProduct;
    if (!shared || info.productName == kOpenDeviceName) return &known;
  }
  return nullptr;
}

}  // namespace halsted::haptics
