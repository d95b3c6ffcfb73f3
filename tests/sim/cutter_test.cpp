/// The blades of the needle driver.
#include <gtest/gtest.h>

#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

constexpr int kSegment = 30;                   // of the thread, far from both ends

SimParams withBlades(bool blades) {
  SimParams p = wallParams();
  p.thread.knots = true;
  p.tools[kLeft].cutter = blades;
  return p;
}

/// The left tool with the middle of one segment `up` [m] from its tips, square between the jaws.
Pose across(const State& s, double up) {
  const Vec3 &a = s.strand.position[kSegment], &b = s.strand.position[kSegment + 1];
  const Vec3 y = (b - a).normalized(), z = y.unitOrthogonal();
  return {0.5 * (a + b) - up * z, Quat(Mat3((Mat3() << y.cross(z), y, z).finished())).normalized()};
}

StepRig closedOnThread(bool blades, double up) {   // up [m]
  const StepRig still(withBlades(blades), kNeedleAway);
  StepRig rig(withBlades(blades), kNeedleAway, across(still.state, up));
  rig.run(5);
  rig.input.tools[kLeft].jaw = 0.0;
  return rig;
}

TEST(Cutter, CutsThreadThatLiesAcrossItsBlades) {
  StepRig rig = closedOnThread(true, 9.5e-3);
  rig.step();
  EXPECT_TRUE(rig.happened(EventKind::kThreadCut));
  EXPECT_EQ(rig.state.knot.cuts, 1);
  EXPECT_LT(rig.state.tools[kLeft].threadCoordinate, 0.0);
}

TEST(Cutter, GripsThreadAtTheTipsAsOtherJawsDo) {
  StepRig rig = closedOnThread(true, 2e-3);
  rig.step();
  EXPECT_EQ(rig.state.knot.cuts, 0);
  EXPECT_GE(rig.state.tools[kLeft].threadCoordinate, 0.0);
}

TEST(Cutter, IsNotThereUnlessTheToolHasBlades) {
  StepRig rig = closedOnThread(false, 9.5e-3);
  rig.step();
  EXPECT_EQ(rig.state.knot.cuts, 0);
}

TEST(Cutter, LeavesTwoPiecesThatNoLongerPullOnEachOther) {
  SimParams p = withBlades(true);
  p.gravity = Vec3(0.0, 0.0, -9.81);
  const StepRig still(p, kNeedleAway);
  StepRig rig(p, kNeedleAway, across(still.state, 9.5e-3));
  rig.input.tools[kLeft].jaw = 0.0;
  rig.step();
  ASSERT_EQ(rig.state.knot.cuts, 1);
  int cut = 0;
  while (!rig.state.threadContacts.cut[cut]) ++cut;
  rig.run(150);                                // the tail's piece falls, the needle's is held
  const Vec3 gap = rig.state.strand.position[cut + 1] - rig.state.strand.position[cut];
  EXPECT_GT(gap.norm(), 20.0 * p.thread.segmentLength);
  EXPECT_EQ(rig.state.strand.tension[cut], 0.0);
}

}  // namespace
}  // namespace halsted
