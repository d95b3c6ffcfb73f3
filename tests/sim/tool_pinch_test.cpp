/// A strand of thread between a tool and the wall, and a tool pushed deep into the wall: pressed steadily, everything comes to rest.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/sim/kinetic_energy.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

constexpr double kThreadRadius = 0.16e-3;      // [m]

/// The tool before the face x = 4 mm, `gap` [m] from it: standing on it with its tip, or lying along z, across the thread.
enum class Way { kStanding, kAcrossThread };
Pose atWall(Way way, double gap) {             // [m]
  const double r = way == Way::kStanding ? 1.2e-3 : 2.4e-3;   // [m] jaws' end, or their sides when they lie
  const Vec3 at(kWallX + r + gap, 12e-3, way == Way::kAcrossThread ? -8e-3 : 11e-3);
  return way == Way::kStanding ? frame(at, Vec3::UnitY(), Vec3::UnitZ()) : frame(at, Vec3::UnitX(), Vec3::UnitY());
}

/// Needle behind the wall's end, thread straight along -y just before the face.
Pose needleForThread(const SimParams& p) {
  const double r = p.needle.arcLength / p.needle.arcAngle;    // [m]
  return {Vec3(kWallX + kThreadRadius + 0.1e-3 - r, 72e-3, 11e-3), Quat::Identity()};
}

struct Steady {
  double mean = 0.0, ripple = 0.0;             // [N] force on the hand; RMS about it
  double early = 0.0, late = 0.0;              // [J] kinetic energy of tissue and thread, mean over the first and the last half
  double most = 0.0;                           // [N] largest force on the hand ever
  bool finite = true;
};

/// Comes from 12 mm, presses `depth` [m] deep into where the wall was, holds for two seconds.
Steady pressAndHold(SimParams p, Way way, double depth, bool thread) {
  StepRig rig(p, thread ? needleForThread(p) : kNeedleAway, atWall(way, 12e-3));
  rig.input.tools[kLeft].jaw = 0.0;
  rig.run(5);
  Steady r;
  const int steps = static_cast<int>((12e-3 + depth) / 5e-5);
  for (int k = 1; k <= steps; ++k) {
    rig.input.tools[kLeft].pose = atWall(way, 12e-3 - 5e-5 * k);
    rig.step();
    r.most = std::max(r.most, rig.state.tools[kLeft].force.norm());
  }
  rig.run(1000);
  double squares = 0.0;                        // [N^2]
  Vec3 sum = Vec3::Zero();
  constexpr int kHold = 1000;                  // steps
  for (int k = 0; k < kHold; ++k) {
    rig.step();
    const Vec3 f = rig.state.tools[kLeft].force;
    sum += f;
    squares += f.squaredNorm();
    r.most = std::max(r.most, f.norm());
    (2 * k < kHold ? r.early : r.late) += 2.0 * kineticEnergy(rig.model, rig.state) / kHold;
  }
  r.finite = rig.finite();
  r.mean = (sum / kHold).norm();
  r.ripple = std::sqrt(std::max(0.0, squares / kHold - r.mean * r.mean));
  std::printf("way %d, depth %.1f mm, thread %d, E %.0f kPa: %.3f N, ripple %.4f N, kinetic %.2e then %.2e J, most %.2f N, holes %d\n",
              static_cast<int>(way), depth * 1e3, thread, p.tissue.youngsModulus * 1e-3, r.mean, r.ripple, r.early, r.late, r.most,
              rig.state.strand.holeCount);
  return r;
}

void expectSteady(const Steady& r, double depth) {   // [m]
  EXPECT_TRUE(r.finite);
  EXPECT_GT(r.mean, 0.02);
  EXPECT_LT(r.ripple, 0.03 * r.mean + 1e-3);
  EXPECT_LT(r.late, 1.5 * r.early + 1e-10);
  EXPECT_LT(r.most, 1000.0 * depth + 0.1) << "the coupling bounds the force";
}

SimParams bowel() {
  SimParams p = wallParams();
  p.tissue.youngsModulus = 120e3;
  return p;
}

TEST(ToolPinch, ThreadBetweenToolAndWallComesToRest) {
  for (const SimParams& p : {wallParams(), bowel()})
    for (const Way way : {Way::kStanding, Way::kAcrossThread})
      for (const double depth : {1.5e-3, 3e-3}) expectSteady(pressAndHold(p, way, depth, true), depth);
}

TEST(ToolPinch, AToolPushedDeepIntoTheWallComesToRest) {
  for (const SimParams& p : {wallParams(), bowel()}) {
    for (const double depth : {2e-3, 5e-3}) expectSteady(pressAndHold(p, Way::kStanding, depth, false), depth);
    for (const double depth : {2e-3, 5e-3, 10e-3}) expectSteady(pressAndHold(p, Way::kAcrossThread, depth, false), depth);
  }
}

/// Sent 12 mm into a wall, and back again.
TEST(HandForce, IsAllThatAHandPushesWith) {
  SimParams p = wallParams();
  p.tools[kLeft].handForce = 1.0;
  StepRig rig(p, kNeedleAway, atWall(Way::kAcrossThread, 1e-3));
  rig.input.tools[kLeft].jaw = 0.0;
  double most = 0.0, least = 1e9;              // [N] ever; while it gives way
  const auto move = [&](double from, double to) {                // [m]
    for (int k = 0; k <= 260; ++k) {
      rig.input.tools[kLeft].pose = atWall(Way::kAcrossThread, from + (to - from) * k / 260);
      rig.step();
      most = std::max(most, rig.state.tools[kLeft].force.norm());
    }
  };
  move(1e-3, -12e-3);
  for (int k = 0; k < 500; ++k) {
    rig.step();
    least = std::min(least, rig.state.tools[kLeft].force.norm());
  }
  EXPECT_LT(most, 1.05);                       // [N] 12 of a hand that does not give way
  EXPECT_GT(least, 0.95);                      // [N] it goes on pushing
  move(-12e-3, 1e-3);
  EXPECT_EQ(rig.state.tools[kLeft].proxy.position, rig.input.tools[kLeft].pose.position) << "and is where the hand is once nothing holds it back";
}

TEST(HandForce, ChangesNoBitOfAHandThatPushesWithLess) {
  SimParams p = bowel();
  p.tools[kLeft].handForce = 20.0;
  const Steady some = pressAndHold(p, Way::kAcrossThread, 5e-3, true);
  p.tools[kLeft].handForce = 1e4;
  const Steady any = pressAndHold(p, Way::kAcrossThread, 5e-3, true);
  EXPECT_EQ(some.mean, any.mean);
  EXPECT_EQ(some.most, any.most);
}

}  // namespace
}  // namespace halsted
