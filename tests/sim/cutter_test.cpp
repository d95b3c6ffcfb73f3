/// The blades of the needle driver.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/tools/cutter.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

constexpr int kCutSegment = 30;                   // of the thread, far from both ends

SimParams withBlades(bool blades) {
  SimParams p = wallParams();
  p.thread.knots = true;
  p.tools[kLeft].cutter = blades;
  return p;
}

/// The left tool with the middle of one segment `up` [m] from its tips, square between the jaws.
Pose across(const State& s, double up) {
  const Vec3 &a = s.strand.position[kCutSegment], &b = s.strand.position[kCutSegment + 1];
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

/// The blades are called while the jaws are still a third open; beside the middle line of a jaw thread is pressed against its outside.
TEST(Cutter, LeavesThreadAloneThatRunsRoundTheOutsideOfAJaw) {
  const auto cutsAt = [](double aside) {       // [m] of the thread from the middle between the jaws
    StepRig rig(withBlades(true), kNeedleAway);
    ToolState& tool = rig.state.tools[kLeft];
    tool.proxy = across(rig.state, 9.5e-3);
    tool.proxy.position -= aside * (tool.proxy.orientation * Vec3::UnitX());
    tool.jaw = 0.3;
    return cutThread(rig.model, kLeft, rig.state, rig.out);
  };
  EXPECT_TRUE(cutsAt(0.5e-3));
  EXPECT_TRUE(cutsAt(-0.5e-3));
  EXPECT_FALSE(cutsAt(2.2e-3));
  EXPECT_FALSE(cutsAt(-2.2e-3));
}

TEST(Cutter, IsNotThereUnlessTheToolHasBlades) {
  StepRig rig = closedOnThread(false, 9.5e-3);
  rig.step();
  EXPECT_EQ(rig.state.knot.cuts, 0);
}

/// Of the tail's piece of the thread: centre [m] and speed [m/s].
struct Piece { Vec3 centre = Vec3::Zero(), speed = Vec3::Zero(); };

Piece tailPiece(const StepRig& rig) {
  Piece p;
  double mass = 0.0;                           // [kg]
  for (int i = 0; i <= kCutSegment; ++i) {
    mass += rig.model.strand.mass[i];
    p.centre += rig.model.strand.mass[i] * rig.state.strand.position[i];
    p.speed += rig.model.strand.mass[i] * rig.state.strand.velocity[i];
  }
  return {p.centre / mass, p.speed / mass};
}

/// How far the tail's piece is from where it would be had it fallen freely through the air for 0.1 s.  [m]
double pulledFromItsFall(StepRig& rig) {
  constexpr int kSteps = 100;
  const SimParams& p = rig.model.params;
  const double h = p.dt / p.thread.substeps;   // [s]
  Piece free = tailPiece(rig);
  for (int i = 0; i < kSteps * p.thread.substeps; ++i) {         // implicit Euler with the drag of the air, as the strand's solve
    free.speed = (free.speed + h * p.gravity) / (1.0 + p.thread.damping * h);
    free.centre += h * free.speed;
  }
  rig.run(kSteps);
  return (tailPiece(rig).centre - free.centre).norm();
}

TEST(Cutter, LeavesTwoPiecesThatNoLongerPullOnEachOther) {
  SimParams p = withBlades(true);
  p.gravity = Vec3(0.0, 0.0, -9.81);
  const StepRig still(p, kNeedleAway);
  double pulled[2];                            // [m] whole, cut
  for (int cut = 0; cut < 2; ++cut) {
    StepRig rig(p, kNeedleAway, across(still.state, 9.5e-3));
    if (cut) rig.input.tools[kLeft].jaw = 0.0;
    rig.step();
    ASSERT_EQ(rig.state.knot.cuts, cut);
    rig.input.tools[kLeft].jaw = 1.0;
    for (int k = 0; k < 40; ++k) {             // the driver leaves along its shaft
      rig.input.tools[kLeft].pose.position += 1e-3 * (rig.input.tools[kLeft].pose.orientation * Vec3::UnitZ());
      rig.step();
    }
    pulled[cut] = pulledFromItsFall(rig);
    if (cut) { EXPECT_EQ(rig.state.threadContacts.cut[kCutSegment], 1); EXPECT_EQ(rig.state.strand.tension[kCutSegment], 0.0); }
  }
  EXPECT_LT(pulled[1], 1e-6);                  // nothing but its own weight and the air moves it
  EXPECT_GT(pulled[0], 1e-3);                  // the needle, which is held, holds the whole thread
}

/// How far a driver that holds the needle, cut off, takes the other piece along that lies across before its jaws, moved by 20 mm.  [m]
double takenAlongByADriverWithTheNeedle() {
  constexpr int kPiece = 30;                   // nodes
  StepRig rig(withBlades(true), kNeedleAway);
  Pose& driver = rig.input.tools[kRight].pose;
  const Vec3 way = driver.orientation * Vec3::UnitX(), before = driver.position;
  rig.state.threadContacts.cut[kPiece - 1] = 1;
  for (int i = 0; i < kPiece; ++i)             // half way up the jaws, 10 mm before them
    rig.state.strand.position[i] = driver.apply(Vec3(10e-3, rig.model.strand.place[i] - rig.model.strand.place[kPiece / 2], 6e-3));
  for (int k = 0; k < 100; ++k) {
    driver.position += 0.2e-3 * way;
    rig.step();
  }
  return (rig.state.strand.position[kPiece / 2] - before).dot(way) - 10e-3;
}

/// Between the two ends of a cut there is no thread: jaws that held a place half-way to the other piece, which had fallen to the ground, drew with 672 N.
TEST(Cutter, JawsLetGoOfAnEndThatSlipsOutOfThem) {
  StepRig rig = closedOnThread(false, 2e-3);
  rig.step();
  State& s = rig.state;
  ASSERT_GE(s.tools[kLeft].threadCoordinate, rig.model.strand.place[kCutSegment]);
  s.threadContacts.cut[kCutSegment - 1] = 1;
  for (int i = 0; i < kCutSegment; ++i) s.strand.position[i].z() -= 12.0;   // [m] on its way for a second and a half
  const Vec3 away = (s.strand.position[kCutSegment] - s.strand.position[kCutSegment + 1]).normalized();
  double most = 0.0;                           // [N]
  int steps = 0;
  for (; s.tools[kLeft].threadCoordinate >= 0.0 && steps < 4000; ++steps) {
    rig.input.tools[kLeft].pose.position += 2e-5 * away;
    rig.step();
    most = std::max({most, s.tools[kLeft].threadForce.norm(), *std::max_element(s.strand.tension.begin(), s.strand.tension.end())});
  }
  EXPECT_LT(s.tools[kLeft].threadCoordinate, 0.0);
  EXPECT_GT(most, 8.0);                        // it did slip
  EXPECT_LT(most, 10.0);
}

TEST(Cutter, JawsThatHoldANeedleThatIsCutOffAreNoLessInTheWayOfItsThread) { EXPECT_GT(takenAlongByADriverWithTheNeedle(), 5e-3); }

}  // namespace
}  // namespace halsted
