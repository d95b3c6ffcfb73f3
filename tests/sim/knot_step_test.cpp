/// Knots in the whole step: tissue, holes, thread against thread and tools, two hands that draw a loosely laced knot tight on a wall.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/fields.h"
#include "sim/strand/knot_diagram.h"
#include "sim/suture/knot_place.h"
#include "tests/sim/laced_wall.h"

namespace halsted {
namespace {

constexpr double kDrawn = 3.0, kWanted = 5.0;  // [N] with which the ends are drawn; that a knot must bear
constexpr double kSeconds = 1.0;               // [s]

struct Tightened : LacedWall {
  Tightened(std::span<const int> halfTwists) : LacedWall(halfTwists) {
    drawTight(kDrawn, kSeconds);
    EXPECT_TRUE(finite());
    EXPECT_EQ(state.threadContacts.dropped, 0) << "thread has passed through thread";
  }
};

std::string reading(const StepRig& rig) { return knotName(readKnot(rig.state.strand.position)); }

void report(const StepRig& w, const TensileTest::Result& r) {
  std::printf("%s: bore %.2f N, opened %.2f mm, %s\n", reading(w).c_str(), r.most, 1e3 * r.gained, r.outcome());
}

TEST(KnotInTheStep, ASingleThrowDrawnTightIsReadAndSlips) {
  Tightened w(std::vector<int>{3});
  EXPECT_EQ(w.seen(Quantity::kThrows), 1);
  EXPECT_EQ(w.seen(Quantity::kKnotLocks), 0);
  const KnotPlace place = placeOfKnot(w.model, w.state).value();
  EXPECT_LT(0.5 * (place.tail - place.tailOut + place.tipOut - place.tip), 8e-3) << "it has been drawn tight";
  const TensileTest::Result r = TensileTest(w).load(kWanted);
  report(w, r);
  EXPECT_TRUE(r.slipped());
  EXPECT_LT(r.most, 1.5);
}

/// Neither the pull of two still hands nor its end shakes the tissue, and no thread is pulled harder than they pull.
TEST(KnotInTheStep, TheWallUnderAThrowDrawnTightComesToRest) {
  LacedWall w(std::vector<int>{3});
  w.drawTight(kDrawn, 0.6);
  double fastest = 0.0, tension = 0.0;         // [m] in a step, of any vertex; [N]
  for (int k = 0; k < 200; ++k) {
    const std::vector<Vec3> before = w.state.tissue.position;
    w.drawTight(kDrawn, w.model.params.dt);
    for (std::size_t v = 0; v < before.size(); ++v) fastest = std::max(fastest, (w.state.tissue.position[v] - before[v]).norm());
  }
  w.letGo(0.0);
  for (int k = 0; k < 300; ++k) {
    w.step();
    tension = std::max(tension, *std::max_element(w.state.strand.tension.begin(), w.state.strand.tension.end()));
  }
  std::printf("tissue moves %.1f um a step; %.2f N in the thread after the hands open\n", 1e6 * fastest, tension);
  EXPECT_LT(fastest, 5e-6);
  EXPECT_LT(tension, 1.05 * kDrawn);
}

/// Thread of little strength bears what it is said to bear, ends that fly back from hands that open included, and parts above it.
TEST(KnotInTheStep, ThreadPartsUnderAPullBeyondItsStrengthOnly) {
  LacedWall weak(std::vector<int>{3}), strong(std::vector<int>{3});
  weak.model.params.thread.breakingTension = 0.8 * kDrawn;
  strong.model.params.thread.breakingTension = 1.2 * kDrawn;
  for (LacedWall* w : {&weak, &strong}) {
    w->drawTight(kDrawn, 0.6);
    w->letGo(0.3);
  }
  EXPECT_GT(weak.seen(Quantity::kThreadBreaks), 0);
  EXPECT_EQ(strong.seen(Quantity::kThreadBreaks), 0);
}

TEST(KnotInTheStep, ASquareKnotIsNamedAndHoldsFiveNewtons) {
  Tightened w(std::vector<int>{3, -3});
  EXPECT_EQ(reading(w), "square");
  EXPECT_EQ(w.seen(Quantity::kThrows), 2);
  EXPECT_EQ(w.seen(Quantity::kKnotLocks), 1);
  EXPECT_EQ(w.seen(Quantity::kWrongThrows), 0);
  const TensileTest::Result r = TensileTest(w).load(kWanted);
  report(w, r);
  EXPECT_TRUE(r.held);
}

TEST(KnotInTheStep, AGrannyIsAWrongThrowAndASurgeonsKnotBeginsWithTwoTurns) {
  LacedWall granny(std::vector<int>{3, 3}), surgeons(std::vector<int>{5, -3, 3});
  granny.drawTight(1.0, kSeconds);
  surgeons.drawTight(1.0, kSeconds);
  EXPECT_EQ(reading(granny), "granny");
  EXPECT_EQ(granny.seen(Quantity::kWrongThrows), 1);
  EXPECT_EQ(granny.seen(Quantity::kKnotLocks), 0);
  EXPECT_EQ(reading(surgeons), "surgeon's");
  EXPECT_EQ(surgeons.seen(Quantity::kFirstTurns), 2);
  EXPECT_EQ(surgeons.seen(Quantity::kKnotLocks), 2);
}

TEST(KnotInTheStep, LettingGoBeforeTighteningLeavesNothingThatHolds) {
  LacedWall w(std::vector<int>{3});
  w.letGo(0.5);
  EXPECT_TRUE(w.finite());
  EXPECT_LT(w.stitchTension(), 0.05);
  const TensileTest::Result r = TensileTest(w).load(kWanted);
  report(w, r);
  EXPECT_TRUE(r.slipped());
  EXPECT_LT(r.most, 0.5);
}

TEST(KnotInTheStep, ARestoredRunGoesOnIdentically) {
  LacedWall w(std::vector<int>{3, -3});
  w.drawTight(1.0, 0.15);
  const std::vector<std::uint8_t> bytes = save(w.state);
  LacedWall other(std::vector<int>{3, -3});
  std::string error;
  ASSERT_TRUE(load(bytes, other.state, error)) << error;
  other.input = w.input;
  for (int k = 0; k < 40; ++k) {
    w.step();
    other.step();
  }
  EXPECT_GT(w.state.threadContacts.count, 0);
  EXPECT_EQ(hash(w.state), hash(other.state)) << diff(w.state, other.state);
}

}  // namespace
}  // namespace halsted
