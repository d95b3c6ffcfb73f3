/// Instruments are changed, and the first thread is handed, as explicit acts: when, when not, and what the hand holds then.
#include "sim/tools/instrument.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "sim/tools/load_driver.h"
#include "sim/tools/tool_shape.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

const Pose kOverEdge{Vec3(0.5 * kWallX, 0.5 * kWallY, kWallZ - 2e-3), Quat::Identity()};   // the wall's edge between open jaws

/// A pen in the right hand, a needle driver beside it, its thread on the table; in the left hand forceps and no other.
SimParams penFirst(ToolKind secondLeft = ToolKind::kNone) {
  SimParams p = wallParams();
  p.thread.knots = true;
  p.thread.spare = 1;
  p.tools[kLeft].kind = ToolKind::kForceps;
  p.second[kLeft].kind = secondLeft;
  p.tools[kRight].kind = ToolKind::kElectrocautery;
  p.second[kRight].kind = ToolKind::kNeedleDriver;
  p.second[kRight].jawLength = 18e-3;
  return p;
}

struct TwoInstruments : StepRig {
  explicit TwoInstruments(ToolKind secondLeft = ToolKind::kNone) : StepRig(penFirst(secondLeft), kNeedleAway) { input.tools[kRight].jaw = 1.0; }

  void say(Command::Kind kind, int hand) {
    input.command = {kind, static_cast<double>(hand)};
    step();
    input.command = {};
  }
  InstrumentRefusal change(int hand = kRight) {
    say(Command::Kind::kChangeInstrument, hand);
    return static_cast<InstrumentRefusal>(state.instruments->refusal);
  }
  ThreadRefusal askThread() {
    say(Command::Kind::kFreshThread, kRight);
    return static_cast<ThreadRefusal>(state.supply->refusal);
  }
};

TEST(ChangeOfInstruments, GivesTheOtherOneAndTakesItBack) {
  TwoInstruments rig;
  EXPECT_EQ(rig.change(), InstrumentRefusal::kNone);
  EXPECT_EQ(rig.out.seen[static_cast<int>(Quantity::kSecondInstruments)], 1.0);
  EXPECT_TRUE(rig.happened(EventKind::kInstrumentChanged));
  EXPECT_EQ(toolOf(rig.model, rig.state, kRight).kind, ToolKind::kNeedleDriver);
  const CapsuleShape jaw = worldSolids(rig.model, rig.state)[kSolidsPerTool * kRight];
  EXPECT_GT((jaw.b - jaw.a).norm(), 17e-3);                      // it is the driver that touches now
  EXPECT_EQ(rig.change(), InstrumentRefusal::kNone);
  EXPECT_EQ(toolOf(rig.model, rig.state, kRight).kind, ToolKind::kElectrocautery);
}

TEST(ChangeOfInstruments, IsRefusedToAHandThatHasNoOther) {
  TwoInstruments rig;
  EXPECT_EQ(rig.change(kLeft), InstrumentRefusal::kNoOther);
  EXPECT_TRUE(rig.happened(EventKind::kInstrumentRefused));
  EXPECT_EQ(rig.state.instruments->second[kLeft], 0);
}

TEST(ChangeOfInstruments, IsRefusedWhileTheJawsHoldTissueOrStandInIt) {
  TwoInstruments rig(ToolKind::kAllis);
  rig.input.tools[kLeft].pose = kOverEdge;
  rig.run(200);
  EXPECT_EQ(rig.change(kLeft), InstrumentRefusal::kInTheWay);
  rig.input.tools[kLeft].jaw = 0.0;
  rig.run(100);
  ASSERT_GT(rig.state.tools[kLeft].grasp.count, 0);
  EXPECT_EQ(rig.change(kLeft), InstrumentRefusal::kHandFull);
  EXPECT_EQ(rig.state.instruments->second[kLeft], 0);
  EXPECT_TRUE(rig.finite());
}

