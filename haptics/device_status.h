#pragma once
/// What a device is doing and what is wrong with it, in codes; each code has one line for people, with the remedy.
#include <cstdint>

namespace halsted::haptics {

enum class DeviceStage : std::uint8_t {
  kReady,
  kSearching,                                  // not attached, or not to be opened: tried again at every plug event and twice a second
  kStarting,                                   // opened, being brought up
  kHoming                                      // answers, but does not know where it stands yet: needs the user's hand
};

enum class DeviceProblem : std::uint8_t {
  kNone, kNoUsb, kNotAttached, kUnplugged, kNoPermission, kBusy, kNotAnswering, kFirmwareMissing, kFirmwareRefused, kNeedsHoming,
  kOtherVersion, kTransferFailed, kServoNotPublic, kVendorLibraryMissing, kVendorLibraryUnusable, kVendorDeviceRefused, kNeedsInkwell,
  kMemoryShort
};
inline constexpr int kDeviceProblems = 18;

struct DeviceStatus {
  DeviceStage stage = DeviceStage::kReady;
  DeviceProblem problem = DeviceProblem::kNone;
};

const char* name(DeviceStage) noexcept;
const char* problemText(DeviceProblem) noexcept;                 // "in use by another program"
const char* remedyText(DeviceProblem) noexcept;                  // "close the other program that drives it"; never empty but for kNone

}  // namespace halsted::haptics
