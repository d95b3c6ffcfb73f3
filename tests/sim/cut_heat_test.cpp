/// The pen: where its power goes, how fast it cuts, what it leaves alone.
#include <gtest/gtest.h>

#include "sim/cutting/burn.h"
#include "sim/fields.h"
#include "tests/sim/cut_rig.h"
#include "tests/support/realtime_guard.h"

namespace halsted {
namespace {

constexpr double kMiddleX = 4e-3, kLineZ = (kLineRow + 0.5) * kCell;   // [m]

TEST(CutHeat, IsAllThePowerWhileTheTipTouchesAndNoneElse) {
  SimParams p = cutParams();
  p.cautery.cuttingEnergy = 1e11;              // nothing goes
  CutRig rig(p);
  rig.pen(penAt(kMiddleX, -5e-3, kLineZ), true);
  rig.run(50);
  EXPECT_EQ(rig.heat(), 0.0);                  // in the air
  rig.pen(penAt(kMiddleX, 0.1e-3, kLineZ), false);
  rig.run(100);
  EXPECT_EQ(rig.heat(), 0.0);                  // pressed on, but off
  EXPECT_GT(rig.state.tools[kLeft].contactCount, 0);
  rig.pen(penAt(kMiddleX, 0.1e-3, kLineZ), true);
  rig.run(201);                                // the hand closes in the first step, current flows from the second
  EXPECT_NEAR(rig.cut().time, 0.2, 1e-9);
  EXPECT_NEAR(rig.heat(), 30.0 * 0.2, 1e-9);
  EXPECT_NEAR(rig.cut().energy, rig.heat(), 1e-9);
  EXPECT_EQ(rig.cut().overshoot, 0.0);
  EXPECT_EQ(rig.out.seen[static_cast<int>(Quantity::kCurrent)], 1.0);
  EXPECT_EQ(rig.cut().burnt, 0);
}

TEST(CutHeat, SmokesWhereItHasCharredWhileThePenIsOn) {
  CutRig rig;
  const auto smokesWith = [&](double y, bool on) {   // [m]
    rig.pen(penAt(kMiddleX, y, kLineZ), on);
    rig.run(20);
    return smokes(rig.model, rig.state, kLeft);
  };
  EXPECT_FALSE(smokesWith(-5e-3, true));       // in the air
  EXPECT_FALSE(smokesWith(0.1e-3, false));     // pressed on, but off
  rig.pen(penAt(kMiddleX, 0.1e-3, kLineZ), true);
  rig.run(500);
  ASSERT_GT(rig.cut().burnt, 0);
  EXPECT_TRUE(smokes(rig.model, rig.state, kLeft));
  EXPECT_FALSE(smokesWith(0.1e-3, false));
  EXPECT_FALSE(smokesWith(-5e-3, true));
}

TEST(CutHeat, InTissueThatCannotBeCutIsOvershootAndTakesNothingAway) {
  CutRig rig;
  rig.pen(penAt(kMiddleX, 0.1e-3, 3e-3), true);
  rig.run(1000);
  EXPECT_GT(rig.heat(), 29.0);                 // 0.3 J would take a tet that can be cut
  EXPECT_NEAR(rig.cut().overshoot, rig.heat(), 1e-9);
  EXPECT_EQ(rig.cut().burnt, 0);
}

/// Sawed through along its line: a tet goes when it has what boils it away, so the front moves at power over (energy x area of the kerf),
/// less what its neighbours take up.
TEST(CutHeat, CutsAtPowerOverEnergyAndKerfArea) {
  CutRig rig;
  int k = 0;
  while (rig.cut().share[0] < 1.0 && k < 6000) k = rig.saw(20, k);
  ASSERT_EQ(rig.cut().share[0], 1.0);
  double burnt = 0.0, volume = 0.0;            // [J], [m^3]
  for (std::size_t t = 0; t < rig.state.tissue.heat.size(); ++t) {
    if (rig.state.tissue.gone[t] != static_cast<std::uint8_t>(Gone::kBurnt)) continue;
    const double needed = rig.model.tissue.restVolume[t] * rig.model.params.cautery.cuttingEnergy;   // [J]
    EXPECT_GE(rig.state.tissue.heat[t], needed);
    EXPECT_LE(rig.state.tissue.heat[t], needed + 30.0 * rig.model.params.dt);
    burnt += needed;
    volume += rig.model.tissue.restVolume[t];
  }
  const double used = rig.cut().energy;        // [J]
  RecordProperty("steps", k);
  RecordProperty("burnt_over_row", std::to_string(volume / kRowVolume));
  RecordProperty("efficiency", std::to_string(burnt / used));
  std::printf("cut through after %d steps, %.3f s of current: %.2f of a row burnt, %.0f %% of the heat in it, worst %.1f mm off, overshoot %.2f J\n", k,
              rig.cut().time, volume / kRowVolume, 100.0 * burnt / used, 1e3 * rig.cut().errorWorst, rig.cut().overshoot);
  EXPECT_NEAR(rig.cut().time, used / 30.0, 1e-9);
  EXPECT_NEAR(rig.heat(), used, 1e-9 * used);
  EXPECT_GT(burnt / used, 0.5);
  EXPECT_GT(volume, 0.6 * kRowVolume);
  EXPECT_LT(volume, 1.5 * kRowVolume);
}

TEST(CutHeat, SawingThroughSetsTheSpecimenFree) {
  CutRig rig;
  int k = 0;
  while (rig.cut().freePieces == 0 && k < 6000) k = rig.saw(20, k);
  ASSERT_EQ(rig.cut().freePieces, 1);
  EXPECT_EQ(rig.cut().share[0], 1.0);
  EXPECT_GE(rig.count(EventKind::kPieceFree), 1);
  EXPECT_EQ(rig.count(EventKind::kTissueCut), rig.cut().burnt);
  EXPECT_NEAR(rig.cut().freeVolume, kLineRow * kRowVolume, 0.5 * kRowVolume);
  EXPECT_EQ(rig.out.seen[static_cast<int>(Quantity::kSpecimenFree)], 1.0);
}

TEST(CutHeat, GoesOnTheSameAfterBeingSavedInTheMiddle) {
  CutRig rig;
  int k = rig.saw(900);
  ASSERT_GT(rig.cut().burnt, 0);
  CutRig other;
  std::string error;
  ASSERT_TRUE(load(save(rig.state), other.state, error)) << error;
  ASSERT_EQ(diff(rig.state, other.state), "");
  for (int i = 0; i < 25; ++i) {
    rig.saw(20, k);
    k = other.saw(20, k);
    ASSERT_EQ(hash(rig.state), hash(other.state)) << diff(rig.state, other.state);
  }
  EXPECT_GT(rig.cut().burnt, 20);
}

/// Taken back to an earlier moment, a run that has cut elsewhere since keeps nothing of that.
TEST(CutHeat, GoesOnTheSameAfterBeingTakenBack) {
  CutRig rig, fresh;
  const int k = rig.saw(1100);
  const std::vector<std::uint8_t> kept = save(rig.state);
  for (int i = 0; i < 40; ++i) {
    rig.pen(penAt(2e-3, 1.2e-3, (kLineRow - 0.5) * kCell), true);
    rig.step();
  }
  std::string error;
  ASSERT_TRUE(load(kept, rig.state, error) && load(kept, fresh.state, error)) << error;
  int a = k, b = k;
  for (int i = 0; i < 20; ++i) {
    a = rig.saw(20, a);
    b = fresh.saw(20, b);
    ASSERT_EQ(hash(rig.state), hash(fresh.state)) << diff(rig.state, fresh.state);
  }
}

TEST(CutHeat, TakesNoHeapLockOrFileInAStep) {
  if (!test::RealtimeGuard::available()) GTEST_SKIP() << "the sanitizer owns malloc";
  CutRig rig;
  rig.saw(10);
  const test::RealtimeGuard guard;
  rig.saw(1500, 10);
  EXPECT_EQ(guard.calls(), 0u) << guard.first();
  EXPECT_GT(rig.cut().burnt, 0);
}

TEST(CutHeat, AskedOfAMeshThatMakesNoSenseIsRefused) {
  SimParams p = cutParams();
  p.tissue.solver = TissueSolver::kShapeMatching;
  EXPECT_THROW(buildModel(p, stripMesh(Held::kTop), {}), std::invalid_argument);
  TetMesh wrong = stripMesh(Held::kTop);
  wrong.cuttable.pop_back();
  EXPECT_THROW(buildModel(cutParams(), wrong, {}), std::invalid_argument);
  wrong = stripMesh(Held::kTop);
  wrong.cutLine[200].wall = kCutWalls;
  EXPECT_THROW(buildModel(cutParams(), wrong, {}), std::invalid_argument);
}

/// Tissue that can be cut and is not behaves, to the last bit, as tissue that cannot.
TEST(CutHeat, WhatIsNotCutKeepsItsBits) {
  SimParams p = cutParams();
  p.gravity = Vec3(0, 0, -9.81);
  CutRig may(p), cannot(p, stripMesh(Held::kTop, false));
  for (int k = 0; k < 600; ++k) {
    for (CutRig* rig : {&may, &cannot}) {
      rig->pen(penAt(kMiddleX, 1e-3 * (k - 200) / 200.0, kLineZ), false);
      rig->step();
    }
    for (std::size_t i = 0; i < may.state.tissue.position.size(); ++i)
      ASSERT_EQ(may.state.tissue.position[i], cannot.state.tissue.position[i]) << "step " << k << ", particle " << i;
    ASSERT_EQ(may.state.tools[kLeft].force, cannot.state.tools[kLeft].force) << "step " << k;
  }
  EXPECT_GT(may.state.tools[kLeft].force.norm(), 0.05);
}

}  // namespace
}  // namespace halsted
