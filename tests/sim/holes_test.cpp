/// The thread in its channels through the wall: it advances only past a tension, slack goes from the needle's side first, and nothing
/// is teleported (paper 003 Fig. 9 as behaviour; physics.md A1 10 to 13, B4).
#include <gtest/gtest.h>

#include <numbers>

#include "tests/sim/threaded_wall.h"

namespace halsted {
namespace {

constexpr double kHeight = 9.2e-3;             // [m] of the stitches above the foot

/// Straight through the wall: needle on the -x side, tail on the +x side, one bite.
struct OneBite : ThreadedWall {
  OneBite() : ThreadedWall(frame(Vec3(-12.7e-3, 12.3e-3, kHeight) - 26e-3 / std::numbers::pi * Vec3::UnitZ(), Vec3::UnitZ(), -Vec3::UnitX())) {
    thread({{-12.7e-3, 12.3e-3, kHeight}, {0.5, 12.3e-3, kHeight}});
  }
};

/// Two bites 8 mm apart with a loop of slack between them; needle and tail on the +x side.
struct TwoBites : ThreadedWall {
  TwoBites() : ThreadedWall(frame(Vec3(14.7e-3, 16.3e-3, kHeight) - 26e-3 / std::numbers::pi * Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitX())) {
    std::vector<Vec3> path{{14.7e-3, 16.3e-3, kHeight}};
    for (int i = 0; i <= 180; ++i) {
      const double a = i * std::numbers::pi / 180.0;           // [rad]
      path.emplace_back(-3e-3 - 4e-3 * std::sin(a), 12.3e-3 + 4e-3 * std::cos(a), kHeight);
    }
    path.emplace_back(0.5, 8.3e-3, kHeight);
    thread(path);
  }
  double slack() const { return inside(1, 2) - apart(1, 2); }  // [m] between the bites
};

/// Coordinates of all holes [m].
std::vector<double> coordinates(const StrandState& s) {
  std::vector<double> all;                     // [m]
  for (int i = 0; i < s.holeCount; ++i) all.push_back(s.holes[i].coordinate);
  return all;
}

TEST(Channel, ThreadStaysPutBelowItsDragAndSlidesAboveIt) {
  OneBite w;
  w.run(300);
  const double drag = w.model.params.thread.channelDrag * kWallX;              // [N] of a straight channel: no capstan
  const std::vector<double> start = coordinates(w.state.strand);               // [m]
  double stuck = 0.0, sliding = 0.0;             // [N] largest tension with both holes at rest; mean while running
  int counted = 0;
  for (int k = 0; k < 2000; ++k) {
    w.pull(-5e-6 * Vec3::UnitX());
    const double tension = w.needleTension();    // [N]
    const double moved = start[0] - w.state.strand.holes[0].coordinate;        // [m]
    if (moved < 1e-6) stuck = std::max(stuck, tension);
    if (tension < 0.4 * drag && k < 20) { ASSERT_EQ(coordinates(w.state.strand), start) << "slid at " << tension << " N"; }
    if (k >= 1000) { sliding += tension; ++counted; }
  }
  sliding /= counted;
  RecordProperty("drag_n", std::to_string(drag));
  RecordProperty("stuck_n", std::to_string(stuck));
  RecordProperty("sliding_n", std::to_string(sliding));
  RecordProperty("advanced_mm", std::to_string(1e3 * (start[0] - w.state.strand.holes[0].coordinate)));
  EXPECT_NEAR(stuck / drag, 1.0, 0.25);
  EXPECT_NEAR(sliding / drag, 1.0, 0.25);
  EXPECT_NEAR(start[0] - w.state.strand.holes[0].coordinate, 10e-3, 0.5e-3);   // what the hand drew came through
}

TEST(Channel, AHeldBackPullMovesNothing) {
  OneBite w;
  w.run(300);
  const std::vector<double> start = coordinates(w.state.strand);               // [m]
  for (int k = 0; k < 5; ++k) w.pull(-1e-6 * Vec3::UnitX());
  w.run(500);
  ASSERT_GT(w.needleTension(), 1e-4);
  ASSERT_LT(w.needleTension(), 0.9 * w.model.params.thread.channelDrag * kWallX);
  EXPECT_NEAR(w.state.strand.holes[0].coordinate, start[0], 1e-9);
}

TEST(Channel, SlackIsUsedUpFromTheNeedleSideFirst) {
  TwoBites w;
  w.run(300);
  const std::vector<double> start = coordinates(w.state.strand);               // [m]
  const double slack = w.slack();                // [m]
  ASSERT_GT(slack, 6e-3);
  double drawnFirst = -1.0, left = 0.0;          // [m] through the near hole, and slack left, when the far bite begins to move
  for (int k = 0; k < 2500; ++k) {
    w.pull(1e-5 * Vec3::UnitX());
    if (drawnFirst < 0.0 && start[0] - w.state.strand.holes[0].coordinate > 0.2e-3) {
      drawnFirst = start[3] - w.state.strand.holes[3].coordinate;
      left = w.slack();
    }
  }
  RecordProperty("slack_mm", std::to_string(1e3 * slack));
  RecordProperty("drawn_first_mm", std::to_string(1e3 * drawnFirst));
  RecordProperty("slack_left_mm", std::to_string(1e3 * left));
  ASSERT_GT(drawnFirst, 0.0) << "the far bite never moved";
  EXPECT_GT(drawnFirst, 0.9 * slack);
  EXPECT_LT(left, 0.1 * slack);
  EXPECT_GT(start[0] - w.state.strand.holes[0].coordinate, 5e-3);              // and then it runs
}

/// The slack, then the tight loop and the running thread.
TEST(Channel, PullingKeepsLengthOrderAndContinuity) {
  TwoBites w;
  w.run(300);
  double worst = 0.0, jump = 0.0, slid = 0.0;    // [1], [m], [m]
  for (int k = 0; k < 2500; ++k) {
    const StrandState before = w.state.strand;
    w.pull(1e-5 * Vec3::UnitX());
    const StrandState& s = w.state.strand;
    ASSERT_EQ(s.holeCount, 4);
    double length = 0.0;                         // [m]
    for (std::size_t i = 0; i + 1 < s.position.size(); ++i) length += (s.position[i + 1] - s.position[i]).norm();
    worst = std::max(worst, std::fabs(length / w.model.strand.length - 1.0));
    for (std::size_t i = 0; i < s.position.size(); ++i) jump = std::max(jump, (s.position[i] - before.position[i]).norm());
    for (int h = 0; h < 4; ++h) slid = std::max(slid, std::fabs(s.holes[h].coordinate - before.holes[h].coordinate));
    for (int h = 0; h + 1 < 4; ++h) ASSERT_LT(s.holes[h].coordinate, s.holes[h + 1].coordinate) << "step " << k;
  }
  RecordProperty("length_error", std::to_string(worst));
  RecordProperty("largest_node_step_mm", std::to_string(1e3 * jump));
  RecordProperty("largest_slide_mm", std::to_string(1e3 * slid));
  EXPECT_LT(worst, 1e-3);
  EXPECT_LT(jump, 1e-3);                         // 1 m/s, a hundred times the hand
  EXPECT_LE(slid, 1e-3 + 1e-12);
}

TEST(Channel, HoldsStillWhenNobodyPulls) {
  TwoBites w;
  w.run(1000);
  const std::vector<double> start = coordinates(w.state.strand);               // [m]
  w.run(1000);
  for (int h = 0; h < 4; ++h) EXPECT_NEAR(w.state.strand.holes[h].coordinate, start[h], 1e-6) << "hole " << h;
}

/// What the holes pull on the strand they push on the tissue: the tools and the foot carry it, none is lost.
TEST(Channel, TissueCarriesWhatTheStrandIsHeldWith) {
  OneBite w;
  w.run(300);
  for (int k = 0; k < 3; ++k) w.pull(-5e-6 * Vec3::UnitX());
  w.run(1500);
  std::vector<Vec3> nodal(w.state.tissue.position.size(), Vec3::Zero());       // [N]
  gatherHoleForces(w.model, w.state.strand, nodal);
  Vec3 onTissue = Vec3::Zero();                  // [N]
  for (const Vec3& f : nodal) onTissue += f;
  EXPECT_LT((onTissue - w.state.tools[kRight].needleForce * -1.0).norm(), 0.02 * onTissue.norm() + 1e-6);
}

}  // namespace
}  // namespace halsted
