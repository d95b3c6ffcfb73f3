#pragma once
/// Where the energy of the tissue comes from: what it has more than hands, thread and gravity have given it was created.
#include <vector>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted::app {

/// Motion and elasticity of the tissue against the work done on it. A tool's work is reckoned by the motion of the tool and of its jaws, not of the
/// tissue that it touches, and that of tissue against tissue not at all: what a contact adds of its own is created. Dissipation only lowers the balance.
/// Not seen: what contacts add in a step in which the tool springs farther than a millimetre, where the tissue's own motion counts.
class EnergyAudit {
 public:
  void before(const State&);
  void after(const Model&, const State&);
  double created() const { return created_; }  // [J] the balance's largest rise
  double most() const { return most_; }        // [J] of motion and elasticity

 private:
  std::vector<Vec3> position_, force_;         // [m] before the step; [N] of thread and gravity
  std::array<Pose, kHands> tool_;
  std::array<double, kHands> jaw_;             // [1]
  std::array<Pose, kMostClamps> clamp_;
  double work_ = 0.0, least_ = 1e300, created_ = 0.0, most_ = 0.0;   // [J]
  int sinceLook_ = 0;                          // steps
};

}  // namespace halsted::app
