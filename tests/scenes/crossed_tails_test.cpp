/// The scripted surgeon with both tails of a stitch between two ends in the hands.
#include <gtest/gtest.h>

#include "scenes/expert.h"
#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

TEST(CrossedTails, AreLetBeWhenTheStitchHasTornOut) {
  SewnEnds ends({.stitches = 1, .spacing = 4e-3, .depth = 5e-3, .gap = 3e-3, .assist = true});
  const auto script = scenes::parseExpert("scene = \"stay\"\n[[action]]\ndo = \"tighten\"\ntension_n = 1\n", "test");
  const scenes::ExpertStatePtr surgeon = scenes::beginExpert(script, ends.model);
  std::array<HandTarget, kHands> hands;
  std::string failure;
  for (int k = 0; k < 1000; ++k) {
    ASSERT_TRUE(scenes::advanceExpert(script, ends.model, ends.state, *surgeon, hands, failure)) << failure;
    for (int hand = 0; hand < kHands; ++hand) ends.input.tools[hand].pose = hands[hand].pose;
    ends.step();
  }
  ends.state.strand.holeCount = 0;             // as tissue that tears leaves it
  EXPECT_FALSE(scenes::advanceExpert(script, ends.model, ends.state, *surgeon, hands, failure));
  EXPECT_NE(failure.find("left the tissue"), std::string::npos) << failure;
}

}  // namespace
}  // namespace halsted
