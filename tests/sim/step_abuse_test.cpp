/// Whatever the hands send, the step stays finite, bounded and off the heap; and a scene at rest stays at rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "tests/sim/hand_noise.h"
#include "tests/sim/kinetic_energy.h"
#include "tests/sim/laced_wall.h"
#include "tests/support/realtime_guard.h"

namespace halsted {
namespace {

SimParams weighted() {
  SimParams p = wallParams();
  p.gravity = Vec3(0, 0, -9.81);
  return p;
}

TEST(StepAbuse, AHostileSampleLeavesTheToolWhereItWas) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();   // [any]
  StepRig rig(weighted(), kNeedleBeside);
  rig.run(50);
  const StepInput good = rig.input;
  const auto offer = [&](auto spoil, const char* what) {
    for (int hand = 0; hand < kHands; ++hand) {
      rig.input = good;
      spoil(rig.input.tools[hand]);
      const Pose before = rig.state.tools[hand].device;
      for (int k = 0; k < 20; ++k) {
        rig.step();
        ASSERT_TRUE(rig.finite()) << what << ", hand " << hand;
        ASSERT_EQ(rig.state.tools[hand].device.position, before.position) << what << ", hand " << hand;
        ASSERT_NEAR(rig.state.tools[hand].device.orientation.norm(), 1.0, 1e-9) << what << ", hand " << hand;   // zero turned by anything is zero
        ASSERT_LT(rig.state.tools[hand].device.orientation.angularDistance(before.orientation), 1e-7) << what << ", hand " << hand;
      }
    }
  };
  for (double bad : {nan, inf, -inf, 1e300, -1e300}) {
    for (int axis = 0; axis < 3; ++axis) offer([&](ToolSample& s) { s.pose.position[axis] = bad; }, "position");
    offer([&](ToolSample& s) { s.pose.orientation.y() = bad; }, "orientation");
  }
  offer([](ToolSample& s) { s.pose.orientation.coeffs().setZero(); }, "zero quaternion");
  offer([](ToolSample& s) { s.pose.orientation.coeffs() *= 1e-200; }, "vanishing quaternion");
  offer([&](ToolSample& s) { s.jaw = nan; }, "jaw");
  rig.input = good;
  for (double bad : {inf, -inf, 1e300}) {        // a jaw beyond its stops stands at a stop
    rig.input.tools[kLeft].jaw = bad;
    rig.step();
    EXPECT_TRUE(rig.finite());
    EXPECT_GE(rig.state.tools[kLeft].jaw, 0.0);
    EXPECT_LE(rig.state.tools[kLeft].jaw, 1.0);
  }
}

TEST(StepAbuse, ATeleportingHandLeavesEverythingFinite) {
  StepRig rig(weighted(), kNeedleBeside);
  for (int k = 0; k < 2000; ++k) {
    const double side = k / 100 % 2 ? 1.0 : -1.0;                              // [1]
    for (int hand = 0; hand < kHands; ++hand) rig.input.tools[hand].pose.position = side * Vec3(0.1, hand ? 0.05 : -0.05, 0.1);
    rig.step();
    ASSERT_TRUE(rig.finite()) << "step " << k;
  }
}

/// 20 000 steps a seed, or as many as HALSTED_ABUSE_STEPS says: HALSTED_ABUSE_STEPS=1000000 is the long abuse run.
int abuseSteps() {
  const char* asked = std::getenv("HALSTED_ABUSE_STEPS");
  return asked ? std::max(1, std::atoi(asked)) : 20000;
}

class RandomHands : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seed, RandomHands, testing::Values(1, 3, 7));

/// The hands move at 0.15 m/s in a box of 43 mm and give way at 20 N, a step after they feel it. The wall weighs 1.6 g.
TEST_P(RandomHands, StayFiniteWithBoundedForces) {
  StepRig rig(weighted(), kNeedleBeside);
  HandNoise noise(GetParam());
  const int steps = abuseSteps();
  double most = 0.0, liveliest = 0.0;            // [N] [J]
  int broken = 0;                                // steps
  for (int k = 0; k < steps; ++k) {
    noise.move(rig.input);
    rig.step();
    broken += rig.finite() ? 0 : 1;
    for (const ToolState& t : rig.state.tools) most = std::max(most, t.force.norm());
    liveliest = std::max(liveliest, kineticEnergy(rig.model, rig.state));
  }
  RecordProperty("most_force_n", std::to_string(most));
  RecordProperty("kinetic_mj", std::to_string(1e3 * liveliest));
  std::printf("seed %d, %d steps: at most %.2f N, %.3f mJ, %d steps with a number that is none\n", static_cast<int>(GetParam()), steps, most,
              1e3 * liveliest, broken);
  EXPECT_EQ(broken, 0);
  EXPECT_LT(most, 60.0);
  EXPECT_LT(liveliest, 2e-3);                    // all of the wall at 1.6 m/s, ten times as fast as the hands
}

