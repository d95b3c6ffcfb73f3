#pragma once
/// A needle on a ball with three exact layers: concentric spheres are harmonics of order one. The needle comes down on its top.
#include <cmath>

#include "sim/needling/needling.h"

namespace halsted::testing {

inline constexpr double kBall = 0.2;           // [m] radius of the skin

inline HarmonicSurface ball(double radius, int order = 1) {   // radius [m]
  std::vector<Vec3> c(harmonicCount(order), Vec3::Zero());
  const double k = radius * std::sqrt(4.0 * 3.14159265358979323846 / 3.0);   // [m]
  c[harmonicIndex(1, 1)] = Vec3(k, 0, 0);
  c[harmonicIndex(1, -1)] = Vec3(0, k, 0);
  c[harmonicIndex(1, 0)] = Vec3(0, 0, k);
  return harmonicSurface(order, c);
}

inline NeedlingModel ballModel(const NeedlingParams& p = {}, int order = 1) {
  const double fat = p.layers[0].thickness, muscle = fat + p.layers[1].thickness;   // [m]
  return needlingModel(p, {ball(kBall, order), ball(kBall - fat, order), ball(kBall - muscle, order)});
}

/// Drives the tip; velocities are those of the path.
struct NeedlingRig {
  NeedlingModel model;
  NeedlingState state;
  NeedlingOutput out;
  NeedlingInput input;
  double work = 0.0;                           // [J] done by the hand on the needle
  Vec3 lastForce = Vec3::Zero();               // [N]

  explicit NeedlingRig(const NeedlingParams& p = {}, int order = 1) : model(ballModel(p, order)), state(needlingState(model)) {
    input.needle.pose.position = Vec3(0, 0, kBall + 5e-3);
    input.finger.pose.position = Vec3(0.3, 0, 0.3);
  }
  void to(const Vec3& tip) {                   // one step
    const Vec3 moved = tip - input.needle.pose.position;
    input.needle.velocity = moved / model.params.dt;
    input.needle.pose.position = tip;
    lastForce = out.needle.force;
    stepNeedling(model, input, state, out);
    work -= 0.5 * (lastForce + out.needle.force).dot(moved);
  }
  void depth(double d) { to(Vec3(0, 0, kBall - d)); }   // [m] below the skin at rest
  /// Straight to a depth at a speed [m/s].
  template <class Each> void go(double target, double speed, const Each& each) {   // target [m], speed [m/s]
    double now = kBall - input.needle.pose.position.z();   // [m]
    const double stride = speed * model.params.dt;         // [m]
    while (now != target) {
      now = std::abs(target - now) <= stride ? target : now + (target > now ? stride : -stride);
      depth(now);
      each();
    }
  }
  void go(double target, double speed) { go(target, speed, [] {}); }
  void wait(double seconds) { for (int k = 0; k * model.params.dt < seconds; ++k) to(input.needle.pose.position); }   // [s]
  double up() const { return out.needle.force.z(); }       // [N] on the hand
  /// Turns the needle by an angle in this many steps, standing still.  angle [rad]
  void twirl(double angle, int steps) {
    for (int k = 0; k < steps; ++k) {
      const double half = 0.5 * angle / steps;             // [rad]
      input.needle.pose.orientation = (Quat(std::cos(half), 0, 0, -std::sin(half)) * input.needle.pose.orientation).normalized();
      to(input.needle.pose.position);
    }
  }
};

}  // namespace halsted::testing
