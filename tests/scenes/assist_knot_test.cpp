/// The beginner's knot (sim/suture/assist_knot.h): it is what it says, an object that is placed, runs down, locks, holds and slips.
#include "sim/suture/assist_knot.h"

#include <gtest/gtest.h>

#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

Seam one(bool assist) { return {.stitches = 1, .spacing = 4e-3, .depth = 5e-3, .gap = 3e-3, .assist = assist}; }

/// One stitch across the gap between two ends, both tails in the jaws: left the tail of the left end.
struct HeldStitch : SewnEnds {
  explicit HeldStitch(bool assist, double holding = 10.0) : SewnEnds(one(assist), holding) {}   // [N]

  Vec3 holeAt(int h) const { return holePoint(model, state.strand.holes[h], state.tissue.position); }
  Vec3 over() const { return 0.5 * (holeAt(0) + holeAt(1)); }
  double apart() const { return (holeAt(0) - holeAt(1)).norm(); }   // [m]
  double seen(Quantity q) const { return out.seen[static_cast<int>(q)]; }   // unit of the quantity
  void run(int steps) {
    for (int k = 0; k < steps; ++k) step();
  }
  void open(int hand) { input.tools[hand].jaw = 1.0; }
  /// Both hands to these places, evenly, in half a second.
  void go(const Vec3& left, const Vec3& right) {   // [m]
    const Vec3 from[2] = {input.tools[kLeft].pose.position, input.tools[kRight].pose.position}, to[2] = {left, right};
    for (int k = 1; k <= 500; ++k) {
      for (int hand = 0; hand < kHands; ++hand) input.tools[hand].pose.position = from[hand] + k / 500.0 * (to[hand] - from[hand]);
      step();
    }
  }
  /// The hands pass each other, the one behind over the one in front, or its shaft would catch the other's thread, and change sides.
  void cross() {
    const Vec3 up(0.0, 16e-3, 0.0), pass(0.0, 6e-3, -5e-3);
    go(over() + up + pass, over() + up - pass);
    go(over() + Vec3(18e-3, 7e-3, 0.0), over() + Vec3(-18e-3, 7e-3, 0.0));
  }
  void uncrossed() { go(over() + Vec3(-15e-3, 15e-3, 0.0), over() + Vec3(15e-3, 15e-3, 0.0)); }
  /// Outward from where they are, each as long as it feels less.  [N]
  void draw(double tension, int steps = 1500) {
    for (int k = 0; k < steps; ++k) {
      for (int hand = 0; hand < kHands; ++hand) {
        if (state.tools[hand].threadForce.norm() > tension) continue;
        Vec3& p = input.tools[hand].pose.position;
        p += 2e-5 * (p - over()).normalized();
      }
      step();
    }
  }
  /// The hands give way.
  void relax() {
    for (int hand = 0; hand < kHands; ++hand) input.tools[hand].pose.position -= 6e-3 * (input.tools[hand].pose.position - over()).normalized();
    run(300);
  }
};

TEST(AssistKnot, IsNotThereUnlessAskedFor) {
  HeldStitch plain(false);
  plain.cross();
  plain.draw(1.5);
  EXPECT_FALSE(plain.state.assist.has_value());
  EXPECT_FALSE(plain.state.metrics.assistedKnots.has_value());
}

TEST(AssistKnot, NeedsCrossedTails) {
  HeldStitch stitch(true);
  stitch.uncrossed();
  stitch.draw(1.5);
  EXPECT_GT(stitch.state.tools[kLeft].threadForce.norm(), 1.0);
  EXPECT_FALSE(stitch.state.assist->placed);
}

TEST(AssistKnot, NeedsTension) {
  HeldStitch stitch(true);
  stitch.cross();
  EXPECT_FALSE(stitch.state.assist->placed);
}

TEST(AssistKnot, RunsDownWhileCrossedTailsAreDrawnAndLocksWhenTheyAreNot) {
  HeldStitch stitch(true);
  stitch.cross();
  stitch.draw(1.5);
  EXPECT_FALSE(stitch.state.assist->locked);
  stitch.relax();
  ASSERT_TRUE(stitch.state.assist->locked);
  EXPECT_EQ(stitch.state.metrics.assistedKnots, 1);
  EXPECT_EQ(stitch.seen(Quantity::kKnotLocks), 1.0);
  const AssistKnot& k = *stitch.state.assist;
  EXPECT_LT(stitch.state.strand.holes[0].coordinate - k.tail + k.tip - stitch.state.strand.holes[1].coordinate, stitch.apart() + 3e-3);
  const Vec3 between = strandPoint(stitch.model.strand, stitch.state.strand, k.tail) - strandPoint(stitch.model.strand, stitch.state.strand, k.tip);
  EXPECT_LT(between.norm(), 4.0 * stitch.model.strand.radius);
}

