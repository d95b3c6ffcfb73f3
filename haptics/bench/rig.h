#pragma once
/// A hand, a device, the shipped tick and something to touch, in virtual time: each advance() is one haptic period followed by one
/// step of the environment, as in lockstep. The environments are closed-form or three lines of physics, so that laws have answers.
#include <array>
#include <vector>

#include "haptics/hand_loop.h"
#include "haptics/virtual_device.h"

namespace halsted::haptics::bench {

/// The half-space y < 0, elastic: F = -stiffness y - damping vy below the surface.
struct SpringWall {
  double stiffness = 1000.0;                   // [N/m]
  double damping = 0.0;                        // [N s/m]
  double lookAhead = 0.0;                      // [m] above the surface from which the plane is published

  LocalContact step(const ToolSample& sample, double) const;       // dt [s]
};

/// Soft tissue below y = 0 as one damped mass on a spring, touched through a coupling spring and damper as the simulator does it.
/// The force that the hand feels is the coupling's; its local stiffness is coupling and tissue in series.
struct SoftTissue {
  double mass = 2e-3;                          // [kg]
  double stiffness = 300.0;                    // [N/m]
  double damping = 1.0;                        // [N s/m]
  double coupling = 1000.0;                    // [N/m]
  double couplingDamping = 0.5;                // [N s/m]
  double y = 0.0, velocity = 0.0;              // [m] [m/s] surface

  LocalContact step(const ToolSample& sample, double dt);          // [s]
};

struct Rig {
  explicit Rig(const TouchDynamics& touch = {}, const HandDynamics& hand = {}, const Pose& start = {})
      : device(start, touch, hand) { target.pose = start; target.valid = true; }

  /// The tick alone: the model grows older.
  void tickOnly() noexcept;
  /// The tick, then one step of the environment; its model arrives `delay` periods late, and only every `every` ticks.
  template <typename Environment>
  void advance(Environment& environment) noexcept {
    tickOnly();
    if (index % static_cast<std::uint64_t>(every) != 0) return;
    LocalContact fresh = environment.step(output.sample, config.period * every);
    fresh.step = ++steps;
    const int slot = static_cast<int>(steps % kLine);
    line[slot] = fresh;
    if (steps > static_cast<std::uint64_t>(delay)) contact = line[static_cast<int>((steps - delay) % kLine)];
  }

  static constexpr int kLine = 32;             // longest delay that the line holds

  VirtualDevice device;
  HandLoopConfig config;
  HandLoopState state;
  HandLoopOutput output;
  LocalContact contact;
  HandTarget target;
  LocalContact line[kLine];
  std::uint64_t index = 0, steps = 0;
  int delay = 0;                               // environment steps that the model comes late
  int forceDelay = 0;                          // ticks that the force comes late at the motors; below kLine
  Vec3 held = Vec3::Zero();                    // [N] device frame: what the motors hold now
  std::array<Vec3, kLine> lateForces = zeroVectors<kLine>();       // [N] on their way to the motors
  int every = 1;                               // ticks per environment step
  double energyTaken = 0.0;                    // [J] by the rendered force from the hand: - sum F dx, exact for a held force
  double leastEnergy = 0.0;                    // [J] its minimum
  double largestStep = 0.0;                    // [N] largest change of force in one tick
  double peak = 0.0;                           // [N] largest force
};

/// RMS of what passes a second-order 30 Hz Butterworth high-pass, over the values after the first `skip`.
double rmsAbove30Hz(const std::vector<double>& values, double rate, std::size_t skip);   // [N] [Hz] -> [N]

}  // namespace halsted::haptics::bench
