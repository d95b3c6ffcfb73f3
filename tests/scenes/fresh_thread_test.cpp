/// The end of one stitch and the beginning of the next (sim/suture/fresh_thread.h): when a thread is handed, when not, and what stays.
#include "sim/suture/fresh_thread.h"

#include <gtest/gtest.h>

#include "sim/whole_seam.h"
#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

/// One stitch that draws two ends together, a locked knot on it, both tails still held.
struct TiedEnds : SewnEnds {
  TiedEnds() : SewnEnds({.stitches = 1, .spacing = 4e-3, .depth = 5e-3, .gap = 5e-3, .assist = true, .spare = 1}) {
    tighten();
    tieOff();
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  /// As blades do.
  void cutOff() { state.threadContacts.cut[threadSpot(model.strand, state.assist->tip + 12e-3).node] = 1; }
  /// Up, and aside.
  void goAside() {
    const Vec3 from[2] = {input.tools[kLeft].pose.position, input.tools[kRight].pose.position};
    for (int k = 1; k <= 400; ++k) {
      for (int hand = 0; hand < kHands; ++hand) {
        const Vec3 to(hand == kLeft ? -0.07 : 0.07, 0.04, 0.06);
        input.tools[hand].pose.position = from[hand] + k / 400.0 * (to - from[hand]);
      }
      step();
    }
  }
  /// Returns why not.
  ThreadRefusal ask() {
    input.command.kind = Command::Kind::kFreshThread;
    step();
    input.command = {};
    return static_cast<ThreadRefusal>(state.supply->refusal);
  }
  double seen(Quantity q) const { return out.seen[static_cast<int>(q)]; }   // unit of the quantity
  bool said(EventKind kind) const {
    for (int i = 0; i < out.eventCount; ++i)
      if (out.events[i].kind == kind) return true;
    return false;
  }
  void finish() {
    letGo();
    cutOff();
    goAside();
  }
};

TEST(FreshThread, IsRefusedUntilTheHandsAreEmptyTheStitchCutOffAndTheDriverClear) {
  TiedEnds ends;
  EXPECT_EQ(ends.ask(), ThreadRefusal::kHandsFull);
  EXPECT_TRUE(ends.said(EventKind::kThreadRefused));
  ends.letGo();
  EXPECT_EQ(ends.ask(), ThreadRefusal::kNotTied);                // tied, but the needle hangs on it
  EXPECT_EQ(ends.seen(Quantity::kStitches), 0.0);
  ends.cutOff();
  ends.step();
  EXPECT_EQ(ends.seen(Quantity::kStitches), 1.0);
  for (ToolSample& tool : ends.input.tools) tool.pose.position = Vec3(tool.pose.position.x() > 0.0 ? 4e-3 : -4e-3, 20e-3, 0.0);
  ends.run(50);
  EXPECT_EQ(ends.ask(), ThreadRefusal::kInTheWay);               // thread from here would hang through the bowel
  EXPECT_EQ(ends.state.stitches->count, 0);
  EXPECT_EQ(ends.state.supply->left, 1);
}

/// How little the tissue feels of it is measured where hands have tied (tests/app/lembert_test.cpp): here the knot was set down by the test.
TEST(FreshThread, TheStitchGoesOnThroughItsHolesWithTheThreadsTension) {
  TiedEnds ends;
  ends.finish();
  const double gap = measureJoin(ends.model, ends.state).wallGap;   // [m]
  const Hole hole = ends.state.strand.holes[0];
  ASSERT_EQ(ends.ask(), ThreadRefusal::kNone);
  ASSERT_EQ(ends.state.stitches->count, 1);
  const TiedStitch& stitch = ends.state.stitches->stitch[0];
  ASSERT_EQ(stitch.holeCount, 2);
  EXPECT_EQ(stitch.hole[0].tet, hole.tet);
  EXPECT_EQ(stitch.hole[0].weight, hole.weight);
  EXPECT_GT(stitch.tension, 0.2);
  EXPECT_NEAR(2.0 * stitch.tension, hole.force.norm(), 0.5 * hole.force.norm());   // two strands pull at a hole
  ends.run(1500);
  EXPECT_LT(measureWholeSeam(ends.model, ends.state).wallGap, gap + 0.3e-3);
  EXPECT_EQ(ends.state.metrics.tears, 0);
}

TEST(FreshThread, LoadsTheDriverAndCountsAnew) {
  TiedEnds ends;
  ends.finish();
  ends.state.metrics.biteCount = 2;
  ASSERT_EQ(ends.ask(), ThreadRefusal::kNone);
  EXPECT_TRUE(ends.said(EventKind::kStitchFinished));
  EXPECT_TRUE(ends.said(EventKind::kThreadHanded));
  EXPECT_TRUE(ends.state.tools[kRight].holdsNeedle);
  EXPECT_EQ(ends.state.strand.holeCount, 0);
  EXPECT_FALSE(ends.state.assist->placed);
  EXPECT_EQ(ends.seen(Quantity::kBites), 0.0);
  EXPECT_EQ(ends.seen(Quantity::kKnotLocks), 0.0);
  EXPECT_EQ(ends.seen(Quantity::kStitches), 1.0);
  EXPECT_EQ(ends.seen(Quantity::kThreadsLeft), 0.0);
  const double straight = (ends.state.strand.position.front() - ends.state.strand.position.back()).norm();   // [m]
  EXPECT_NEAR(straight, ends.model.strand.length, 1e-3);         // hangs
  for (ToolSample& tool : ends.input.tools) tool.jaw = 1.0;
  ends.input.tools[kRight].jaw = 0.0;
  ends.run(20);
  EXPECT_TRUE(ends.state.tools[kRight].holdsNeedle);
}

TEST(FreshThread, RunsOutAndSaysSo) {
  TiedEnds ends;
  ends.finish();
  ASSERT_EQ(ends.ask(), ThreadRefusal::kNone);
  EXPECT_EQ(ends.ask(), ThreadRefusal::kNoneLeft);
  EXPECT_TRUE(ends.said(EventKind::kThreadRefused));
  EXPECT_EQ(ends.state.stitches->count, 1);
}

TEST(FreshThread, AStateSavedAfterItGoesOnTheSame) {
  TiedEnds ends;
  ends.finish();
  const std::vector<std::uint8_t> before = save(ends.state);
  ASSERT_EQ(ends.ask(), ThreadRefusal::kNone);
  ends.run(100);
  const std::uint64_t wanted = hash(ends.state);
  std::string error;
  ASSERT_TRUE(load(before, ends.state, error)) << error;
  ASSERT_EQ(ends.ask(), ThreadRefusal::kNone);
  ends.run(50);
  const std::vector<std::uint8_t> after = save(ends.state);
  ASSERT_TRUE(load(after, ends.state, error)) << error;
  ends.run(50);
  EXPECT_EQ(hash(ends.state), wanted);
}

}  // namespace
}  // namespace halsted
