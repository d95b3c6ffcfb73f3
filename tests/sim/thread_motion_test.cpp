/// The thread in motion: free fall, momentum, energy, rest (physics.md V1).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/strand_rig.h"

namespace halsted {
namespace {

const Vec3 kGravity(0, -9.81, 0);              // [m/s^2]

/// V1: every node and the needle fall by g h^2 n (n + 1) / 2.
TEST(ThreadMotion, FallsFreelyAsSymplecticEulerDoes) {
  SimParams p = threadParams(175, 0.348);
  p.gravity = kGravity;
  StrandRig rig(p);
  const StrandState start = rig.state;
  const int n = 300;
  ASSERT_TRUE(rig.run(n));
  const double fall = 0.5 * 9.81 * rig.dt * rig.dt * n * (n + 1);              // [m]
  double worst = 0.0;                            // [1]
  for (int i = 0; i < rig.model.nodes; ++i)
    worst = std::max(worst, (rig.state.position[i] - start.position[i] - Vec3(0, -fall, 0)).norm() / fall);
  worst = std::max(worst, (rig.state.needle.position - start.needle.position - Vec3(0, -fall, 0)).norm() / fall);
  RecordProperty("relative_error", std::to_string(worst * 1e9) + "e-9");
  EXPECT_LT(worst, 1e-9);
}

/// Sets a tumbling, bending motion going.
void shake(StrandRig& rig) {
  for (int i = 0; i < rig.model.nodes; ++i) rig.state.velocity[i] = 0.2 * Vec3(std::sin(0.1 * i), std::cos(0.3 * i), std::sin(0.7 * i + 1.0));
  rig.state.needleVelocity = Vec3(0.1, -0.2, 0.05);
  rig.state.needleSpin = Vec3(3.0, -2.0, 5.0);
}

TEST(ThreadMotion, ConservesLinearMomentum) {
  StrandRig rig(threadParams(100, 0.198));
  shake(rig);
  const Vec3 before = rig.momentum();
  double scale = 0.0;                            // [kg m/s]
  for (int i = 0; i < rig.model.nodes; ++i) scale += rig.model.mass[i] * rig.state.velocity[i].norm();
  ASSERT_TRUE(rig.run(1000));
  RecordProperty("relative_drift", std::to_string((rig.momentum() - before).norm() / scale * 1e9) + "e-9");
  EXPECT_LT((rig.momentum() - before).norm(), 1e-6 * scale);
}

/// Largest energy over the start in `steps` steps [J].
double gained(StrandRig& rig, int steps) {
  const double start = rig.energy();             // [J]
  double most = 0.0;                             // [J]
  for (int k = 0; k < steps; ++k) {
    EXPECT_TRUE(rig.step());
    most = std::max(most, rig.energy() - start);
  }
  return most;
}

TEST(ThreadMotion, APendulumNeverGainsEnergy) {
  SimParams p = threadParams(60, 0.118);
  p.gravity = kGravity;
  StrandRig rig(p);
  rig.layStraight(Vec3(1, 0, 0));
  rig.hold(0.0);                                 // the needle is the bob
  const double scale = rig.model.needleMass * 9.81 * rig.model.length;         // [J]
  const double gain = gained(rig, 1000);         // [J]
  RecordProperty("gain_over_scale", std::to_string(gain / scale));
  EXPECT_LT(gain, 0.01 * scale);
}

TEST(ThreadMotion, AShakenThreadNeverGainsEnergy) {
  StrandRig rig(threadParams(100, 0.198));
  shake(rig);
  const double scale = rig.kinetic();            // [J]
  const double gain = gained(rig, 1000);         // [J]
  RecordProperty("gain_over_scale", std::to_string(gain / scale));
  EXPECT_LT(gain, 0.01 * scale);
}

class BentAtTheNeedle : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Weight, BentAtTheNeedle, testing::Values(0.0, 9.81));

TEST_P(BentAtTheNeedle, ReleaseFromARightAngleNeverGainsEnergy) {
  SimParams p = threadParams(60, 0.118);
  p.gravity = Vec3(0, -GetParam(), 0);
  StrandRig rig(p);
  rig.clampNeedle();
  rig.layStraight(Vec3(1, 0, 0));                // the crimp points along -y
  const double scale = std::max(rig.elastic(), 17.0 * rig.model.mass[1] * GetParam() * rig.model.length);   // [J]
  const double gain = gained(rig, 1000);         // [J]
  RecordProperty("gain_over_scale", std::to_string(gain / scale));
  EXPECT_LT(gain, 0.01 * scale);
}

TEST(ThreadMotion, AHangingThreadComesToRest) {
  SimParams p = threadParams(175, 0.348);
  p.thread.damping = ThreadParams{}.damping;
  p.gravity = kGravity;
  StrandRig rig(p);
  rig.clampNeedle();
  rig.layStraight(Vec3(std::sqrt(0.5), -std::sqrt(0.5), 0));
  ASSERT_TRUE(rig.run(6000));
  RecordProperty("speed", std::to_string(rig.fastest()));
  EXPECT_LT(rig.fastest(), 1e-4);
  EXPECT_NEAR(rig.state.position.front().x(), rig.state.position.back().x(), 1e-3);
}

/// The tail is dragged to and fro at 1 m/s, ten times a second.
TEST(ThreadMotion, AWhippedThreadKeepsItsLength) {
  SimParams p = threadParams(175, 0.348);
  p.gravity = kGravity;
  StrandRig rig(p);
  rig.clampNeedle();
  const std::size_t end = rig.hold(0.0, 1e3 * Mat3::Identity());
  const Vec3 home = rig.held[end].anchor + Vec3(0.05, 0.08, 0.0);              // slack, so that nothing is torn taut
  rig.held[end].anchor = home;
  for (int i = 0; i < rig.model.nodes; ++i) rig.state.position[i].x() += 1e-4 * std::sin(0.2 * i);
  double worst = 0.0;                            // [1]
  for (int k = 0; k < 2000; ++k) {
    const double omega = 62.8, reach = 1.0 / omega;                            // [rad/s], [m]
    rig.held[end].anchor = home + reach * Vec3(std::sin(omega * k * rig.dt), 0.0, std::cos(omega * k * rig.dt));
    ASSERT_TRUE(rig.step());
    ASSERT_TRUE(rig.finite());
    if (k > 100) worst = std::max(worst, std::fabs(rig.length() / rig.model.length - 1.0));
  }
  RecordProperty("length_error", std::to_string(worst));
  EXPECT_LT(worst, 1e-3);
}

}  // namespace
}  // namespace halsted
