/// Law S7 and what a needle feels: dimple, puncture, layers, hold, withdrawal, springback.
#include <gtest/gtest.h>

#include "tests/sim/needling/needling_rig.h"
#include "tests/support/realtime_guard.h"

namespace halsted {
namespace {

using halsted::testing::kBall;
using halsted::testing::NeedlingRig;

TEST(Needling, NothingIsFeltAboveTheSkin) {
  NeedlingRig rig;
  rig.depth(-2e-3);
  EXPECT_EQ(rig.out.needle.force, Vec3(Vec3::Zero()));
  EXPECT_TRUE(rig.out.needle.ahead);
  EXPECT_NEAR(rig.out.needle.planes[0].point.z(), kBall, 1e-9);
}

TEST(Needling, SkinDimplesByEquationSixThenGivesWay) {
  NeedlingRig rig;
  rig.go(0.0, 2e-3);
  double peak = 0.0;                           // [N]
  while (rig.out.punctured < 0) {
    const double d = kBall - rig.input.needle.pose.position.z() + 2e-6;   // [m]
    rig.depth(d);
    if (rig.out.punctured < 0) {
      EXPECT_NEAR(rig.up(), netForce(rig.model.net[0], d), 1e-9);
      EXPECT_NEAR(dimple(rig.state, 0), d, 1e-12);
      peak = rig.up();
    }
  }
  EXPECT_NEAR(peak, rig.model.params.layers[0].punctureForce, 2e-3);
}

/// Largest change of force in a step that was no puncture, and the jumps at the punctures against the surface term before them.
void expectContinuous(NeedlingRig& rig, double target, double speed) {   // target [m], speed [m/s]
  const double allowed = 3000.0 * speed * rig.model.params.dt + 2e-3;    // [N] stiffest spring, and what springback lays on the shaft
  Vec3 before = rig.out.needle.force;
  double surface = rig.out.surfaceForce;       // [N]
  rig.go(target, speed, [&] {
    const double change = (rig.out.needle.force - before).norm();              // [N]
    if (rig.out.punctured >= 0) EXPECT_NEAR(change, surface, allowed) << "layer " << rig.out.punctured;
    else EXPECT_LT(change, allowed) << "at " << kBall - rig.input.needle.pose.position.z();
    before = rig.out.needle.force;
    surface = rig.out.surfaceForce;
  });
}

TEST(Needling, ForceJumpsOnlyAtPuncturesAndThereByTheSurfaceTerm) {
  NeedlingRig rig;
  rig.go(-0.1e-3, 10e-3);
  expectContinuous(rig, 25e-3, 1e-3);
  for (const LayerState& l : rig.state.layers) EXPECT_EQ(l.phase, LayerPhase::kPunctured);
  expectContinuous(rig, -2e-3, 1e-3);          // and out again
  EXPECT_EQ(rig.state.layers[0].phase, LayerPhase::kFree);
}

TEST(Needling, EachLayerIsPuncturedInTurn) {
  NeedlingRig rig;
  std::vector<std::pair<int, double>> seen;    // layer, depth [m]
  rig.go(25e-3, 5e-3, [&] { if (rig.out.punctured >= 0) seen.push_back({rig.out.punctured, kBall - rig.input.needle.pose.position.z()}); });
  ASSERT_EQ(seen.size(), 3u);
  double top = 0.0;                            // [m]
  for (int k = 0; k < kLayers; ++k) {
    EXPECT_EQ(seen[k].first, k);
    EXPECT_NEAR(seen[k].second, top + rig.model.net[k].punctureDepth, 10e-6);
    top += rig.model.params.layers[k].thickness;
  }
}

TEST(Needling, DampingIsThatOfTheShaftInEachLayerAndTurnsWithTheSpeed) {
  NeedlingRig rig;
  rig.go(25e-3, 5e-3);
  rig.wait(0.2);
  const auto h = rig.out.inside;               // [m]
  EXPECT_NEAR(h[0] + h[1] + h[2], 25e-3 - dimple(rig.state, 0), 1e-12);
  EXPECT_NEAR(h[0], 0.8e-3, 0.2e-3);
  EXPECT_NEAR(h[1], 8.4e-3, 0.2e-3);
  // Paper, section 3.2, as physics.md A3 b corrects it: F = (sum of d_k h_k) v, with v that of the shaft past the tissue it carries along.
  for (double target : {33e-3, 25e-3}) {       // [m] in, then out again
    double before = 0.0, held = rig.state.friction.held;   // [m]
    rig.go(target, 10e-3, [&] { before = held; held = rig.state.friction.held; });
    double expected = 0.0;                     // [N s/m]
    for (int k = 0; k < kLayers; ++k) expected += rig.model.params.layers[k].damping * rig.out.inside[k];
    const double v = rig.input.needle.velocity.dot(rig.state.axis) - (held - before) / rig.model.params.dt;   // [m/s]
    EXPECT_NEAR(rig.out.dampingForce, expected * v, 0.01 * expected * 10e-3);
    EXPECT_GT(v * (target - 29e-3), 0.0);      // it turns with the speed
    EXPECT_GT(std::abs(v), 9e-3);              // and the tissue has come along by now
  }
}

TEST(Needling, IsHeldAtRestAndPullsBackWhenLifted) {
  NeedlingRig rig;
  rig.go(20e-3, 5e-3);
  rig.go(19.8e-3, 1e-3);
  rig.wait(1.0);
  const double held = rig.up();                // [N]
  rig.wait(2.0);
  EXPECT_EQ(rig.up(), held);
  rig.go(15e-3, 5e-3);
  EXPECT_LT(rig.up(), -0.02);                  // the tissue holds the needle back
  EXPECT_LT(dimple(rig.state, 0), 0.0);        // and the skin is drawn up with it
}

TEST(Needling, ClosedCyclesDissipate) {
  for (const NetProfile profile : {NetProfile::kInverseDistance, NetProfile::kCone}) {
    NeedlingParams p;
    p.profile = profile;
    for (const double deepest : {0.3e-3, 1e-3, 6e-3, 11e-3, 30e-3}) {   // [m]
      NeedlingRig rig(p);
      rig.depth(-1e-3);
      const double before = rig.work;          // [J]
      for (int cycle = 0; cycle < 3; ++cycle) {
        rig.go(deepest, 8e-3);
        rig.go(0.6 * deepest, 4e-3);
        rig.go(deepest, 4e-3);
        rig.go(-1e-3, 8e-3);
        // Where a step straddles the skin, the trapezoid misses up to k stride^2 / 8 of the elastic work.
        EXPECT_GE(rig.work - before, -6e-9 * (cycle + 1)) << deepest;
      }
      if (deepest > 1e-3) { EXPECT_GT(rig.work - before, 1e-5); }
    }
  }
}

TEST(Needling, LiftingThrustingAndTwirlingFeelDifferent) {
  NeedlingRig plain;
  plain.go(25e-3, 5e-3);
  NeedlingRig twirled = plain;
  for (int k = 0; k < 16; ++k) twirled.twirl(2 * M_PI, 1000);
  EXPECT_GT(twirled.state.winding.grasp, 2.5);
  EXPECT_LT(twirled.out.torque, -1e-5);
  EXPECT_EQ(plain.out.torque, 0.0);
  plain.go(20e-3, 1e-3);
  twirled.go(20e-3, 1e-3);
  EXPECT_NEAR(twirled.out.frictionForce / plain.out.frictionForce, 2.5, 0.2);   // needle grasp
}

TEST(Needling, SkinSpringsBackInItsTimeWhateverTheStep) {
  std::vector<double> halfway;                 // [m]
  for (double dt : {1e-3, 0.25e-3}) {
    NeedlingParams p;
    p.dt = dt;
    NeedlingRig rig(p);
    rig.go(0.0, 5e-3);
    while (rig.out.punctured < 0) rig.depth(kBall - rig.input.needle.pose.position.z() + 1e-3 * dt);
    const double pressed = dimple(rig.state, 0);   // [m]
    EXPECT_GT(pressed, 0.4e-3);
    rig.wait(0.5 * p.springbackTime);
    halfway.push_back(dimple(rig.state, 0));
    EXPECT_NEAR(halfway.back(), 0.25 * pressed, 0.1 * pressed);
    rig.wait(p.springbackTime);
    EXPECT_LT(dimple(rig.state, 0), 0.06 * pressed);   // what friction carries stays
  }
  EXPECT_NEAR(halfway[0], halfway[1], 0.02e-3);
}

TEST(Needling, GoesInObliquelyAlongItsOwnLine) {
  NeedlingRig rig;
  const Vec3 inward = Vec3(0.6, 0, -0.8);
  rig.input.needle.pose.orientation = turnOnto(Vec3::UnitZ(), Vec3(-inward));
  const Vec3 top(0, 0, kBall);
  for (int k = -100; k <= 2000; ++k) rig.to(top + inward * (10e-6 * k));
  EXPECT_GE(rig.state.layers[1].phase, LayerPhase::kPunctured);
  EXPECT_LT(rig.out.needle.force.cross(inward).norm(), 0.01 * rig.out.needle.force.norm() + 1e-6);
  rig.to(top + inward * 0.02 + 0.1e-3 * Vec3(0.8, 0, 0.6));   // pushed sideways, the tissue pushes back
  EXPECT_LT(rig.out.needle.force.dot(Vec3(0.8, 0, 0.6)), -0.01);
}

TEST(Needling, PressingFingerMovesTheSkinUnderTheNeedle) {
  NeedlingRig rig;
  rig.input.finger.pose.position = Vec3(0.012, 0, std::sqrt(kBall * kBall - 0.012 * 0.012) - 2e-3);
  rig.depth(-1e-3);
  EXPECT_GT(rig.out.finger.force.norm(), 0.5);
  EXPECT_EQ(rig.up(), 0.0);
  rig.go(1.0e-3, 1e-3);                        // below the skin at rest, but the finger has moved it away
  EXPECT_EQ(rig.up(), 0.0);
  rig.go(1.6e-3, 1e-3);
  EXPECT_GT(rig.up(), 0.0);
}

TEST(Needling, SameInputGivesTheSameBitsAndTouchesNoHeap) {
  NeedlingRig a({}, 15), b({}, 15);
  const auto drive = [](NeedlingRig& rig) {
    rig.go(20e-3, 20e-3);
    rig.twirl(5.0, 200);
    rig.go(-3e-3, 20e-3);
  };
  drive(a);
  {
    const test::RealtimeGuard guard;
    drive(b);
    EXPECT_EQ(guard.calls(), 0u) << guard.first();
  }
  EXPECT_EQ(a.work, b.work);
  EXPECT_EQ(a.out.needle.force, b.out.needle.force);
  for (int k = 0; k < kLayers; ++k)
    for (std::size_t i = 0; i < a.state.layers[k].now.size(); ++i) EXPECT_EQ(a.state.layers[k].now[i], b.state.layers[k].now[i]);
}

TEST(Needling, ASampleThatIsNotANumberMovesNothing) {
  NeedlingRig rig;
  rig.go(5e-3, 5e-3);
  const NeedlingState before = rig.state;
  rig.input.needle.pose.position.x() = std::nan("");
  stepNeedling(rig.model, rig.input, rig.state, rig.out);
  EXPECT_EQ(rig.state.depth, before.depth);
  EXPECT_EQ(rig.state.friction.held, before.friction.held);
}

}  // namespace
}  // namespace halsted
