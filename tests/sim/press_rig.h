#pragma once
/// The left tool comes with closed jaws at a face of the wall of step_rig.h.
#include "tests/sim/step_rig.h"

namespace halsted {

/// Closed jaws, shaft along +x: the tool comes at the face x = 4 mm between mesh lines.
inline Pose pressing(double gap, double aside = 0.0) {  // [m] from the jaws' surface to the face, and along y
  return frame(Vec3(kWallX + 1.2e-3 + gap, 12e-3 + aside, 11e-3), Vec3::UnitY(), Vec3::UnitZ());
}

struct Press : StepRig {
  explicit Press(const SimParams& params = wallParams()) : StepRig(params, kNeedleAway, pressing(20e-3)) {
    input.tools[kLeft].jaw = 0.0;
    run(2);
  }
  void to(const Pose& pose) { input.tools[kLeft].pose = pose; step(); }
  const ToolState& tool() const { return state.tools[kLeft]; }
  Vec3 onTissue() const {                        // [N]
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i < tool().contactCount; ++i) sum += tool().contactForce[i];
    return sum;
  }
  /// What the foot holds the wall with: the elastic energy's slope against a shift of all free particles.  [N]
  Vec3 footReaction() const {
    std::vector<bool> fixed(model.mesh.vertices.size(), false);
    for (int v : model.mesh.fixed) fixed[v] = true;
    const double shift = 1e-8;                   // [m]
    Vec3 force;
    for (int axis = 0; axis < 3; ++axis) {
      double energy[2];                          // [J]
      for (int side = 0; side < 2; ++side) {
        TissueState moved = state.tissue;
        for (std::size_t i = 0; i < fixed.size(); ++i)
          if (!fixed[i]) moved.position[i][axis] += side ? shift : -shift;
        energy[side] = elasticEnergy(model.tissue, moved);
      }
      force[axis] = (energy[1] - energy[0]) / (2.0 * shift);
    }
    return force;
  }
};

}  // namespace halsted
