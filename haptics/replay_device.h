#pragma once
/// Feeds recorded readings back, one a read: the same hand without the hand. Open loop: what is written to it moves nothing.
#include <vector>

#include "haptics/device.h"

namespace halsted::haptics {

class ReplayDevice final : public Device {
 public:
  /// `readings` in tick order; an empty list reads as disconnected. `limits` are those of the recorded device.
  explicit ReplayDevice(std::vector<DeviceReading> readings, const DeviceLimits& limits = {});

  DeviceReading read(double dt) noexcept override;                 // [s] unused: one reading a call; the last one stays
  bool write(const Vec3& force) noexcept override;                 // [N]
  DeviceLimits limits() const noexcept override { return limits_; }
  const char* kind() const noexcept override { return "replay"; }

  bool finished() const noexcept { return next_ >= readings_.size(); }

 private:
  std::vector<DeviceReading> readings_;
  DeviceLimits limits_;
  std::size_t next_ = 0;
};

}  // namespace halsted::haptics