/// What the tissue pulls at a throw that is only just placed, where it springs apart or is let down by the hands, runs back through it: kept, it would
/// be locked into the loop and tear the thread out.
TEST(AssistKnot, LetsThreadBackIntoALoopThatIsFarTighterThanTheHandsDraw) {
  constexpr double kShorter = 4e-3, kMost = 2.2;   // [m], [N]
  HeldStitch stitch(true);
  stitch.cross();
  stitch.draw(1.5);
  AssistKnot& k = *stitch.state.assist;
  ASSERT_TRUE(k.placed && !k.locked);
  k.tail += kShorter;
  k.tip -= kShorter;
  double tightest = 0.0;                       // [N] more in the loop than in the hand
  for (int i = 0; i < 600; ++i) {
    k.seated = 0.0;                            // not locked meanwhile
    stitch.draw(0.6, 1);
    tightest = std::max(tightest, -std::max(k.felt[0], k.felt[1]));
  }
  ASSERT_TRUE(k.placed && !k.locked);
  EXPECT_GT(tightest, kMost);
  EXPECT_GT(std::min(k.felt[0], k.felt[1]), -kMost);
}

TEST(AssistKnot, ComesUndoneWhenATailIsLetGoBeforeItLocks) {
  HeldStitch stitch(true);
  stitch.cross();
  for (int k = 0; k < 3000 && !stitch.state.assist->placed; ++k) stitch.draw(1.5, 1);
  ASSERT_TRUE(stitch.state.assist->placed);
  ASSERT_FALSE(stitch.state.assist->locked);
  stitch.open(kLeft);
  stitch.run(200);
  EXPECT_FALSE(stitch.state.assist->placed);
}

/// One stitch between two ends 5 mm apart, drawn together by the test: the tissue pulls it open with all its force. The walls are watched for a second:
/// where contacts between them do not come to rest, one look at them says nothing.
TEST(AssistKnot, HoldsTwoEndsTogetherThatWouldSpringApart) {
  constexpr int kWatched = 1000;               // steps
  double first[2], least[2], most[2], mean[2];   // [m]
  for (int on = 0; on < 2; ++on) {
    SewnEnds ends({.stitches = 1, .spacing = 4e-3, .depth = 5e-3, .gap = 5e-3, .assist = true});
    ends.tighten();
    if (on) ends.tieOff();
    ends.letGo();
    first[on] = measureJoin(ends.model, ends.state).wallGap;
    least[on] = 1.0;
    most[on] = mean[on] = 0.0;
    for (int k = 0; k < kWatched; ++k) {
      ends.step();
      const double gap = measureJoin(ends.model, ends.state).wallGap;
      least[on] = std::min(least[on], gap);
      most[on] = std::max(most[on], gap);
      mean[on] += gap / kWatched;
    }
    std::printf("%s: walls %.2f to %.2f mm apart, %.2f in the mean\n", on ? "tied" : "not tied", 1e3 * least[on], 1e3 * most[on], 1e3 * mean[on]);
  }
  EXPECT_LT(first[1], 0.2e-3);
  EXPECT_LT(mean[1], 0.2e-3);
  EXPECT_LT(most[1], 0.2e-3);
  EXPECT_GT(least[0], 3e-3);
}

TEST(AssistKnot, SlipsWhenItIsPulledPastItsForce) {
  double slipped[2];                           // [m]
  for (int weak = 0; weak < 2; ++weak) {
    HeldStitch stitch(true, weak ? 0.4 : 10.0);
    stitch.cross();
    stitch.draw(1.0);
    stitch.relax();
    ASSERT_TRUE(stitch.state.assist->locked);
    stitch.draw(3.0);
    slipped[weak] = stitch.state.assist->slipped;
  }
  EXPECT_EQ(slipped[0], 0.0);
  EXPECT_GT(slipped[1], 0.0);
}

}  // namespace
}  // namespace halsted
