#include "haptics/replay_device.h"

#include <utility>

namespace halsted::haptics {

ReplayDevice::ReplayDevice(std::vector<DeviceReading> readings, const DeviceLimits& limits)
    : readings_(std::move(readings)), limits_(limits) {}

DeviceReading ReplayDevice::read(double) noexcept {
  if (readings_.empty()) {
    DeviceReading none;
    none.connected = false;
    return none;
  }
  if (next_ < readings_.size()) ++next_;
  return readings_[next_ - 1];
}

bool ReplayDevice::write(const Vec3&) noexcept { return !readings_.empty() && readings_[next_ == 0 ? 0 : next_ - 1].connected; }

}  // namespace halsted::haptics
