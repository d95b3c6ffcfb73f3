#pragma once
/// A hand that presses the standing wall of tests/sim/step_rig.h through the whole loop: device, haptic tick, physics step.
#include <algorithm>
#include <vector>

#include "tests/haptics/press_release.h"
#include "tests/sim/step_rig.h"

namespace halsted::haptics {

inline constexpr double kFace = kWallX + 1.2e-3;   // [m] x of the device when the jaws' end touches the wall

/// Closed jaws at height `z` [m], `gap` [m] before the face x = 4 mm: the shaft stands on the face, or lies along it and over its end.
inline Pose beforeWall(double gap, double z = 11e-3, bool flat = false, double y = 12e-3) {   // y [m]
  const Vec3 at(kFace + gap, y, z);
  return flat ? frame(at, Vec3::UnitZ(), Vec3::UnitX()) : frame(at, Vec3::UnitY(), Vec3::UnitZ());
}

/// The physics step as an environment of the bench rig.
struct WallStep {
  StepRig rig;
  WallStep(const SimParams& p, const Pose& start) : rig(p, kNeedleAway, start) {
    rig.input.tools[kLeft].jaw = 0.0;
  }
  LocalContact step(const ToolSample& sample, double) {         // [s]
    rig.input.tools[kLeft] = sample;
    rig.input.tools[kLeft].jaw = 0.0;
    rig.step();
    return rig.out.contact[kLeft];
  }
};

struct WallPress {
  HandDynamics hand;                           // the default is a pen grip
  double speed = 0.05;                         // [m/s]
  double depth = 2e-3;                         // [m]
  int delay = 0;                               // steps
  double height = 11e-3;                       // [m] above the foot
  double along = 12e-3;                        // [m] from the wall's end; its other end is at 24 mm
  bool flat = false;                           // the shaft lies along the wall
  bool slidesOff = false;                      // the tool is expected to leave an edge while it is held
  double hold = 2.0;                           // [s]
  Pose at(double gap) const { return beforeWall(gap, height, flat, along); }   // [m]
};

struct WallResult {
  double leastEnergy = 0.0, energyTaken = 0.0; // [J]
  double replaced = 0.0;                       // [N] largest change of force by a new model in the tick that takes it
  double buzz = 0.0;                           // [N] RMS above 30 Hz of the second half of the hold
  double steady = 0.0, peak = 0.0;             // [N]
  double otherHand = 0.0;                      // [N] largest force of the other hand
};

inline WallResult pressWall(const SimParams& p, const WallPress& press) {
  WallStep wall(p, press.at(10e-3));
  HandDynamics hand = press.hand;
  hand.maxSpeed = press.speed;
  Rig rig(TouchDynamics{}, hand, press.at(10e-3));
  rig.delay = press.delay;
  WallResult result;
  std::vector<double> forces;                  // [N]
  LocalContact used;
  const auto advance = [&] {
    Rig twin = rig;                            // the same tick, had the model not been replaced
    twin.contact = used;
    used = rig.contact;
    twin.tickOnly();
    rig.advance(wall);
    if (!used.puncture) result.replaced = std::max(result.replaced, (twin.output.force - rig.output.force).norm());
    result.otherHand = std::max(result.otherHand, wall.rig.out.contact[kRight].force.norm());
    forces.push_back(rig.output.force.x());
  };
  for (int i = 0; i < 200; ++i) advance();
  rig.target.pose = press.at(-press.depth);
  const int held = static_cast<int>(press.hold * 1000.0 + 0.5);
  for (int i = 0; i < held; ++i) advance();
  result.buzz = rmsAbove30Hz(forces, 1000.0, forces.size() - static_cast<std::size_t>(held / 2));
  result.steady = forces.back();
  rig.target.pose = press.at(10e-3);
  for (int i = 0, back = std::max(800, static_cast<int>(1.5 * (10e-3 + press.depth) / press.speed * 1000.0)); i < back; ++i) advance();
  result.leastEnergy = rig.leastEnergy;
  result.energyTaken = rig.energyTaken;
  result.peak = rig.peak;
  return result;
}

}  // namespace halsted::haptics
