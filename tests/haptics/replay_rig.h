#pragma once
/// The shipped tick around recorded readings: the position is exactly what the test says. And what such tests feed it.
#include <cstdint>
#include <vector>

#include "haptics/hand_loop.h"
#include "haptics/replay_device.h"

namespace halsted::haptics {

/// A loop around recorded readings: the position is exactly what the test says.
struct ReplayRig {
  explicit ReplayRig(const std::vector<DeviceReading>& readings) : device(readings) { state.limits.ramp = 1.0; }
  Vec3 next() {
    tick(device, config, contact, {}, ++index, state, output);
    return output.force;
  }
  ReplayDevice device;
  HandLoopConfig config;
  HandLoopState state;
  HandLoopOutput output;
  LocalContact contact;
  std::uint64_t index = 0;
};

inline DeviceReading readingAt(const Vec3& position) {  // [m]
  DeviceReading reading;
  reading.pose.position = position;
  return reading;
}

/// A grasp: it may push and pull.
inline LocalContact bilateral(std::uint64_t step, const Vec3& force, double stiffness = 300.0) {  // [N] [N/m]
  LocalContact contact;
  contact.step = step;
  contact.touching = true;
  contact.force = force;
  contact.stiffness = Mat3::Identity() * stiffness;
  return contact;
}

/// Numbers without a library's generator: the same on every machine.
struct Noise {
  std::uint64_t state = 1;
  double operator()() {  // [1] in [-1, 1)
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state >> 11) / 4503599627370496.0 - 1.0;
  }
  Vec3 vector() { return {(*this)(), (*this)(), (*this)()}; }
};

}  // namespace halsted::haptics
