#pragma once
/// The one interface that every haptic device stands behind: virtual, mouse, script, replay, Falcon, open device and vendor.
/// Called on the haptic thread only, but for `serve` and `status`; every call there is noexcept, bounded and free of heap, locks and
/// logs (DESIGN 8).
#include <atomic>

#include "haptics/device_status.h"
#include "sim/exchange.h"

namespace halsted::haptics {

/// One reading, in the device's own frame: x right, y up, z toward the user, origin at the middle of the workspace.
struct DeviceReading {
  Pose pose;                                   // of the stylus tip
  double jaw = 1.0;                            // [1] 0 closed, 1 open
  std::uint32_t presses = 0;                   // stylus button press counter
  bool connected = true;
  bool fresh = true;                           // false: the transport fails or is silent; the last good pose stands, force must be zero
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

  /// A device behind a cable has a thread of its own for what may wait: open, upload, home, transfers, plug events. `serve` is that
  /// thread's body and returns soon after `stop`. Where `served` is false there is nothing to run.
  virtual bool served() const noexcept { return false; }
  virtual void serve(const std::atomic<bool>&) noexcept {}
  virtual DeviceStatus status() const noexcept { return {}; }     // any thread
  /// A device that is gone may come back by itself: the session waits for it. Otherwise losing it ends the session.
  virtual bool mayReturn() const noexcept { return false; }
};

}  // namespace halsted::haptics
