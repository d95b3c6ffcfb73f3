/// The scripted surgeon takes both tails of a stitch, and nothing else with them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenes/tied_wall.h"

namespace halsted {
namespace {

/// While it lives, the tail's end lies between the driver's jaws.
struct EndBetweenTheJaws {
  State& state;
  Vec3 where[2];                               // [m]

  explicit EndBetweenTheJaws(State& s) : state(s) {
    for (int i = 0; i < 2; ++i) {
      where[i] = s.strand.position[i];
      s.strand.position[i] = s.tools[kRight].proxy.apply(Vec3(0.0, i == 0 ? -0.3e-3 : 0.3e-3, 5e-3));
    }
  }
  ~EndBetweenTheJaws() { std::copy(where, where + 2, state.strand.position.begin()); }
};

struct Taking {
  TiedWall wall;
  scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"take_tails\"\ntail_mm = 20\nlimit_s = 40\n", "test");
  scenes::ExpertStatePtr memory = scenes::beginExpert(script, wall.model);
  std::array<HandTarget, kHands> target;
  int opened = 0;                              // times the driver let go of the long end that it held

  bool holds() const { return wall.state.tools[kRight].threadCoordinate >= 0.0; }
  /// What the surgeon sees while the driver holds thread: the tail's end beside it, or not.
  bool advance(bool beside) {
    bool more = false;
    if (beside && holds()) {
      const EndBetweenTheJaws seen(wall.state);
      more = scenes::advanceExpert(script, wall.model, wall.state, *memory, target, wall.failure);
    } else {
      more = scenes::advanceExpert(script, wall.model, wall.state, *memory, target, wall.failure);
    }
    const bool before = holds();
    wall.follow(target);
    wall.step();
    if (before && !holds()) ++opened;
    return more;
  }
};

TEST(TakeTails, LetsGoOfATailThatHasAnotherTurnBesideIt) {
  Taking t;
  while (t.opened == 0 && t.advance(true)) {}
  EXPECT_EQ(t.opened, 1);
  while (t.advance(false)) {}
  EXPECT_EQ(t.wall.failure, "");
  EXPECT_EQ(t.opened, 1);
  for (const ToolState& tool : t.wall.state.tools) EXPECT_GE(tool.threadCoordinate, 0.0);
}

/// Where it lies in a heap there may be no place to take it alone.
TEST(TakeTails, TakesItWithAnotherTurnInTheEnd) {
  Taking t;
  while (t.advance(true)) {}
  EXPECT_EQ(t.wall.failure, "");
  EXPECT_GT(t.opened, 1);
  EXPECT_GE(t.wall.state.tools[kRight].threadCoordinate, 0.0);
}

}  // namespace
}  // namespace halsted
