/// What holds, drags and winds a needle: rest, dissipation, grasp.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/needling/shaft.h"

namespace halsted {
namespace {

constexpr double kTurn = 6.28318530717958648;   // [rad]

TEST(ShaftFriction, HoldsAtRestAndBreaksAwayAboveTheSlidingForce) {
  const NeedlingParams p;
  ShaftFriction f;
  const double bound = 0.2, stride = 1e-6;     // [N], [m]: twice the speed below which the shaft counts as still
  for (int k = 0; k < 200; ++k) slideShaft(p, stride, {bound, 0.0}, f);
  const double held = f.force;                 // [N]
  EXPECT_GT(held, 0.0);
  for (int k = 0; k < 5000; ++k) slideShaft(p, 0.0, {bound, 0.0}, f);
  EXPECT_EQ(f.force, held);                    // for ever
  double peak = 0.0;                           // [N]
  for (int k = 0; k < 5000; ++k) { slideShaft(p, stride, {bound, 0.0}, f); peak = std::max(peak, f.force); }
  EXPECT_NEAR(peak, p.staticRatio * bound, 0.01 * bound);
  EXPECT_NEAR(f.force, bound, 1e-9);
}

TEST(ShaftFriction, AtASteadySpeedIsCoulombPlusViscous) {   // Okamura 2004, Son 2014: C + b v, either way
  const NeedlingParams p;
  for (double speed : {0.01, -0.01, 0.05}) {   // [m/s]
    ShaftFriction f;
    for (int k = 0; k < 3000; ++k) slideShaft(p, speed * p.dt, {0.2, 40.0}, f);
    EXPECT_NEAR(f.force, (speed > 0.0 ? 0.2 : -0.2) + 40.0 * speed, 1e-9);
    EXPECT_NEAR(f.drag, 40.0 * speed, 1e-9);
  }
}

TEST(ShaftFriction, ViscousPartDoesNotDependOnTheStep) {
  std::vector<double> force;                   // [N] while it builds up
  for (double dt : {1e-3, 0.125e-3}) {
    NeedlingParams p;
    p.dt = dt;
    ShaftFriction f;
    for (int k = 0; k * dt < 0.1; ++k) slideShaft(p, 0.01 * dt, {0.05, 40.0}, f);
    force.push_back(f.force);
  }
  EXPECT_NEAR(force[0], force[1], 0.01 * force[1]);
}

class FrictionCycles : public ::testing::TestWithParam<double> {};   // viscous part [N s/m]

TEST_P(FrictionCycles, HaveNoJumpAndPayForEveryCycle) {
  const NeedlingParams p;
  for (double amplitude : {0.1e-3, 1e-3, 5e-3}) {   // [m]
    ShaftFriction f;
    double work = 0.0, jump = 0.0, x = 0.0;    // [J], [N], [m]
    const int steps = 500;
    for (int k = 1; k <= 4 * steps; ++k) {
      const double next = amplitude * std::sin(kTurn * k / steps), before = f.force;   // [m], [N]
      slideShaft(p, next - x, {0.2, GetParam()}, f);
      work += 0.5 * (before + f.force) * (next - x);
      // What drag carries flows off while the hand turns, no faster than the hand ever was.
      const double flow = GetParam() > 0.0 ? amplitude * kTurn / steps : 0.0;   // [m]
      jump = std::max(jump, std::abs(f.force - before) / std::max(std::abs(next - x) + flow, 1e-9));
      x = next;
    }
    EXPECT_GE(work, -1e-12) << amplitude;
    EXPECT_LE(jump, 1.001 * p.shaftStiffness) << amplitude;
    if (amplitude > 1e-3) { EXPECT_GT(work, 4 * 2 * 0.2 * amplitude); }
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutDrag, FrictionCycles, ::testing::Values(0.0, 5.0, 40.0));

TEST(TipCut, ResistsNewTissueOnly) {
  const NeedlingParams p;
  TipCut t;
  for (int k = 0; k <= 1000; ++k) advanceTip(p, 1e-5 * k, 0.05, t);
  EXPECT_NEAR(t.force, 0.05, 1e-12);
  for (int k = 1000; k >= 500; --k) advanceTip(p, 1e-5 * k, 0.05, t);
  EXPECT_EQ(t.force, 0.0);
  for (int k = 500; k <= 990; ++k) advanceTip(p, 1e-5 * k, 0.05, t);
  EXPECT_EQ(t.force, 0.0);                     // the track is there already
}

TEST(Winding, TorqueGrowsWithTheAngleAsMeasured) {   // Han 2015: 60 degrees 0.023 N mm, 180 degrees 0.292 N mm
  const NeedlingParams p;
  for (const auto& [degrees, expected] : {std::pair{60.0, 0.023e-3}, {180.0, 0.292e-3}}) {
    Winding w;
    windShaft(p, 0.0, p.windLength, w);
    for (int k = 0; k < 1000; ++k) windShaft(p, degrees / 360.0 * kTurn / 1000, p.windLength, w);
    windShaft(p, 0.0, p.windLength, w);        // standing still: without the part that grows with speed
    EXPECT_NEAR(-w.torque / expected, 1.0, 0.03) << degrees;
  }
}

double graspAfter(bool oneWay) {
  const NeedlingParams p;
  Winding w;
  windShaft(p, 0.0, 20e-3, w);
  for (int k = 0; k < 16'000; ++k) {           // 16 turns in 16 s, as Langevin 2001; back and forth by half a turn
    const bool forward = oneWay || (k / 500) % 2 == 0;
    windShaft(p, (forward ? 1.0 : -1.0) * kTurn / 1000, 20e-3, w);
  }
  return w.grasp;
}

TEST(Winding, GraspGrowsWithRotationAsMeasured) {   // Langevin 2001: pull-out + 167 % one way, + 52 % both ways
  EXPECT_NEAR(graspAfter(true), 2.67, 0.05);
  EXPECT_NEAR(graspAfter(false), 1.52, 0.08);
}

TEST(Winding, GivesBackNoMoreThanWasPutIn) {
  const NeedlingParams p;
  Winding w;
  double work = 0.0, angle = 0.0, length = 5e-3;   // [J], [rad], [m]
  windShaft(p, 0.0, length, w);
  for (int k = 1; k <= 20'000; ++k) {          // twirled by several turns while it goes in and out
    const double next = 9.0 * std::sin(kTurn * k / 4000.0), turn = next - angle, before = w.torque;   // [rad], [N m]
    length = 12e-3 + 7e-3 * std::sin(kTurn * k / 20'000.0 - 1.5707963);
    windShaft(p, turn, length, w);
    work -= 0.5 * (before + w.torque) * turn;
    angle = next;
  }
  EXPECT_GT(work, 0.0);
  EXPECT_LE(w.grasp, p.graspMost);
}

}  // namespace
}  // namespace halsted
