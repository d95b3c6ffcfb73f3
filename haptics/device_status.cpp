#include "haptics/device_status.h"

#include <array>

namespace halsted::haptics {
namespace {

struct Lines { const char *problem, *remedy; };

/// In the order of the enumeration; a test walks it.
constexpr std::array<Lines, kDeviceProblems> kLines{{
    {"nothing is wrong", ""},
    {"this system has no USB", "check that the kernel offers /dev/bus/usb (a container needs it passed in)"},
    {"not attached", "plug it in and switch it on"},
    {"unplugged", "plug the cable in again; the session goes on from where it stopped"},
    {"no permission to open it", "install the rule: sudo cp haptics/usb/60-halsted.rules /etc/udev/rules.d/ && sudo udevadm control --reload && sudo udevadm trigger"},
    {"in use by another program", "close the other program that drives it"},
    {"it does not answer", "switch it off and on again, then plug it in directly, not through a hub"},
    {"it runs no firmware, and no firmware file was given", "give the file of your own device: --firmware FILE or HALSTED_FALCON_FIRMWARE=FILE"},
    {"it refused the firmware", "switch it off and on again; check that the file is the firmware of this device"},
    {"not calibrated", "pull the grip all the way out and push it all the way in, until its light turns green"},
    {"it speaks another version of the protocol", "update its firmware: haptics/open_device/PROTOCOL.md says which version this program speaks"},
    {"a transfer failed", "check cable and plug; it is tried again by itself"},
    {"its servo protocol is not public", "install the vendor's driver (libHD.so) and use it as vendor, or take virtual"},
    {"the vendor's libHD.so is not installed", "install the vendor's driver, or name its library: HALSTED_VENDOR_LIBHD=/path/to/libHD.so"},
    {"the vendor's libHD.so lacks functions that are needed", "install a complete version of the vendor's driver"},
    {"the vendor's library could not open the device", "check cable and power, and that the vendor's own set-up program finds it under this name"},
    {"not calibrated", "put the stylus into the inkwell until its light is steady, then take it out"},
    {"not enough memory for its transfers", "close other programs"},
}};

}  // namespace

const char* name(DeviceStage stage) noexcept {
  switch (stage) {
    case DeviceStage::kReady: return "ready";
    case DeviceStage::kSearching: return "searching";
    case DeviceStage::kStarting: return "starting";
    case DeviceStage::kHoming: return "homing";
  }
  return "unknown";
}

const char* problemText(DeviceProblem problem) noexcept { return kLines[static_cast<std::size_t>(problem)].problem; }
const char* remedyText(DeviceProblem problem) noexcept { return kLines[static_cast<std::size_t>(problem)].remedy; }

}  // namespace halsted::haptics