TEST(ChangeOfInstruments, IsRefusedWhereTheOtherHandsInstrumentStands) {
  TwoInstruments rig;
  rig.input.tools[kLeft].pose = {kNeedleAway.position + Vec3(8e-3, 0.0, 0.0), Quat::Identity()};
  rig.run(3);
  EXPECT_EQ(rig.change(), InstrumentRefusal::kInTheWay);
}

/// A specimen lies where it was let go until the scene ends: nobody meets it any more.
TEST(ChangeOfInstruments, IsNotRefusedWhereTissueHasBeenCarriedAway) {
  TwoInstruments rig;
  const CapsuleShape overEdge{kOverEdge.position, kOverEdge.position, 3e-3};   // [m]
  EXPECT_TRUE(tissueWithin(rig.model, rig.state, overEdge));
  rig.state.cut.emplace();
  rig.state.cut->bare.assign(rig.model.mesh.vertices.size(), 0);
  EXPECT_FALSE(tissueWithin(rig.model, rig.state, overEdge));
}

TEST(ChangeOfInstruments, SecondOnesAreCheckedAndShapedAsFirstOnes) {
  SimParams p = penFirst(ToolKind::kElectrocautery);
  p.second[kLeft].jawRadius = 5e-3;
  EXPECT_EQ(buildModel(p, wallMesh(), {}).params.second[kLeft].jawRadius, p.cautery.tipRadius);
  p.second[kLeft].shaftRadius = 0.0;
  EXPECT_THROW(buildModel(p, wallMesh(), {}), std::invalid_argument);
  p.second[kLeft].kind = ToolKind::kNone;      // then its shape is nobody's
  EXPECT_NO_THROW(buildModel(p, wallMesh(), {}));
}

TEST(ChangeOfInstruments, IsPartOfTheStateAndItsHash) {
  TwoInstruments rig;
  State same = rig.state;
  const std::uint64_t before = hash(rig.state);
  rig.state.instruments->second[kRight] = 1;
  EXPECT_NE(hash(rig.state), before);
  std::string error;
  ASSERT_TRUE(load(save(rig.state), same, error)) << error;
  EXPECT_EQ(same.instruments->second[kRight], 1);
  EXPECT_EQ(diff(same, rig.state), "");
}

TEST(ChangeOfInstruments, DoesNothingInASceneWithoutASecond) {
  StepRig one(wallParams(), kNeedleAway), two(wallParams(), kNeedleAway);
  two.input.command = {Command::Kind::kChangeInstrument, 1.0};
  one.step();
  two.step();
  EXPECT_EQ(hash(one.state), hash(two.state));
}

TEST(ThreadOnTheTable, LiesStillAndIsHandedToADriverOnly) {
  TwoInstruments rig;
  const Vec3 lies = rig.state.strand.position.front();
  rig.run(50);
  EXPECT_EQ(rig.state.strand.position.front(), lies);
  EXPECT_FALSE(rig.state.tools[kRight].holdsNeedle);
  EXPECT_EQ(rig.askThread(), ThreadRefusal::kNoDriver);
  ASSERT_EQ(rig.change(), InstrumentRefusal::kNone);
  ASSERT_EQ(rig.askThread(), ThreadRefusal::kNone);
  EXPECT_TRUE(rig.state.tools[kRight].holdsNeedle);
  EXPECT_EQ(rig.state.supply->left, 0);
  EXPECT_FALSE(threadOnTable(rig.model, rig.state));
  const double swage = (rig.state.strand.needle.position - rig.state.tools[kRight].proxy.position).norm();   // [m]
  EXPECT_LT(swage, 2.0 * rig.model.strand.needle.radius);
  rig.run(50);
  EXPECT_TRUE(rig.finite());
  EXPECT_EQ(rig.change(), InstrumentRefusal::kHandFull);         // the needle is in its jaws
}

}  // namespace
}  // namespace halsted
