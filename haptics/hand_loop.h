#pragma once
/// One hand's servo loop: read the device, render force from the newest local model, limit it, write it.
/// Haptic thread; noexcept, bounded, no heap, lock, log or clock. Reports in codes; the recorder formats.
/// Only + - * / and sqrt, so that a scripted hand moves to the same bits on every machine (DESIGN 7).
#include "haptics/coupling.h"
#include "haptics/device.h"
#include "haptics/limits.h"
#include "haptics/passivity.h"
#include "sim/exchange.h"

namespace halsted::haptics {

struct WorkspaceMapping {                      // world = origin.orientation * (scale * device) + origin.position
  Pose origin;                                 // device frame in the world
  double scale = 1.0;                          // [1]
};
Pose toWorld(const WorkspaceMapping&, const Pose& device) noexcept;
Pose toDevice(const WorkspaceMapping&, const Pose& world) noexcept;

struct HandLoopConfig {
  double period = 1e-3;                        // [s]
  WorkspaceMapping mapping;
  double fadeAfter = 50e-3;                    // [s] age of the local model at which the force begins to fade (DESIGN 2)
  double fadeOver = 50e-3;                     // [s] it is zero this much later
  double velocityTime = 4e-3;                  // [s] of the velocity filter: one 0.055 mm count reads as 11 mm/s, and decays
  CouplingCaps caps{0.0, 5.0, 10.0};           // [N/m] [N s/m] [N] stiffness 0: from the device
  double blendStep = 0.040;                    // [N] a tick: the most that replacing the model may change the force
  double blendShare = 0.4;                     // [1] a tick: decay of small offsets, so half is gone in 1.4 ticks
  PassivityConfig passivity;
  LimitConfig limits;
  double rejoinSpeed = 0.1;                    // [m/s] world, of a tool on its way to a hand that came back elsewhere; tuned: slower than any stroke
};

struct HandLoopState {
  Vec3 lastPosition = Vec3::Zero();            // [m] world
  Quat lastOrientation = Quat::Identity();     // world
  Vec3 velocity = Vec3::Zero();                // [m/s] filtered
  Vec3 lastForce = Vec3::Zero();               // [N] sent
  Vec3 lastRendered = Vec3::Zero();            // [N] before the limits
  Vec3 drift = Vec3::Zero();                   // [N] what this tick's motion changes in the force of the model that the last one used
  Vec3 offset = Vec3::Zero();                  // [N] blend that keeps the force continuous when the model is replaced
  Vec3 before = Vec3::Zero();                  // [N] what the model that was replaced in this tick would have shown
  bool replaced = false;                       // in this tick, not by a puncture
  LocalContact model;                          // in use; kept to compare with the one that replaces it
  std::uint64_t lastStep = 0;                  // physics step of the model in use
  std::uint64_t lastTick = 0;                  // index of the last tick
  std::uint64_t ageTicks = 0;                  // of the model in use; it is one tick old when it arrives
  CouplingCaps caps;                           // of this tick's device
  Vec3 passiveForce = Vec3::Zero();            // [N] damping that the observer has asked for
  double observedEnergy = 0.0;                 // [J] passivity observer
  LimitState limits;
  bool modelUsable = true;                     // false: the newest model has a number that is none; force is zero until the next
  Vec3 rejoin = Vec3::Zero();                  // [m] world: from where the hand is to where the tool stayed while the device was away
  bool away = false;                           // the device was gone or silent at the last tick
  bool started = false;
};

struct HandLoopOutput {
  ToolSample sample;
  Vec3 force = Vec3::Zero();                   // [N] world, after limits
  std::uint32_t faults = 0;                    // FaultCode bits, haptics/limits.h
  bool stale = false;
};

/// One tick. `tickIndex` counts periods, so a loop that skipped some shows it here. `target` moves simulated hands only. The force is rendered from `contact` alone.
/// The force is the device's: `scale` magnifies motion, not force, so the hand feels `scale` times the model's stiffness.
void tick(Device&, const HandLoopConfig&, const LocalContact& contact, const HandTarget& target, std::uint64_t tickIndex,
          HandLoopState&, HandLoopOutput&) noexcept;

}  // namespace halsted::haptics
