/// The hand that winds the long end round the driver, and the loop that it keeps there (scenes/tie_places.h, tie_wind.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "scenes/expert_state.h"
#include "scenes/tie_phases.h"
#include "scenes/tie_places.h"
#include "sim/portable_math.h"
#include "sim/strand/strand.h"
#include "tests/scenes/sewn_ends.h"
#include "tests/scenes/tying.h"

namespace halsted {
namespace {

/// The wall, the long end in the left hand, and a surgeon about to wind it.
class Winding : public Tying {
 protected:
  Winding() : Tying("1") {}

  /// A step in which the surgeon sees the driver hold this place of the thread, whatever it holds.
  bool seeHeld(double place) {                 // [m]
    std::array<HandTarget, kHands> target;
    double& held = w.state.tools[kRight].threadCoordinate;
    const double holds = std::exchange(held, place);
    const bool more = scenes::advanceExpert(script, w.model, w.state, *memory, target, w.failure);
    held = holds;
    w.follow(target);
    w.step();
    return more;
  }
  /// The next steps of a phase, in each of which the left hand feels its thread.
  void feel(double force, int steps) {         // [N]
    for (const int phase = memory->phase; steps > 0 && memory->phase == phase; --steps) {
      w.state.tools[kLeft].threadForce = force * Vec3::UnitZ();
      ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    }
  }
};

/// Level with its loop after whole turns, the hand gains nothing by going out: a floor above the loop does not send it there.
TEST_F(Winding, AFloorAboveTheLoopLeavesALevelHandWhereItIs) {
  runTo(scenes::kFollow);
  const scenes::Scene scene{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};
  const Vec3 driver = memory->hand[kRight].command.position;     // [m]
  const auto hand = [&](double floor) {        // [m]
    memory->knot.floor = floor;
    return scenes::windingPose(scene, driver, scenes::wholeTurns(scene)).position;
  };
  EXPECT_LT((hand(0.2) - hand(-1.0)).norm(), 1e-9);
}

/// Under the driver it goes no lower than the edges, and no farther out either.
TEST_F(Winding, AFloorKeepsTheHandAboveTheEdges) {
  runTo(scenes::kWind);
  const scenes::Scene scene{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};
  const auto height = [&](double floor) {      // [m] over the stitch
    memory->knot.floor = floor;
    return (scenes::windingPose(scene, memory->hand[kRight].command.position, 1.5 * kPi).position - scenes::stitch(scene)).dot(memory->knot.up);
  };
  const double low = height(-1.0);             // [m]
  EXPECT_NEAR(height(low + 3e-3), low + 3e-3, 1e-3);
}

/// Where nothing is cut, too: it would press on the wall and catch on the stitch.
TEST_F(Winding, TheHandStaysAboveTheTissueAsItGoesUnderTheDriver) {
  script = tie("tie = \"2\"\nlong_end_mm = 40");   // a low driver
  memory = scenes::beginExpert(script, w.model);
  runTo(scenes::kWind);
  const Vec3 up = memory->knot.up;
  double low = 1.0, top = -1.0;                // [m] of the hand, of the wall
  while (memory->phase == scenes::kWind) {
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    low = std::min(low, memory->hand[kLeft].command.position.dot(up));
  }
  for (const Vec3& x : w.state.tissue.position) top = std::max(top, x.dot(up));
  EXPECT_GT(low, top);
}

/// A hand that gives way and still feels its thread is as near to the jaws as it gets: the driver comes down to the stitch.
TEST_F(Winding, TheDriverComesDownWhereTheThreadIsShorterThanWasThought) {
  runTo(scenes::kWind);
  const auto height = [&] { return w.input.tools[kRight].pose.position.dot(memory->knot.up); };   // [m]
  const double before = height();              // [m]
  feel(0.5, 400);
  EXPECT_LT(height(), before - 5e-3);
}

/// However short the thread, the driver does not go for it into the wall.
TEST_F(Winding, TheDriverComesNoLowerThanTheStitch) {
  runTo(scenes::kWind);
  const scenes::Scene scene{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};
  feel(0.5, 4000);
  ASSERT_EQ(memory->phase, scenes::kWind);
  const double clear = (memory->hand[kRight].command.position - scenes::stitch(scene)).dot(memory->knot.up);   // [m]
  EXPECT_GT(clear, 3e-3);                      // its tips hang lower than where it is wound
}

/// Jaws that go on, or open, in a tight loop draw on the stitch: the driver waits; at last it leaves the loop closed, and goes for the tail
/// nearer to the stitch the next time.
TEST_F(Winding, JawsWaitInATightLoopAndLeaveItClosed) {
  runTo(scenes::kFollow);
  const scenes::Scene scene{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};
  const double before = scenes::tailPlace(scene);   // [m] along the tail
  feel(0.5, 500);                              // [steps] until it is felt
  const Vec3 waits = memory->hand[kRight].command.position;      // [m]
  feel(0.5, 5400);
  EXPECT_EQ(memory->phase, scenes::kFollow);
  EXPECT_LT((memory->hand[kRight].command.position - waits).norm(), 1e-9);
  feel(0.5, 400);
  EXPECT_EQ(memory->phase, scenes::kUnwind);
  EXPECT_LT(w.state.tools[kRight].jaw, 0.1);
  EXPECT_GT(scenes::tailPlace(scene), before + 2e-3);
}

/// Thread that lies otherwise than was planned draws on the winding hand however that gives way, and on what leaves its loop: the hand goes where
/// it is drawn.
TEST_F(Winding, AHandThatIsDrawnHardGoesAlong) {
  runTo(scenes::kFollow);
  const scenes::Scene scene{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};
  const auto goes = [&] {                      // [m] toward the driver
    const Vec3 from = memory->hand[kLeft].command.position, way = (memory->hand[kRight].command.position - from).normalized();   // [m], [1]
    for (int k = 0; k < 60; ++k) {
      w.state.tools[kLeft].threadForce = 6.0 * way;   // [N]
      EXPECT_TRUE(w.advance(script, *memory)) << w.failure;
    }
    return (memory->hand[kLeft].command.position - from).dot(way);
  };
  EXPECT_GT(goes(), 2e-3);
  scenes::goTo(scene, scenes::kUnwind);
  EXPECT_GT(goes(), 2e-3);
}

/// The driver has left a loop that is caught on it, and goes back: the winding hand that lifted the long end meanwhile drew 29 mm of a tail of 39 into the
/// stitch, with up to 4.5 N (`connell` by friction).
TEST_F(Winding, AHandThatLiftsTheLongEndGoesAlongWhereItIsCaught) {
  runTo(scenes::kLiftLong);
  const auto lifts = [&](double force) {       // [N] -> [m] up
    const Vec3 from = memory->hand[kLeft].command.position, up = memory->knot.up;   // [m], [1]
    for (int k = 0; k < 100; ++k) {
      w.state.tools[kLeft].threadForce = -force * up;
      EXPECT_TRUE(w.advance(script, *memory)) << w.failure;
    }
    return (memory->hand[kLeft].command.position - from).dot(up);
  };
  EXPECT_LT(lifts(1.5), 0.0);
  EXPECT_EQ(memory->phase, scenes::kLiftLong);
  EXPECT_GT(lifts(0.0), 1e-3);                 // as soon as it is free
}

/// Jaws that have missed the tail twice go where it lies by itself: other thread across it would be taken again.
TEST_F(Winding, TheTailIsTakenWhereNoOtherThreadLies) {
  runTo(scenes::kFollow);
  const scenes::Scene scene{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};
  const double usual = scenes::tailPlace(scene);                 // [m] along the tail
  w.state.strand.position[w.model.strand.nodes - 5] = strandPoint(w.model.strand, w.state.strand, usual + 1e-3);
  memory->knot.beside = 2;
  EXPECT_GT(std::fabs(scenes::tailPlace(scene) - usual - 1e-3), 3e-3);
}

/// Jaws that close on the loop instead try once more from where they are; then the loop is wound anew.
TEST_F(Winding, ALoopTakenTwiceForTheTailIsWoundAnew) {
  for (const int after : {scenes::kFollow, scenes::kUnwind}) {
    runTo(scenes::kClose);
    while (memory->phase == scenes::kClose) seeHeld(w.state.tools[kLeft].threadCoordinate - 20e-3);
    EXPECT_EQ(memory->phase, after);
  }
}

/// A knot that locks is done, though the tail of a further throw cannot be had; one in which nothing locks is not.
TEST_F(Winding, AKnotThatLocksIsLeftAsItIsWhereTheTailIsNotToBeHad) {
  runTo(scenes::kClose);
  memory->knot.misses = scenes::kAttempts;
  const State wound = w.state;
  const scenes::ExpertState before = *memory;
  for (const bool locked : {true, false}) {
    w.state = wound;
    *memory = before;
    bool more = true;
    while (more && memory->phase == scenes::kClose) {
      if (locked) { w.state.knot.throws = 2; w.state.knot.turns = {1, 1}; w.state.knot.sense = {1, -1}; }
      more = seeHeld(-1.0);
    }
    EXPECT_FALSE(more);
    EXPECT_EQ(w.failure.empty(), locked) << w.failure;
  }
}

/// Of a piece that was cut off short the hand has the long end where it has nearly all of it: let go for more, that would fall.
TEST_F(Winding, AShortPieceIsHeldAllTheSame) {
  runTo(scenes::kLiftLong);
  scenes::ExpertAction longer = script.actions[0];
  longer.longEnd = 100e-3;
  const scenes::Scene scene{w.model, w.state, *memory, longer, 1e-3, 0.0};
  double& held = w.state.tools[kLeft].threadCoordinate;          // [m]
  held = scenes::longHole(scene).coordinate + 0.55 * longer.longEnd;
  w.state.threadContacts.cut.assign(w.model.strand.nodes, 0);
  w.state.threadContacts.cut[threadSpot(w.model.strand, held + 6e-3).node] = 1;
  EXPECT_TRUE(scenes::holdsLong(scene));
  held = scenes::longHole(scene).coordinate + 20e-3;
  EXPECT_FALSE(scenes::holdsLong(scene));
}

/// The tail lies on the wall: tips sent past it dig into that.
TEST_F(Winding, TheJawsStopBeforeTheTail) {
  runTo(scenes::kClose);
  const scenes::Scene scene{w.model, w.state, *memory, script.actions[0], 1e-3, 0.0};
  const Pose& jaws = memory->hand[kRight].command;
  const Vec3 tail = strandPoint(w.model.strand, w.state.strand, scenes::tailPlace(scene));   // [m]
  EXPECT_GT((jaws.position - tail).dot(jaws.orientation * Vec3::UnitZ()), 0.3e-3);
}

/// What the jaws feel when they have closed on thread that lies on a wall is that wall: taken for a taut tail, they stayed pressed into it while
/// the loop was drawn off them, and in `altemeier` parted the walls that the throw below held.
TEST_F(Winding, TheTailIsDrawnUpWhateverTheWallPressesOnTheJaws) {
  runTo(scenes::kThrough);
  const Vec3 up = memory->knot.up;
  const double before = memory->hand[kRight].command.position.dot(up);   // [m]
  for (int k = 0; k < 200; ++k) {
    w.state.tools[kRight].threadForce = 3.0 * up;                // [N]
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  }
  EXPECT_GT(memory->hand[kRight].command.position.dot(up), before + 2e-3);
}

/// A turn round jaws that hold the needle would catch on it.
TEST_F(Winding, JawsThatHaveClosedOnTheNeedleOpenBeforeATurnIsWound) {
  runTo(scenes::kStand);
  for (int k = 0; k < 400 && memory->phase == scenes::kStand; ++k) {
    w.state.tools[kRight].holdsNeedle = w.state.tools[kRight].closed;
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  }
  EXPECT_EQ(memory->phase, scenes::kUnwind);
}

/// In `lembert` six of ten loops were locked as they hung: nobody looked at the first throw again.
TEST_F(Winding, AThrowThatHangsIsDrawnOnceMoreBeforeTheNextIsWound) {
  script = tie("tie = \"1=1\"");
  memory = scenes::beginExpert(script, w.model);
  runTo(scenes::kLetTail);
  const Vec3 side = memory->knot.side;         // [1]
  while (memory->phase == scenes::kLetTail) {  // the surgeon sees a limp loop that is longer than it was drawn
    memory->knot.beyond = 0.0;
    std::fill(w.state.strand.tension.begin(), w.state.strand.tension.end(), 0.0);
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  }
  ASSERT_EQ(memory->phase, scenes::kAgain);
  EXPECT_EQ(memory->knot.current, 0u);
  runTo(scenes::kDrawTight);
  EXPECT_EQ(memory->knot.side, side);          // to the same sides
  EXPECT_EQ(w.state.knot.throws, 1);
  runTo(scenes::kWind);                        // what hangs as before is left: the tie failed here when a single throw opened by 2.02 mm each time
  EXPECT_EQ(memory->knot.current, 1u);
  EXPECT_EQ(memory->knot.redrawn, 1);
}

/// In `altemeier` the walls stand apart by themselves: the first throw lets go what no other takes back.
TEST(DrawnAgain, WhereWallsHaveComeFartherApartThanTheActionAllows) {
  SewnEnds ends({.stitches = 1});
  scenes::ExpertState memory;
  scenes::ExpertAction action;
  const scenes::Scene scene{ends.model, ends.state, memory, action, 1e-3, 0.0};
  ends.state.metrics.seam->join.wallGap = 2e-3;
  EXPECT_FALSE(scenes::wallsCameApart(scene)) << "nobody asks for it";
  action.gap = 1.5e-3;
  EXPECT_TRUE(scenes::wallsCameApart(scene));
  ends.state.metrics.seam->join.wallGap = 1.4e-3;
  EXPECT_FALSE(scenes::wallsCameApart(scene));
  ends.state.metrics.seam->join.wallGap = 2e-3;
  ends.state.knot.throws = 2;
  ends.state.knot.sense = {1, -1};
  EXPECT_FALSE(scenes::wallsCameApart(scene)) << "locked, it is not drawn any more";
}

}  // namespace
}  // namespace halsted
