/// The scripted surgeon takes both tails of a stitch, and nothing else with them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenes/tied_wall.h"
#include "tests/scenes/wall_laws.h"

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

constexpr const char* kTake = "[[action]]\ndo = \"take_tails\"\ntail_mm = 20\nlimit_s = 40\n";
constexpr const char* kTakeUnlessHeld = "[[action]]\ndo = \"take_tails\"\ntail_mm = 20\nunless_held = true\nlimit_s = 40\n";

TEST(TakeTails, WhatIsHeldIsNotTakenOnceMore) {
  TiedWall w;
  ASSERT_TRUE(w.act(kTakeUnlessHeld)) << w.failure;
  const double left = w.state.tools[kLeft].threadCoordinate, right = w.state.tools[kRight].threadCoordinate;   // [m]
  EXPECT_GE(left, 0.0);
  EXPECT_GT(right, left);
  const std::uint64_t taken = w.state.step;
  ASSERT_TRUE(w.act(kTakeUnlessHeld)) << w.failure;
  EXPECT_LE(w.state.step, taken + 1);          // the step in which the script is found to be at its end
  ASSERT_TRUE(w.act(kTake)) << w.failure;
  EXPECT_GT(w.state.step, taken + 1000);
}

TEST(TakeTails, OnlyWhatTakesTailsAsksWhetherTheyAreHeld) {
  const auto parse = [](const std::string& rest) { scenes::parseExpert("scene = \"stay\"\n[[action]]\ndo = " + rest, "test"); };
  testing::expectRefused([&] { parse("\"tie\"\ntie = \"1=1\"\nunless_held = true\n"); }, {"test:5", "action.unless_held", "unknown key"});
  testing::expectRefused([&] { parse("\"take_stay\"\nunless_held = 1\n"); }, {"test:4", "action.unless_held", "true or false"});
}

}  // namespace
}  // namespace halsted
