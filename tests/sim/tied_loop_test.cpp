/// Where a knot lies on its thread, and whether its loop is drawn or hangs.
#include "sim/suture/tied_loop.h"

#include <gtest/gtest.h>

#include "sim/suture/knot_place.h"
#include "sim/suture/knot_watch.h"
#include "tests/sim/laced_wall.h"

namespace halsted {
namespace {

/// A stitch whose two strands press on each other only where a test says.
struct Pressed : LacedWall {
  Pressed() : LacedWall(std::vector<int>{3}) { state.threadContacts.count = 0; }

  double first() const { return state.strand.holes[0].coordinate; }
  double last() const { return state.strand.holes[state.strand.holeCount - 1].coordinate; }
  int pieceAt(double coordinate) const { return threadSpot(model.strand, coordinate).node - 1; }   // [m]
  /// So far before the first hole and past the last.
  void press(double tail, double tip, double force) {            // [m], [N]
    ThreadContact& c = state.threadContacts.contacts[state.threadContacts.count++];
    c.sample = pieceAt(first() - tail) * kMostSamples;
    c.partner = pieceAt(last() + tip);
    c.normalForce = force;
  }
};

TEST(KnotPlace, IsWhereTheTwoStrandsPressOnEachOther) {
  Pressed w;
  EXPECT_FALSE(placeOfKnot(w.model, w.state).has_value());
  for (double in : {3e-3, 4e-3, 5e-3, 6e-3}) w.press(in, in + 2e-3, 0.1);
  const KnotPlace place = placeOfKnot(w.model, w.state).value();
  const double node = w.model.strand.segment;  // [m]
  EXPECT_NEAR(w.first() - place.tail, 3e-3, node);
  EXPECT_NEAR(place.tip - w.last(), 5e-3, node);
  EXPECT_NEAR(w.first() - place.tailOut, 6e-3, node);
  EXPECT_NEAR(place.tipOut - w.last(), 8e-3, node);
}

/// A tail that lay over its loop was taken for the knot: a loop that hung by 7 mm seemed tight.
TEST(KnotPlace, PassesOverAStrandThatOnlyLiesAcrossTheLoop) {
  Pressed w;
  for (double in : {8e-3, 9e-3, 10e-3}) w.press(in, in, 0.1);
  const KnotPlace before = placeOfKnot(w.model, w.state).value();
  w.press(20e-3, 1e-3, 0.01);
  w.press(1e-3, 15e-3, 0.002);
  const KnotPlace place = placeOfKnot(w.model, w.state).value();
  EXPECT_EQ(place.tail, before.tail);
  EXPECT_EQ(place.tip, before.tip);
}

/// Under a third throw that is drawn tight the first throw's turn pushes with a fiftieth: passed over, it was taken for thread that hangs (`lembert`: 3.4 mm,
/// where 0.4 were read before that throw was drawn).
TEST(KnotPlace, BeginsWithATurnThatLiesAgainstItHoweverLightly) {
  Pressed w;
  for (double in : {8e-3, 9e-3, 10e-3}) w.press(in, in, 0.1);
  w.press(5e-3, 5e-3, 0.006);
  const KnotPlace apart = placeOfKnot(w.model, w.state).value();
  const double node = w.model.strand.segment;  // [m]
  EXPECT_NEAR(w.first() - apart.tail, 8e-3, node) << "it lies 3 mm off";
  const auto at = [&](double coordinate) -> Vec3& { return w.state.strand.position[w.pieceAt(coordinate) + 1]; };   // [m]
  at(w.first() - 5e-3) = at(w.first() - 9e-3) + Vec3(0.5e-3, 0.0, 0.0);
  const KnotPlace place = placeOfKnot(w.model, w.state).value();
  EXPECT_NEAR(w.first() - place.tail, 5e-3, node);
  EXPECT_EQ(place.tip, apart.tip);
  EXPECT_EQ(place.tailOut, apart.tailOut);
}

/// The loop through the wall of two laced ends that hands have drawn with 3 N.
struct Drawn : LacedWall {
  Drawn(std::span<const int> halfTwists) : LacedWall(halfTwists) { drawTight(3.0, 1.0); }
  TiedLoop loop() const {
    const KnotPlace place = placeOfKnot(model, state).value();
    return {place.tail, place.tip};
  }
  double thread() const { return loop().tip - loop().tail; }     // [m]
};

/// What is written down of it, too, while nothing is felt of it.
TEST(KnotPlace, IsWrittenDownAndStaysWhereItLayWhileNothingIsFelt) {
  Drawn w(std::vector<int>{3});
  const auto look = [&] {
    w.state.step = 0;
    watchKnots(w.model, w.state, w.out);
    return w.state.knot;
  };
  const KnotState felt = look();
  EXPECT_EQ(felt.tail, w.loop().tail);
  EXPECT_EQ(felt.tip, w.loop().tip);
  for (int i = 0; i < w.state.threadContacts.count; ++i) w.state.threadContacts.contacts[i].normalForce = 0.0;
  const KnotState after = look();
  EXPECT_EQ(after.throws, 1);
  EXPECT_EQ(after.tail, felt.tail);
  EXPECT_EQ(after.tip, felt.tip);
}

/// However long its way over the wall's edge is.
TEST(TiedLoop, AThrowIsDrawnDownOnTheWallAndItsLoopIsTaut) {
  const Drawn w(std::vector<int>{3});
  std::printf("%.2f mm of thread in the loop, %.2f N\n", 1e3 * w.thread(), loopPull(w.model, w.state, w.loop()));
  EXPECT_GT(w.thread(), 3.0 * kWallX);
  EXPECT_TRUE(isTaut(w.model, w.state, w.loop()));
  EXPECT_EQ(loopSlack(w.model, w.state, w.loop()), 0.0);
}

/// Two throws laced before either is drawn lock each other where they meet, off the wall: an air knot.
TEST(TiedLoop, ThrowsThatLockEachOtherOffTheWallLeaveALoopThatHangs) {
  const Drawn w(std::vector<int>{3, -3});
  const double slack = loopSlack(w.model, w.state, w.loop());    // [m]
  std::printf("%.2f mm of thread in the loop, of which %.2f hang; %.4f N\n", 1e3 * w.thread(), 1e3 * slack, loopPull(w.model, w.state, w.loop()));
  EXPECT_FALSE(isTaut(w.model, w.state, w.loop()));
  EXPECT_GT(slack, 10e-3);
  EXPECT_NEAR(slack, w.thread() - 2.0 * kWallX, 2e-3);           // the stitch goes straight through
}

}  // namespace
}  // namespace halsted
