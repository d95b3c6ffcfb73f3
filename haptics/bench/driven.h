#pragma once
/// The tick round a device that nothing can stop: it goes where the test puts it, whatever force it is told.
#include "haptics/hand_loop.h"

namespace halsted::haptics::bench {

class DrivenDevice final : public Device {
 public:
  DeviceReading read(double) noexcept override { return reading; }                    // [s]
  bool write(const Vec3& force) noexcept override { return written = force, true; }   // [N]
  DeviceLimits limits() const noexcept override { return able; }
  const char* kind() const noexcept override { return "driven"; }

  DeviceReading reading;
  DeviceLimits able;
  Vec3 written = Vec3::Zero();                 // [N] last force
};

struct DrivenRig {
  DrivenRig() { state.limits.ramp = 1.0; }     // engaged: what is measured is not the ramp of a new session

  const Vec3& tickAt(const Vec3& position) noexcept {   // [m] -> [N]
    device.reading.pose.position = position;
    tick(device, config, contact, {}, ++index, state, output);
    return output.force;
  }
  template <typename Environment>
  const Vec3& advanceAt(const Vec3& position, Environment& environment, int every = 1) noexcept {   // [m] -> [N]
    tickAt(position);
    if (index % static_cast<std::uint64_t>(every) == 0) {
      contact = environment.step(output.sample, config.period * every);
      contact.step = ++steps;
    }
    return output.force;
  }

  DrivenDevice device;
  HandLoopConfig config;
  HandLoopState state;
  HandLoopOutput output;
  LocalContact contact;
  std::uint64_t index = 0, steps = 0;
};

}  // namespace halsted::haptics::bench
