/// The stiffness that a hand can be shown is the device's, whatever the scene asks for.
#include <cstdio>

#include "haptics/bench/bench.h"
#include "haptics/bench/driven.h"

namespace halsted::haptics::bench {

namespace {

/// Newtons per metre that the hand feels between two depths of a wall, when the device's motion is magnified by `scale`.
double feltStiffness(const DeviceLimits& device, double wall, double scale) {   // [N/m] [1] -> [N/m]
  DrivenRig rig;
  rig.device.able = device;
  rig.config.mapping.scale = scale;
  rig.contact.touching = true;                 // about x = 0
  rig.contact.stiffness = wall * Mat3::Identity();
  const auto at = [&](double depth) {          // [m] of the device -> [N]
    for (int i = 0; i < 40; ++i) {
      ++rig.contact.step;                      // physics goes on, and says the same
      rig.tickAt(Vec3(0.0, -depth, 0.0));
    }
    return rig.output.force.y();
  };
  const double shallow = at(0.2e-3), deep = at(0.4e-3);   // [N]
  return (deep - shallow) / 0.2e-3;
}

}  // namespace

Measurements measureCouplingLimits() {
  const struct { const char* name; DeviceLimits limits; } devices[] = {{"Touch, 1.02 N/mm", {}}, {"Falcon, 3 N/mm", {8.0, 2.5, 3000.0, 0.05e-3}}};
  Measurements all;
  for (const auto& device : devices)
    for (const double scale : {1.0, 1.5})
      for (const double wall : {500.0, 1e5}) {   // [N/m] in the world: soft, and stiffer than any device
        char text[96];
        std::snprintf(text, sizeof text, "%s, scene asks for %.0f N/m, motion x %.1f", device.name, wall, scale);
        const double felt = feltStiffness(device.limits, wall, scale);   // [N/m]
        const bool soft = wall * scale < device.limits.stiffness;
        all.push_back({"stiffness felt", text, felt, "N/m", soft ? Bound::kAtLeast : Bound::kAtMost,
                       soft ? 0.99 * wall * scale : 2.001 * device.limits.stiffness});
      }
  return all;
}

}  // namespace halsted::haptics::bench
