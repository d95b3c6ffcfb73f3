/// The end of one stitch and the beginning of the next (sim/suture/fresh_thread.h): when a thread is handed, when not, and what stays.
#include "sim/suture/fresh_thread.h"

#include <gtest/gtest.h>

#include "sim/whole_seam.h"
#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

/// As blades do.
void cutOff(SewnEnds& ends) { ends.state.threadContacts.cut[threadSpot(ends.model.strand, ends.state.assist->tip + 12e-3).node] = 1; }

/// Up, and aside.
void goAside(SewnEnds& ends) {
  const Vec3 from[2] = {ends.input.tools[kLeft].pose.position, ends.input.tools[kRight].pose.position};
  for (int k = 1; k <= 400; ++k) {
    for (int hand = 0; hand < kHands; ++hand) {
      const Vec3 to(hand == kLeft ? -0.07 : 0.07, 0.04, 0.06);
      ends.input.tools[hand].pose.position = from[hand] + k / 400.0 * (to - from[hand]);
    }
    ends.step();
  }
}

void finish(SewnEnds& ends) {
  ends.letGo();
  cutOff(ends);
  goAside(ends);
}

/// For a fresh thread. Returns why not.
ThreadRefusal ask(SewnEnds& ends) {
  ends.input.command.kind = Command::Kind::kFreshThread;
  ends.step();
  ends.input.command = {};
  return static_cast<ThreadRefusal>(ends.state.supply->refusal);
}

/// One stitch that draws two ends together, a locked knot on it, both tails still held.
struct TiedEnds : SewnEnds {
  TiedEnds() : SewnEnds({.stitches = 1, .spacing = 4e-3, .depth = 5e-3, .gap = 5e-3, .assist = true, .spare = 1}) {
    tighten();
    tieOff();
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  double seen(Quantity q) const { return out.seen[static_cast<int>(q)]; }   // unit of the quantity
  bool said(EventKind kind) const {
    for (int i = 0; i < out.eventCount; ++i)
      if (out.events[i].kind == kind) return true;
    return false;
  }
};

TEST(FreshThread, IsRefusedUntilTheHandsAreEmptyTheStitchCutOffAndTheDriverClear) {
  TiedEnds ends;
  EXPECT_EQ(ask(ends), ThreadRefusal::kHandsFull);
  EXPECT_TRUE(ends.said(EventKind::kThreadRefused));
  ends.letGo();
  EXPECT_EQ(ask(ends), ThreadRefusal::kNotTied);                // tied, but the needle hangs on it
  EXPECT_EQ(ends.seen(Quantity::kStitches), 0.0);
  cutOff(ends);
  ends.step();
  EXPECT_EQ(ends.seen(Quantity::kStitches), 1.0);
  for (ToolSample& tool : ends.input.tools) tool.pose.position = Vec3(tool.pose.position.x() > 0.0 ? 4e-3 : -4e-3, 20e-3, 0.0);
  ends.run(50);
  EXPECT_EQ(ask(ends), ThreadRefusal::kInTheWay);               // thread from here would hang through the bowel
  EXPECT_EQ(ends.state.stitches->count, 0);
  EXPECT_EQ(ends.state.supply->left, 1);
}

/// How little the tissue feels of it is measured where hands have tied (tests/app/lembert_test.cpp): here the knot was set down by the test.
TEST(FreshThread, TheStitchGoesOnThroughItsHolesWithTheThreadsTension) {
  TiedEnds ends;
  finish(ends);
  const double gap = measureJoin(ends.model, ends.state).wallGap;   // [m]
  const Hole hole = ends.state.strand.holes[0];
  ASSERT_EQ(ask(ends), ThreadRefusal::kNone);
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

/// It was kept as if it had been drawn tight: the next thread cured what the surgeon had left.
TEST(FreshThread, AStitchTiedLooseIsKeptLoose) {
  SewnEnds ends({.stitches = 1, .spacing = 4e-3, .depth = 5e-3, .gap = 3e-3, .assist = true, .spare = 1});
  ends.tieOff(9e-3);                           // nothing has been drawn
  finish(ends);
  const double slack = ends.out.seen[static_cast<int>(Quantity::kLoopSlack)];   // [m]
  EXPECT_GT(slack, 3e-3);
  const auto looseOnes = [&] {
    for (const auto& [name, value] : summariseStitches(ends.model, ends.state))
      if (name == "stitches_loose") return value;
    return -1.0;
  };
  EXPECT_EQ(looseOnes(), 1.0);
  ASSERT_EQ(ask(ends), ThreadRefusal::kNone);
  ASSERT_EQ(ends.state.stitches->count, 1);
  const TiedStitch& stitch = ends.state.stitches->stitch[0];
  EXPECT_NEAR(stitch.length - loopLength(ends.model, stitch, ends.state.tissue.position), slack, 0.3e-3);
  for (int i = 0; i < 500; ++i) ends.step();
  EXPECT_EQ(stitch.tension, 0.0);
  EXPECT_EQ(looseOnes(), 1.0);                 // counted as one of those kept
}

/// The coupling has no mass: free of the old thread it would be at its hand in one step, past all that is on the way.
TEST(FreshThread, AToolThatTheOldThreadHeldOffFollowsItsHand) {
  TiedEnds ends;
  finish(ends);
  ToolState& tool = ends.state.tools[kLeft];
  const Vec3 held = tool.proxy.position, off(0.0, 0.0, 5e-3);    // [m]
  ends.input.tools[kLeft].pose.position = held - off;
  tool.strandForce = ends.model.params.tools[kLeft].couplingStiffness * off;
  ASSERT_EQ(ask(ends), ThreadRefusal::kNone);
  EXPECT_LT((tool.proxy.position - held).norm(), 0.6e-3);        // 0.5 m/s
  ends.run(20);
  EXPECT_LT((tool.proxy.position - held + off).norm(), 1e-6);
}

TEST(FreshThread, LoadsTheDriverAndCountsAnew) {
  TiedEnds ends;
  finish(ends);
  ends.state.metrics.biteCount = 2;
  ASSERT_EQ(ask(ends), ThreadRefusal::kNone);
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
  finish(ends);
  ASSERT_EQ(ask(ends), ThreadRefusal::kNone);
  EXPECT_EQ(ask(ends), ThreadRefusal::kNoneLeft);
  EXPECT_TRUE(ends.said(EventKind::kThreadRefused));
  EXPECT_EQ(ends.state.stitches->count, 1);
}

TEST(FreshThread, AStateSavedAfterItGoesOnTheSame) {
  TiedEnds ends;
  finish(ends);
  const std::vector<std::uint8_t> before = save(ends.state);
  ASSERT_EQ(ask(ends), ThreadRefusal::kNone);
  ends.run(100);
  const std::uint64_t wanted = hash(ends.state);
  std::string error;
  ASSERT_TRUE(load(before, ends.state, error)) << error;
  ASSERT_EQ(ask(ends), ThreadRefusal::kNone);
  ends.run(50);
  const std::vector<std::uint8_t> after = save(ends.state);
  ASSERT_TRUE(load(after, ends.state, error)) << error;
  ends.run(50);
  EXPECT_EQ(hash(ends.state), wanted);
}

}  // namespace
}  // namespace halsted
