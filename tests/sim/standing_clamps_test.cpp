/// A clamp that is handed over stays on the tissue and pulls as it did; the hand is free.
#include "sim/tools/standing_clamps.h"

#include <gtest/gtest.h>

#include "sim/tools/touch.h"
#include "tests/sim/cut_rig.h"

namespace halsted {
namespace {

Pose overTheEdge(double rise) { return {Vec3(0.5 * kWallX, 12e-3, kWallZ - 2e-3 + rise), Quat::Identity()}; }   // [m]

SimParams clampParams(ToolKind left = ToolKind::kAllis) {
  SimParams p = wallParams();
  p.tools[kLeft].kind = left;
  p.tools[kLeft].gripForce = 15.0;
  p.assistant.clamps = 2;
  return p;
}

Vec3 pullOf(const TissueGrasp& grasp) {        // [N] on the tissue
  Vec3 sum = Vec3::Zero();
  for (int g = 0; g < grasp.count; ++g) sum += grasp.force[g];
  return sum;
}

template <class Rig> void offer(Rig& rig) {
  rig.input.command = {Command::Kind::kHandOver, static_cast<double>(kLeft)};
  rig.step();
  rig.input.command = {};
}

/// An Allis clamp on the wall's edge, drawn up by three millimetres.
struct ClampedEdge : StepRig {
  explicit ClampedEdge(const SimParams& p = clampParams()) : StepRig(p, kNeedleAway, overTheEdge(0.0)) {
    run(10);
    for (int k = 0; k < 100; ++k) { input.tools[kLeft].jaw = 1.0 - 7e-3 * k; step(); }
    lift(0.0, 3e-3);
    run(500);
  }
  void lift(double from, double to) {          // [m]
    for (int k = 1; k <= 200; ++k) { input.tools[kLeft].pose = overTheEdge(from + k / 200.0 * (to - from)); step(); }
  }
  const StandingClamp& clamp() const { return state.clamps->clamp[0]; }
};

TEST(StandingClamps, GoOnPullingAsTheHandDidAndSetItFree) {
  ClampedEdge rig;
  const Vec3 before = pullOf(rig.state.tools[kLeft].grasp);      // [N]
  const auto shape = rig.state.tissue.position;
  ASSERT_GT(before.z(), 0.5);
  offer(rig);
  EXPECT_TRUE(rig.happened(EventKind::kClampHandedOver));
  ASSERT_EQ(rig.state.clamps->count, 1);
  EXPECT_EQ(rig.state.clamps->left, 1);
  EXPECT_TRUE(jawsEmpty(rig.state.tools[kLeft]));
  rig.lift(3e-3, 43e-3);                       // the hand goes, its jaws as they are
  rig.run(500);
  EXPECT_LT(rig.state.tools[kLeft].force.norm(), 1e-9);
  EXPECT_LT((pullOf(rig.clamp().grasp) - before).norm(), 0.01 * before.norm());
  double moved = 0.0;                          // [m]
  for (std::size_t i = 0; i < shape.size(); ++i) moved = std::max(moved, (rig.state.tissue.position[i] - shape[i]).norm());
  EXPECT_LT(moved, 0.05e-3);
  EXPECT_LT(rig.tissueSpeed(), 1e-4);
}

TEST(StandingClamps, GiveWayAsTheHandsCouplingDoes) {
  ClampedEdge rig;
  offer(rig);
  rig.lift(3e-3, 43e-3);
  rig.run(200);
  const Vec3 pull = -pullOf(rig.clamp().grasp);                  // [N] of the tissue
  EXPECT_LT((rig.clamp().pose.position - rig.clamp().held.position - pull / rig.model.params.tools[kLeft].couplingStiffness).norm(), 1e-9);
  ASSERT_GT(pull.norm(), 0.5);
}

TEST(StandingClamps, LetNoToolTouchWhatLiesBetweenTheirJaws) {
  ClampedEdge rig;
  offer(rig);
  double most = 0.0;                           // [N] on the hand that draws its shut clamp out of the same place
  for (int k = 1; k <= 300; ++k) {
    rig.input.tools[kLeft].pose = overTheEdge(3e-3 + 1e-4 * k);
    rig.step();
    most = std::max(most, rig.state.tools[kLeft].force.norm());
  }
  EXPECT_LT(most, 0.5);
  EXPECT_EQ(rig.state.clamps->count, 1);
}

TEST(StandingClamps, LoseTissueThatIsDrawnOutOfThem) {
  SimParams p = clampParams();
  p.tools[kLeft].gripForce = 1.0;              // less than it takes to draw the edge up by four millimetres
  ClampedEdge rig(p);
  offer(rig);
  ASSERT_EQ(rig.state.clamps->count, 1);
  bool released = false;
  for (int k = 0; k < 600 && !released; ++k) {
    rig.state.clamps->clamp[0].held.position.z() += 1e-5;        // the assistant pulls
    rig.step();
    released = rig.happened(EventKind::kClampReleased);
    EXPECT_LE(pullOf(rig.clamp().grasp).norm(), p.tools[kLeft].gripForce * (1.0 + 1e-9));
  }
  EXPECT_TRUE(released);
  EXPECT_EQ(rig.state.clamps->count, 0);
  rig.lift(3e-3, 43e-3);
  rig.run(2000);
  EXPECT_LT(rig.displacement(), 1e-6);
}

TEST(StandingClamps, AreRefusedWithTheReason) {
  ClampedEdge rig;
  offer(rig);
  offer(rig);                                  // the hand holds nothing now
  EXPECT_TRUE(rig.happened(EventKind::kClampRefused));
  EXPECT_EQ(static_cast<ClampRefusal>(rig.state.clamps->refusal), ClampRefusal::kHoldsNothing);
  ClampedEdge forceps(clampParams(ToolKind::kForceps));
  offer(forceps);
  EXPECT_EQ(static_cast<ClampRefusal>(forceps.state.clamps->refusal), ClampRefusal::kNoClamp);
  EXPECT_GT(forceps.state.tools[kLeft].grasp.count, 0);
  SimParams none = clampParams();
  none.assistant.clamps = 1;
  ClampedEdge last(none);
  last.state.clamps->left = 0;
  offer(last);
  EXPECT_EQ(static_cast<ClampRefusal>(last.state.clamps->refusal), ClampRefusal::kNoneLeft);
}

TEST(StandingClamps, ArePartOfTheStateAndItsHash) {
  ClampedEdge rig;
  const std::uint64_t without = hash(rig.state);
  offer(rig);
  EXPECT_NE(hash(rig.state), without);
  State other = initialState(rig.model, {kAway, kAway});
  std::string error;
  ASSERT_TRUE(load(save(rig.state), other, error)) << error;
  EXPECT_EQ(diff(rig.state, other), "");
  other.clamps->clamp[0].held.position.x() += 1e-9;
  EXPECT_NE(hash(other), hash(rig.state));
}

TEST(StandingClamps, DoNothingInASceneThatHasNone) {
  SimParams p = clampParams();
  p.assistant.clamps = 0;
  ClampedEdge rig(p), asked(p);
  rig.step();
  offer(asked);
  EXPECT_EQ(diff(rig.state, asked.state), "");
}

/// A strip of which the lower part is the specimen, an Allis clamp on it handed over.
struct ClampedStrip : CutRig {
  ClampedStrip() : CutRig(params()) {
    input.tools[kLeft].pose = penAt(2e-3, 0.3e-3, 1.5 * kCell);
    run(20);
    input.tools[kLeft].jaw = 0.0;
    run(100);
    offer(*this);
    input.tools[kLeft].jaw = 1.0;
  }
  static SimParams params() {
    SimParams p = cutParams();
    p.tools[kLeft].kind = ToolKind::kAllis;
    p.assistant.clamps = 1;
    return p;
  }
};

TEST(StandingClamps, HoldAPieceThatIsFreeUntilAHandHoldsIt) {
  ClampedStrip rig;
  ASSERT_EQ(rig.state.clamps->count, 1);
  rig.run(50);
  rig.vaporise(kLineRow);
  ASSERT_EQ(rig.state.cut->pieces, 1);
  rig.run(200);
  EXPECT_EQ(rig.state.clamps->count, 1);
  rig.input.tools[kLeft].pose = penAt(6e-3, 0.3e-3, 1.5 * kCell);
  rig.run(100);
  rig.input.tools[kLeft].jaw = 0.0;
  rig.run(5);
  EXPECT_GT(rig.state.tools[kLeft].grasp.count, 0);
  EXPECT_EQ(rig.state.clamps->count, 0);
  EXPECT_EQ(rig.count(EventKind::kClampReleased), 1);
}

TEST(StandingClamps, HoldNothingOfWhatGoes) {
  ClampedStrip rig;
  ASSERT_EQ(rig.state.clamps->count, 1);
  for (int row = 0; row < 4; ++row) rig.vaporise(row);
  EXPECT_EQ(rig.state.clamps->count, 0);
  std::vector<Vec3> nodal(rig.state.tissue.position.size(), Vec3::Zero());   // [N]
  gatherTouchForces(rig.model, rig.state, nodal);
  for (const Vec3& force : nodal) EXPECT_EQ(force, Vec3::Zero());
}

}  // namespace
}  // namespace halsted
