/// What no surgeon should do to a thread that can be tied: it slips, breaks or comes out; it never explodes.
#include <gtest/gtest.h>

#include <numbers>

#include "tests/scenes/tied_wall.h"

namespace halsted {
namespace {

constexpr double kStep = 1e-3;                 // [s]

struct Abused : TiedWall {
  double mostForce = 0.0, mostTension = 0.0;   // [N] on a hand; in the thread

  /// Moves a hand straight to a place at a speed, jaws as told.
  void move(int hand, const Vec3& to, double speed) {   // [m], [m/s]
    Vec3& at = input.tools[hand].pose.position;
    while ((to - at).norm() > speed * kStep) {
      at += speed * kStep * (to - at).normalized();
      look();
    }
  }
  void jaw(int hand, double opening) {         // [1]
    input.tools[hand].jaw = opening;
    for (int k = 0; k < 100; ++k) look();
  }
  void look() {
    step();
    for (const ToolState& t : state.tools) mostForce = std::max(mostForce, t.force.norm());
    for (double t : state.strand.tension) mostTension = std::max(mostTension, t);
  }
  /// A hand takes the thread at a coordinate; its jaws open across the thread, which runs in the x-z plane.
  void take(int hand, double coordinate) {     // [m]
    input.tools[hand].pose.orientation = Quat(std::numbers::sqrt2 / 2.0, 0.0, 0.0, std::numbers::sqrt2 / 2.0);
    move(hand, strandPoint(model.strand, state.strand, coordinate) + 15e-3 * Vec3::UnitZ(), 0.2);
    move(hand, strandPoint(model.strand, state.strand, coordinate), 0.1);
    jaw(hand, 0.0);
  }
  double holeAt(int h) const { return state.strand.holes[h].coordinate; }   // [m]
};

TEST(AbusedThread, WoundRoundBothToolsAndTornApartSlipsOrBreaks) {
  Abused w;
  w.take(kLeft, w.holeAt(1) + 50e-3);
  ASSERT_GT(w.state.tools[kLeft].threadCoordinate, 0.0);
  const Vec3 middle(2e-3, 12e-3, 34e-3);       // [m]
  w.move(kRight, middle + Vec3(12e-3, 0.0, 0.0), 0.1);
  w.jaw(kRight, 0.0);
  for (int k = 0; k <= 1500; ++k) {            // twice round each other
    const double a = 4.0 * std::numbers::pi * k / 1500.0;   // [rad]
    const Vec3 arm = 12e-3 * Vec3(std::cos(a), std::sin(a), 0.0);
    w.input.tools[kRight].pose.position = middle + arm;
    w.input.tools[kLeft].pose.position += 0.2 * (middle - arm + 8e-3 * Vec3::UnitZ() - w.input.tools[kLeft].pose.position);
    w.look();
  }
  w.move(kLeft, Vec3(-60e-3, 12e-3, 50e-3), 0.5);
  w.move(kRight, Vec3(60e-3, 12e-3, 50e-3), 0.5);
  for (int k = 0; k < 500; ++k) w.look();
  std::printf("largest force on a hand %.1f N, tension %.1f N, breaks %.0f\n", w.mostForce, w.mostTension, w.seen(Quantity::kThreadBreaks));
  EXPECT_TRUE(w.finite());
  EXPECT_LT(w.mostForce, 2.0 * w.model.params.thread.breakingTension + 10.0);
}

TEST(AbusedThread, BothHandsOnOnePlacePullAgainstEachOtherUntilItSlips) {
  Abused w;
  const double place = w.holeAt(1) + 40e-3;    // [m]
  w.take(kLeft, place);
  w.take(kRight, place + 3e-3);
  ASSERT_GT(w.state.tools[kLeft].threadCoordinate, 0.0);
  ASSERT_GT(w.state.tools[kRight].threadCoordinate, 0.0);
  w.move(kRight, w.input.tools[kRight].pose.position + 40e-3 * Vec3::UnitX(), 0.1);
  for (int k = 0; k < 300; ++k) w.look();
  std::printf("largest force on a hand %.1f N\n", w.mostForce);
  EXPECT_TRUE(w.finite());
  EXPECT_LT(w.mostForce, 20.0) << "jaws hold thread to 8 N";
}

}  // namespace
}  // namespace halsted
