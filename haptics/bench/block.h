#pragma once
/// A slab of tissue to touch through the whole step, without a scene: x and y along it, top at z = 0, tissue below.
#include "haptics/hand_loop.h"
#include "sim/step.h"

namespace halsted::haptics::bench {

struct BlockShape {
  Vec3 size{24e-3, 24e-3, 6e-3};               // [m]
  int nx = 8, ny = 8, nz = 3;                  // cells
  double youngsModulus = 1e6;                  // [Pa] bowel past its toe
  double friction = 0.2;                       // [1] of steel on it
  bool sheet = false;                          // held at its edges with nothing below; else it stands on its bottom
};

Model blockModel(const BlockShape&);
Pose farAway();                                // a tool that touches nothing

/// Both hands' share of one step; the tools are closed jaws that point down.
struct BlockStep {
  explicit BlockStep(const Model&, const std::array<Pose, kHands>& start);
  LocalContact step(const ToolSample& sample, double dt);          // [s] the left hand alone: an environment for a rig
  void stepBoth();

  const Model& model;
  State state;
  StepInput input;
  StepOutput output;
};

/// Closed jaws whose end is `gap` [m] above the slab.
Pose above(double x, double y, double gap);    // [m]

}  // namespace halsted::haptics::bench
