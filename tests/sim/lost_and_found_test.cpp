/// A needle let go and taken up again, a tail drawn out of the tissue: what a trainee does in the first hour.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/sim/threaded_wall.h"

namespace halsted {
namespace {

constexpr double kStitchHeight = 9.2e-3;             // [m] of the stitch above the foot
constexpr double kFalls = 9.81;                // [m/s^2]

SimParams heavyWall() {
  SimParams p = wallParams();
  p.gravity = -kFalls * Vec3::UnitZ();
  return p;
}

/// Straight through the wall: needle on the -x side, tail on the +x side, one bite.
struct Threaded : ThreadedWall {
  Pose inTool;                                 // of the needle, as it was loaded

  explicit Threaded(const SimParams& p)
      : ThreadedWall(frame(Vec3(-12.7e-3, 12.3e-3, kStitchHeight) - 26e-3 / std::numbers::pi * Vec3::UnitZ(), Vec3::UnitZ(), -Vec3::UnitX()), p) {
    thread({{-12.7e-3, 12.3e-3, kStitchHeight}, {0.5, 12.3e-3, kStitchHeight}});
    inTool = state.tools[kRight].needleInTool;
  }
  ToolSample& hand() { return input.tools[kRight]; }
  const ToolState& driver() const { return state.tools[kRight]; }

  /// Straight to a pose, at 100 mm/s.
  void reach(const Pose& to) {
    hand().pose.orientation = to.orientation;
    while ((to.position - hand().pose.position).norm() > 1e-4) {
      const Vec3 way = to.position - hand().pose.position;
      hand().pose.position += std::min(1.0, 1e-4 / way.norm()) * way;
      step();
    }
  }
  /// Where the driver must be to hold the needle as it was loaded.
  Pose atNeedle() const {
    const Pose needle{state.strand.needle.position, state.strand.needle.orientation};
    return compose(needle, inverse(inTool));
  }
  void jaw(double opening) {                   // [1]
    hand().jaw = opening;
    run(150);
  }
};

TEST(LostAndFound, ADroppedNeedleHangsOnItsThreadAndSewsOnWhenItIsTakenUp) {
  Threaded w(heavyWall());
  w.run(300);
  ASSERT_TRUE(w.driver().holdsNeedle);
  const double before = w.state.strand.needle.position.z();            // [m]
  w.jaw(1.0);
  EXPECT_FALSE(w.driver().holdsNeedle);
  Pose aside = w.hand().pose;
  aside.position += 60e-3 * Vec3(-1.0, 0.0, 1.0).normalized();
  w.reach(aside);
  w.run(2000);
  EXPECT_LT(w.state.strand.needle.position.z(), before - 5e-3) << "nothing holds it but the thread";
  EXPECT_EQ(w.state.strand.holeCount, 2) << "its weight is less than the drag of the wall on the thread";
  EXPECT_LT(w.driver().force.norm(), 1e-9) << "an empty hand feels nothing";

  const Vec3 back = w.atNeedle().orientation * Vec3::UnitZ();          // [1] from the tips along the shaft
  w.reach({w.atNeedle().position + 30e-3 * back, w.atNeedle().orientation});
  w.reach(w.atNeedle());
  w.jaw(0.0);
  ASSERT_TRUE(w.driver().holdsNeedle);
  const double drawn = w.state.strand.holes[0].coordinate;             // [m]
  for (int k = 0; k < 3000; ++k) w.pull(-1e-5 * Vec3::UnitX());
  EXPECT_GT(drawn - w.state.strand.holes[0].coordinate, 10e-3);
  EXPECT_TRUE(w.finite());
}

TEST(LostAndFound, ATailDrawnOutLeavesNoHoleAndAWallAtRest) {
  Threaded w(wallParams());
  w.run(300);
  double tension = 0.0, force = 0.0, speed = 0.0;                      // [N], [N], [m/s] of the tissue
  int pulled = 0;
  for (; pulled < 4000 && w.state.strand.holeCount > 0; ++pulled) {
    w.pull(-5e-5 * Vec3::UnitX());
    for (double t : w.state.strand.tension) tension = std::max(tension, t);
    force = std::max(force, w.driver().force.norm());
    speed = std::max(speed, w.tissueSpeed());
  }
  RecordProperty("drawn_mm", std::to_string(0.05 * pulled));
  RecordProperty("largest_tension_n", std::to_string(tension));
  RecordProperty("largest_force_n", std::to_string(force));
  ASSERT_EQ(w.state.strand.holeCount, 0);
  EXPECT_LT(tension, 1.0) << "a thread that runs is held back by drag alone";
  EXPECT_LT(force, 1.0);
  EXPECT_LT(speed, 0.5);
  w.run(2000);
  EXPECT_TRUE(w.driver().holdsNeedle);
  EXPECT_LT(w.displacement(), 2e-5);
  EXPECT_TRUE(w.finite());
}

/// The needle cut off, the tail drawn back: the cut end goes in where the needle came out.
TEST(LostAndFound, ACutEndDrawnBackThroughTheWallComesFree) {
  SimParams p = wallParams();
  p.thread.knots = true;
  Threaded w(p);
  w.run(300);
  const double exit = w.state.strand.holes[1].coordinate;              // [m]
  w.state.threadContacts.cut[threadSpot(w.model.strand, exit + 8e-3).node] = 1;
  ToolSample& left = w.input.tools[kLeft];
  left.pose.orientation = Quat(std::numbers::sqrt2 / 2.0, 0.0, 0.0, std::numbers::sqrt2 / 2.0);   // jaws open across the thread
  const Vec3 grip = strandPoint(w.model.strand, w.state.strand, w.state.strand.holes[0].coordinate - 30e-3);   // [m]
  for (int k = 200; k >= 0; --k) {
    left.pose.position = grip + k * 1e-4 * Vec3::UnitZ();
    w.step();
  }
  left.jaw = 0.0;
  w.run(150);
  ASSERT_GT(w.state.tools[kLeft].threadCoordinate, 0.0);
  double tension = 0.0, force = 0.0;           // [N]
  for (int k = 0; k < 2000 && w.state.strand.holeCount > 0; ++k) {
    left.pose.position += 5e-5 * Vec3::UnitX();
    w.step();
    for (double t : w.state.strand.tension) tension = std::max(tension, t);
    force = std::max(force, w.state.tools[kLeft].force.norm());
  }
  RecordProperty("largest_tension_n", std::to_string(tension));
  RecordProperty("largest_force_n", std::to_string(force));
  ASSERT_EQ(w.state.strand.holeCount, 0);
  EXPECT_LT(tension, 1.0) << "a thread that runs is held back by drag alone";
  EXPECT_LT(force, 1.0);
  w.run(2000);
  EXPECT_LT(w.displacement(), 2e-5);
  EXPECT_TRUE(w.finite());
}

}  // namespace
}  // namespace halsted
