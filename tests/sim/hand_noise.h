#pragma once
/// Random but smooth motion of two hands about a place, from its own generator: targets, turns and jaws change a few times a second.
#include "tests/sim/step_rig.h"

namespace halsted {

class HandNoise {
 public:
  explicit HandNoise(std::uint64_t seed, const Vec3& centre = Vec3(2e-3, 12e-3, 14e-3)) : state_(seed), centre_(centre) {}   // [m] of the wall

  void move(StepInput& input) {
    for (int hand = 0; hand < kHands; ++hand) {
      if (left_[hand]-- <= 0) choose(hand);
      ToolSample& s = input.tools[hand];
      ++s.tick;
      const Vec3 way = goal_[hand].position - s.pose.position;
      const double far = way.norm(), pace = 1.5e-4;          // [m] a step: 0.15 m/s
      s.pose.position += far > pace ? Vec3(pace / far * way) : way;
      s.pose.orientation = s.pose.orientation.slerp(0.01, goal_[hand].orientation).normalized();
      s.jaw += 0.02 * (jaw_[hand] - s.jaw);
    }
  }

 private:
  double uniform() {                           // [1] in [-1, 1)
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) * 0x1p-52 - 1.0;
  }
  void choose(int hand) {
    left_[hand] = 150 + static_cast<int>(100.0 * uniform());
    const double z = uniform(), y = uniform(), x = uniform();    // [1] one after the other: a call's arguments are drawn in no fixed order
    goal_[hand].position = centre_ + Vec3(15e-3 * x, 12e-3 * y, 10e-3 * z);
    const double k = uniform(), j = uniform(), i = uniform(), w = uniform();   // [1]
    const Quat q(1.5 + w, i, j, k);
    goal_[hand].orientation = q.normalized();
    jaw_[hand] = uniform() > 0.0 ? 1.0 : 0.0;
  }

  std::uint64_t state_;
  Vec3 centre_;                                // [m]
  std::array<Pose, kHands> goal_;
  std::array<double, kHands> jaw_{1.0, 0.0};   // [1]
  std::array<int, kHands> left_{0, 0};
};

/// The needle begins beside the wall, so that random motion soon presses, stabs, grasps and tangles.
inline const Pose kNeedleBeside{Vec3(25e-3, 12e-3, 20e-3), Quat::Identity()};

}  // namespace halsted