/// No contact of the tissue with itself is stronger than the hands that press it, and no part leaves their reach.
TEST_P(RandomHands, TissueIsNeverFlung) {
  StepRig rig(weighted(), kNeedleBeside);
  HandNoise noise(GetParam());
  double most = 0.0, farthest = 0.0;             // [N], [m]
  for (int k = 0; k < 8000; ++k) {
    noise.move(rig.input);
    rig.step();
    for (int i = 0; i < rig.state.tissue.pairCount; ++i) most = std::max(most, rig.state.tissue.pairForce[i]);
    farthest = std::max(farthest, rig.displacement());
  }
  RecordProperty("pair_force_n", std::to_string(most));
  RecordProperty("displacement_mm", std::to_string(1e3 * farthest));
  EXPECT_LT(most, 20.0);
  EXPECT_LT(farthest, 0.06);
}

TEST(StepRealtime, CallsNoHeapLockOrFile) {
  if (!test::RealtimeGuard::available()) GTEST_SKIP() << "the sanitizer owns malloc";
  for (TissueSolver solver : {TissueSolver::kProjective, TissueSolver::kXpbd, TissueSolver::kShapeMatching}) {
    SimParams p = weighted();
    p.tissue.solver = solver;
    p.needle.punctureForce = 0.3;
    StepRig rig(p, kNeedleBeside);
    HandNoise noise(4);
    rig.run(10);
    const test::RealtimeGuard guard;
    for (int k = 0; k < (solver == TissueSolver::kProjective ? 5000 : 300); ++k) {
      noise.move(rig.input);
      rig.step();
    }
    EXPECT_EQ(guard.calls(), 0u) << guard.first();
  }
}

TEST(StepRealtime, CallsNoHeapLockOrFileWhileThreadIsKnottedKeptAndHanded) {
  if (!test::RealtimeGuard::available()) GTEST_SKIP() << "the sanitizer owns malloc";
  LacedWall w(std::vector<int>{3, -3}, ThreadContactParams{}.friction, 1);
  HandNoise noise(4);
  const test::RealtimeGuard guard;
  w.drawTight(3.0, 0.6);
  const int touching = w.state.threadContacts.count;
  w.letGo(0.2);
  w.cutOff();
  w.goAside();
  w.ask();
  for (int k = 0; k < 500; ++k) {
    noise.move(w.input);
    w.step();
  }
  const std::uint64_t calls = guard.calls();
  EXPECT_EQ(calls, 0u) << guard.first();
  EXPECT_GT(touching, 0);
  EXPECT_EQ(name(static_cast<ThreadRefusal>(w.state.supply->refusal)), std::string("handed"));
  EXPECT_EQ(w.state.stitches->count + w.state.stitches->torn, 1);
}

TEST(Rest, AnUnloadedWallDoesNotMoveAtAll) {
  StepRig rig(wallParams(), kNeedleAway);
  rig.run(1000);
  EXPECT_LT(rig.displacement(), 1e-12);
}

TEST(Rest, AWallUnderItsOwnWeightComesToRest) {
  StepRig rig(weighted(), kNeedleAway);
  rig.run(3000);
  EXPECT_GT(rig.displacement(), 1e-7);           // it does sag
  double fastest = 0.0;                          // [m/s]
  for (int k = 0; k < 500; ++k) {
    rig.step();
    fastest = std::max(fastest, rig.tissueSpeed());
  }
  RecordProperty("speed_m_s", std::to_string(fastest * 1e9) + "e-9");
  EXPECT_LT(fastest, 1e-6);
}

/// A hand that holds still against the tissue feels a force that holds still.
TEST(Rest, AHeldToolFeelsAConstantForce) {
  StepRig rig(weighted(), kNeedleAway, frame(Vec3(kWallX + 0.7e-3, 12e-3, 11e-3), Vec3::UnitY(), Vec3::UnitZ()));
  rig.run(3000);
  const Vec3 before = rig.state.tools[kLeft].force;
  ASSERT_GT(before.norm(), 0.02);
  double wander = 0.0;                           // [N]
  for (int k = 0; k < 500; ++k) {
    rig.step();
    wander = std::max(wander, (rig.state.tools[kLeft].force - before).norm());
  }
  RecordProperty("wander_n", std::to_string(wander));
  EXPECT_LT(wander, 1e-3);
}

}  // namespace
}  // namespace halsted
