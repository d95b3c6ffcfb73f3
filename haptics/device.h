#pragma once
/// The one interface that every haptic device stands behind: virtual, mouse, script, replay, and later Falcon and vendor.
/// Called on the haptic thread only; every call is noexcept, bounded and free of heap, locks and logs (DESIGN 8).
#include "sim/exchange.h"

namespace halsted::haptics {

/// One reading, in the device's own frame: x right, y up, z toward the user, origin at the middle of the workspace.
struct DeviceReading {
  Pose pose;                                   // of the stylus tip
  double jaw = 1.0;                            // [1] 0 closed, 1 open
  std::uint32_t presses = 0;                   // stylus button press counter
  bool connected = true;
};

/// What the device can do; constant after opening.
struct DeviceLimits {
  double peakForce = 3.3;                      // [N] Touch
  double continuousForce = 0.88;               // [N]
  double stiffness = 1020.0;                   // [N/m] nominal, weakest axis
  double positionStep = 0.055e-3;              // [m]
};

class Device {
 public:
  virtual ~Device() = default;
  virtual DeviceReading read(double dt) noexcept = 0;             // dt [s] since the last read; once a tick
  virtual bool write(const Vec3& force) noexcept = 0;             // [N] device frame; false: the device is gone
  virtual void setTarget(const HandTarget&) noexcept {}           // device frame; only simulated hands listen
  virtual DeviceLimits limits() const noexcept { return {}; }
  virtual const char* kind() const noexcept = 0;                  // "virtual", "mouse", "script", ...
};

}  // namespace halsted::haptics
