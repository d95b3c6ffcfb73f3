/// Both ends of a throw over throws that lie already: what lifts these, or draws on the tail alone, opens them (scenes/tie_draw.cpp).
#include <gtest/gtest.h>

#include "scenes/expert_state.h"
#include "scenes/tie_phases.h"
#include "scenes/tie_places.h"
#include "sim/strand/strand.h"
#include "sim/suture/knot_place.h"
#include "tests/scenes/tying.h"

namespace halsted {
namespace {

class Drawing : public Tying {
 protected:
  Drawing() : Tying("1=1") {}

  scenes::Scene scene{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};

  void runToSecond(int phase) {
    runTo(scenes::kLetTail);                   // of the first throw, which may be drawn again
    runTo(scenes::kWind);
    runTo(phase);
    ASSERT_EQ(memory->knot.current, 1u);
  }
  double height(int hand) const {              // [m] over the stitch, as it begins to draw
    return (memory->goal[hand].position - scenes::stitch(scene)).dot(memory->knot.up);
  }
};

/// A double throw takes up most of the tail: in `lembert` 8 mm were left, and the hand that went to its side drew the rest out of the throw.
TEST_F(Drawing, TheTailIsNotDrawnStraightOverAThrowThatNothingLocks) {
  runToSecond(scenes::kCross);
  ASSERT_TRUE(memory->knot.loose);
  const double left = 6e-3;                    // [m]
  memory->knot.tailOut = w.state.tools[kRight].threadCoordinate + left;
  runTo(scenes::kDrawTight);
  const Vec3 from = strandPoint(w.model.strand, w.state.strand, memory->knot.tailOut);   // [m]
  EXPECT_LT((memory->goal[kRight].position - from).norm(), 0.95 * left);
  EXPECT_GT(height(kRight), 2e-3);             // nor pressed into the wall for that
}

/// Hands that draw from higher up lift the knot to the line between them, and thread out of the throws into the loop (`lembert`).
TEST_F(Drawing, EndsOverAThrowAreDrawnAlongTheWall) {
  runTo(scenes::kDrawTight);
  const double first = height(kLeft);          // [m]
  runToSecond(scenes::kDrawTight);
  for (int hand = 0; hand < kHands; ++hand) {
    EXPECT_LT(height(hand), 4e-3);
    EXPECT_LT(height(hand), first - 2e-3);
  }
}

/// A long end that is still slack where the arm reaches over the bowel: in `stay` the forceps leant on it with 18.7 N.
TEST_F(Drawing, AHandThatLeansOnTissueDrawsNoFarther) {
  runTo(scenes::kDrawTight);
  const double before = memory->knot.drawn[kLeft];   // [m]
  std::string failure;
  ToolState& left = w.state.tools[kLeft];
  const Vec3 felt = left.force;                // [N]
  left.force = Vec3(0.0, 0.0, 10.0);
  scenes::runTie(scene, failure);
  EXPECT_EQ(memory->knot.drawn[kLeft], before);
  left.force = felt;
  scenes::runTie(scene, failure);
  EXPECT_GT(memory->knot.drawn[kLeft], before);
}

/// How far two turns reach along the tail when its ends have been drawn apart, so far from straight over the stitch.  [m]
double twistDrawnAt(int degrees) {             // [deg]
  TiedWall w;
  const scenes::ExpertScript script = scenes::parseExpert(
      "scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"2\"\ndraw_deg = " + std::to_string(degrees) + "\nlimit_s = 60\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  for (int k = 0; k < 40000 && w.advance(script, *memory); ++k) {}
  EXPECT_EQ(w.failure, "");
  const std::optional<KnotPlace> knot = placeOfKnot(w.model, w.state);
  EXPECT_TRUE(knot);
  return knot ? knot->tail - knot->tailOut : 0.0;   // coordinates grow toward the stitch
}

/// Drawn straight over the stitch, two turns twist along as much of it as there is, for nothing parts the strands; the next throw draws that together, and
/// what it gives is slack in the loop (`lembert`: 22 mm from hole to hole, five loops of ten hung).
TEST(DrawnAslant, ADoubleThrowTwistsShorter) {
  const double straight = twistDrawnAt(0), aslant = twistDrawnAt(48);   // [m]
  RecordProperty("straight_mm", std::to_string(1e3 * straight));
  RecordProperty("aslant_mm", std::to_string(1e3 * aslant));
  EXPECT_GT(aslant, 0.0);
  EXPECT_LT(aslant, 0.9 * straight);            // across this thin wall, 4.4 and 5.2 mm
}

/// A device is not deep: in `lembert` the long end's came to its stop, and the other hand drew 25 mm of thread through both walls.
TEST_F(Drawing, AHandThatStopsAslantGoesOnStraightAcross) {
  script = tie("tie = \"1\"\ndraw_deg = 48");
  const scenes::Scene aslant{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};
  runTo(scenes::kDrawTight);
  std::string failure;
  const double tail = memory->knot.drawn[kRight];   // [m]
  EXPECT_LT(memory->knot.longWay.dot(-memory->knot.side), 0.7);
  w.state.tools[kLeft].force = Vec3(0.0, 0.0, 10.0);
  scenes::runTie(aslant, failure);
  EXPECT_EQ(memory->knot.longWay, Vec3(-memory->knot.side));
  EXPECT_EQ(memory->goal[kLeft].position, w.state.tools[kLeft].proxy.position);
  EXPECT_LT(memory->knot.drawn[kRight] - tail, 1e-5);
  const double before = memory->knot.drawn[kLeft];   // [m]
  scenes::runTie(aslant, failure);              // there is no other way left
  EXPECT_EQ(memory->knot.drawn[kLeft], before);
}

/// The hand that eased off felt the wall against which it came as if that were the pull it was to answer, and leant on it with 8 N (`connell`).
TEST_F(Drawing, AHandThatEasesOffAnswersAPullAndNoPush) {
  runTo(scenes::kLayTail);
  std::string failure;
  const auto eased = [&](double pull) {        // [N] toward the stitch
    const double before = memory->knot.drawn[kLeft];   // [m]
    memory->knot.felt[kLeft] = 0.0;
    w.state.tools[kLeft].threadForce = pull * memory->knot.side;
    for (int k = 0; k < 20; ++k) scenes::runTie(scene, failure);
    return before - memory->knot.drawn[kLeft];
  };
  EXPECT_GT(eased(2.0), 1e-3);
  EXPECT_EQ(eased(-2.0), 0.0);
}

/// Taken as far in as for the first, the tail would leave no room for a throw between jaws and knot.
TEST_F(Drawing, LaterThrowsTakeTheTailNearerToItsEnd) {
  w.state.strand.holes[0].coordinate = 44e-3;
  const double first = scenes::tailPlace(scene);   // [m]
  memory->knot.current = 1;
  EXPECT_GT(first, 10e-3);
  EXPECT_LT(scenes::tailPlace(scene), 6e-3);
}

/// In `lembert` a double throw came undone as the next was wound; what came of that was held against it, and wound once more from the same side.
TEST_F(Drawing, AThrowThatComesOverOneThatCameUndoneIsNotMissed) {
  runToSecond(scenes::kFollow);
  const KnotState one = w.state.knot;
  ASSERT_EQ(one.throws, 1);
  w.state.knot.throws = 0;
  w.state.knot.turns = {};
  ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  runTo(scenes::kDrawTight);
  for (int k = 0; k < 40000 && memory->phase == scenes::kDrawTight; ++k) {   // the surgeon sees one throw again
    w.state.knot = one;
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  }
  EXPECT_GT(memory->knot.stepsMore, 0);
  EXPECT_FALSE(scenes::noThrowCame(memory->knot));
}

/// In `connell` a loop came off beside the tail: the surgeon wound the next throw from the other side, over the first one, for a granny.
TEST_F(Drawing, AThrowThatDidNotComeIsWoundOnceMoreFromItsSide) {
  runToSecond(scenes::kFollow);
  const Vec3 side = memory->knot.side;         // [1]
  scenes::goTo(scene, scenes::kUnwind);
  runTo(scenes::kStand);
  scenes::goTo(scene, scenes::kAgain);         // takes the tail with no loop on the jaws
  runTo(scenes::kLetTail);
  EXPECT_EQ(w.state.knot.throws, 1);
  runTo(scenes::kLiftLong);
  EXPECT_EQ(memory->knot.current, 1u);
  EXPECT_EQ(memory->knot.side, side);
  for (int k = 0; k < 60000 && w.advance(script, *memory); ++k) {}
  EXPECT_EQ(w.failure, "");
  EXPECT_EQ(w.state.knot.throws, 2);
  EXPECT_EQ(locks(w.state.knot), 1);
}

}  // namespace
}  // namespace halsted
