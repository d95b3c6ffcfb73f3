#pragma once
/// The bounded force check of `halsted devices --test`: 1.5 N along each axis, and whether the grip went that way.
/// The shipped tick with all its limits; main thread, with the device's own thread beside it.
#include <functional>
#include <string>
#include <vector>

#include "haptics/device.h"
#include "haptics/realtime.h"

namespace halsted::app {

struct Push {
  std::string axis;                            // "+x", ...
  Vec3 force = Vec3::Zero();                   // [N] asked for, device frame
  Vec3 moved = Vec3::Zero();                   // [m] farthest that the grip gave way along the push
  bool right = false;                          // it went where it was pushed
};

struct ForceCheck {
  haptics::DeviceStatus status;                // at the end
  std::vector<Push> pushes;
  std::uint32_t faults = 0;                    // FaultCode bits seen while pushing, those that cut
  double restNoise = 0.0;                      // [m] largest distance from the mean before the first push
  double largestForce = 0.0;                   // [N] sent
  double largestSpeed = 0.0;                   // [m/s]
  std::uint64_t ticks = 0;
  double seconds = 0.0;                        // [s]
  int interruptions = 0;                       // pushes begun again because no reading came for 10 ms
  bool ready = false, passed = false;
};

/// Where the check's time comes from: a clock and a sleep until then [ns]. Tests put virtual time in their place.
struct CheckClock {
  std::function<haptics::Nanoseconds()> now;
  std::function<void(haptics::Nanoseconds)> sleepUntil;
};

/// `patience` [s]: how long a device may take to be homed by its user. Stops early when the grip runs away.
ForceCheck checkForces(haptics::Device&, double patience);   // [s]
/// The same where the caller's `sleepUntil` serves the device.
ForceCheck checkForces(haptics::Device&, double patience, const CheckClock&);   // [s]

}  // namespace halsted::app
