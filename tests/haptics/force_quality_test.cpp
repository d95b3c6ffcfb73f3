/// The laws of force quality (devices.md): each number of the bench keeps its bound. `halsted devices --bench` prints the same ones.
#include <gtest/gtest.h>

#include <cstdio>

#include "haptics/bench/bench.h"

namespace halsted::haptics::bench {
namespace {

void expectMet(const Measurements& all) {
  int bounded = 0;
  for (const Measurement& m : all) {
    std::printf("%s\n", text(m).c_str());
    EXPECT_TRUE(m.met()) << text(m);
    bounded += m.bound != Bound::kNone;
  }
  EXPECT_GT(bounded, 0);
}

/// What the search finds is a limit of nature, not of the search: without friction, quantisation, hand stiffness or passivity
/// controller a mass with a damper holds walls up to 2 b / T (Colgate & Schenkel; devices.md).
TEST(ForceQuality, TheSearchFindsColgatesLimitOnABareDevice) {
  for (const double damping : {1.0, 2.0, 4.0}) {
    PressPlan plan;
    plan.touch.friction = 0.0;
    plan.touch.viscosity = damping;
    plan.touch.positionStep = 0.0;
    plan.hand.stiffness = plan.hand.damping = 0.0;
    plan.hand.visualGain = 200.0;
    plan.hand.visualForce = 0.3;
    plan.hold = 6.0;
    plan.config.caps.stiffness = 1e9;
    plan.config.passivity.maxDamping = 0.0;
    const double found = stiffestQuietWall(plan, 16000.0), limit = 2.0 * damping / plan.config.period;   // [N/m]
    EXPECT_NEAR(found / limit, 1.0, 0.2) << damping << " N s/m: " << found << " N/m";
  }
}

TEST(ForceQuality, ZWidth) { expectMet(measureZWidth()); }
TEST(ForceQuality, NominalStiffnessOfTheTouchIsRenderedAndQuiet) { expectMet(measureNominalWall()); }
TEST(ForceQuality, NoPressCreatesEnergy) { expectMet(measurePressEnergy()); }
TEST(ForceQuality, ForceIsContinuousWhileModelsAreReplaced) { expectMet(measureContinuity()); }
TEST(ForceQuality, HeldContactDoesNotBuzz) { expectMet(measureHeldContact()); }
TEST(ForceQuality, NoThrowPassesASheet) { expectMet(measurePopThrough(600)); }   // halsted devices --bench throws 10 000 times
TEST(ForceQuality, ForceIsTheSameAtEveryRate) { expectMet(measureRateInvariance()); }
TEST(ForceQuality, SampleAndForceShareATick) { expectMet(measureLatency()); }
TEST(ForceQuality, ForceIsTheSpringsForce) { expectMet(measureAccuracy()); }
TEST(ForceQuality, FrictionOfTheContactIsFelt) { expectMet(measureContactFriction()); }
TEST(ForceQuality, FaultsReachTheMotorsAsLittle) { expectMet(measureFaults()); }
TEST(ForceQuality, WarmMotorsGetTheirContinuousForce) { expectMet(measureThermal()); }
TEST(ForceQuality, StiffnessIsTheDevicesNotTheScenes) { expectMet(measureCouplingLimits()); }

/// Where nothing is created, the controller does nothing: on a wall whose damping is above K T / 2 it never speaks.
TEST(ForceQuality, PassivityIsSilentWhereNothingIsCreated) {
  for (const NamedHand& hand : threeHands()) {
    SpringWall wall{300.0, 1.0, 2e-3};
    Pose start;
    start.position.y() = 5e-3;
    HandDynamics slow = hand.dynamics;
    slow.maxSpeed = 0.05;
    Rig rig({}, slow, start);
    bool pressed = false;
    for (int i = 0; i < 3000; ++i) {
      rig.target.pose.position.y() = i / 500 % 2 == 1 ? -2e-3 : 5e-3;
      rig.advance(wall);
      pressed = pressed || rig.output.force.y() > 0.3;
      ASSERT_EQ(rig.output.faults & kFaultPassivity, 0u) << hand.name << ", tick " << i;
    }
    EXPECT_TRUE(pressed) << hand.name;
  }
}

/// The scene may ask for any stiffness: the loop on a device of another nominal stiffness shows that device's.
TEST(ForceQuality, CouplingCapsAreTwiceTheNominalStiffnessOfTheDevice) {
  const CouplingCaps fromDevice{0.0, 5.0, 10.0};
  EXPECT_DOUBLE_EQ(couplingCaps(fromDevice, DeviceLimits{}, 1.0).stiffness, 2040.0);
  EXPECT_DOUBLE_EQ(couplingCaps(fromDevice, DeviceLimits{}, 1.5).stiffness, 1360.0);
  EXPECT_DOUBLE_EQ(couplingCaps(fromDevice, {8.0, 2.5, 3000.0, 0.05e-3}, 1.0).stiffness, 6000.0);
}

}  // namespace
}  // namespace halsted::haptics::bench
