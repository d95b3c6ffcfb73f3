/// The scripted surgeon with both tails of a stitch between two ends in the hands.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/expert.h"
#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

struct Crossing {
  SewnEnds ends{{.stitches = 1, .spacing = 4e-3, .depth = 5e-3, .gap = 3e-3, .assist = true}};
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"stay\"\n[[action]]\ndo = \"tighten\"\ntension_n = 1\n", "test");
  const scenes::ExpertStatePtr surgeon = scenes::beginExpert(script, ends.model);
  std::array<HandTarget, kHands> hands;
  std::string failure;

  bool advance() { return scenes::advanceExpert(script, ends.model, ends.state, *surgeon, hands, failure); }
  void step() {
    for (int hand = 0; hand < kHands; ++hand) ends.input.tools[hand].pose = hands[hand].pose;
    ends.step();
  }
  /// What the surgeon does, not what comes of it: the hands are where he wants them, and the right one feels what the test says.
  void feel(double force) {                    // [N]
    for (int hand = 0; hand < kHands; ++hand) ends.state.tools[hand].device = ends.state.tools[hand].proxy = hands[hand].pose;
    ends.state.tools[kRight].force = Vec3(0.0, 0.0, force);
    ++ends.state.step;
  }
  double crossed() const { return hands[kLeft].pose.position.x() - hands[kRight].pose.position.x(); }   // [m] that the left one is farther to the right
};

TEST(CrossedTails, AreLetBeWhenTheStitchHasTornOut) {
  Crossing c;
  for (int k = 0; k < 1000; ++k) {
    ASSERT_TRUE(c.advance()) << c.failure;
    c.step();
  }
  c.ends.state.strand.holeCount = 0;           // as tissue that tears leaves it
  EXPECT_FALSE(c.advance());
  EXPECT_NE(c.failure.find("left the tissue"), std::string::npos) << c.failure;
}

/// Drawn on, a tail that hangs on the other tool tore the wall (`lembert` on a patient's colon, with 13.8 N).
TEST(CrossedTails, AreTakenBackAndPassedAnewWhereOneHasCaught) {
  constexpr double kPast = 8e-3, kBack = 1e-3, kFar = 25e-3;   // [m]
  Crossing c;
  const auto until = [&c](const auto& there, double felt) {    // [N]
    for (int k = 0; k < 3000; ++k) {
      ASSERT_TRUE(c.advance()) << c.failure;
      if (there()) return;
      c.feel(felt);
    }
    FAIL() << c.crossed();
  };
  until([&] { return c.crossed() > kPast; }, 0.0);
  double farthest = 0.0;                       // [m]
  until([&] { farthest = std::max(farthest, c.crossed()); return c.crossed() < kBack; }, 3.0);
  EXPECT_LT(farthest, kFar);                   // they did not go on
  until([&] { return c.crossed() > kFar; }, 0.0);
}

}  // namespace
}  // namespace halsted
