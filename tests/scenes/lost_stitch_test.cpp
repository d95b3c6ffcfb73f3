/// A stitch that a script cannot finish: its thread is drawn out of the tissue and a fresh one asked for (`again_deg` of scenes/expert.h).
#include <gtest/gtest.h>

#include "scenes/expert.h"
#include "sim/strand/strand.h"
#include "sim/suture/tied_loop.h"
#include "tests/scenes/sewn_ends.h"

namespace halsted {
namespace {

/// An untied stitch that nobody holds, and a script that would tie it.
class LostStitch : public ::testing::Test {
 protected:
  SewnEnds ends{{.stitches = 1, .spacing = 4e-3, .depth = 5e-3, .gap = 3e-3, .assist = true, .spare = 1}};
  std::vector<std::string> failures;

  /// To the script's end, within a minute of virtual time.
  void run(const std::string& keys, const std::string& actions = "[[action]]\ndo = \"tie\"\ntie = \"1=1\"\n") {
    constexpr int kSteps = 60000;
    const auto script = scenes::parseExpert("scene = \"stay\"\n" + keys + actions, "test");
    const scenes::ExpertStatePtr surgeon = scenes::beginExpert(script, ends.model);
    std::array<HandTarget, kHands> hands;
    ends.letGo();
    bool busy = true;
    for (int k = 0; busy && k < kSteps; ++k) {
      std::string failure;
      busy = scenes::advanceExpert(script, ends.model, ends.state, *surgeon, hands, failure);
      if (!failure.empty()) failures.push_back(failure);
      for (int hand = 0; hand < kHands; ++hand) {
        ends.input.tools[hand].pose = hands[hand].pose;
        ends.input.tools[hand].jaw = hands[hand].jaw;
      }
      ends.input.command = scenes::takeSpokenCommand(*surgeon);
      ends.step();
    }
    EXPECT_FALSE(busy);
  }
};

TEST_F(LostStitch, IsDrawnOutAndBegunAnewWithAFreshThread) {
  run("stitch_at_deg = [0]\nagain_deg = [5]\n");
  ASSERT_EQ(failures.size(), 2u);              // then there is no stitch, and no other attempt
  EXPECT_NE(failures[0].find("the hands do not hold the two tails"), std::string::npos) << failures[0];
  EXPECT_NE(failures[1].find("there is no stitch"), std::string::npos) << failures[1];
  EXPECT_EQ(ends.state.strand.holeCount, 0);
  EXPECT_EQ(ends.state.supply->handed, 1);
  EXPECT_EQ(ends.state.metrics.tears, 0);      // drawn through its holes, not torn out
}

TEST_F(LostStitch, EndsAScriptThatDoesNotSayWhereElse) {
  run("stitch_at_deg = [0]\n");
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(ends.state.strand.holeCount, 2);
}

/// Pulled at, a knot may turn out to hold: the throws of one that looked untied drew tight, and the script pulled at it for two minutes.
TEST_F(LostStitch, WhoseKnotHoldsAfterAllIsKept) {
  ends.tighten();
  ends.tieOff();
  ends.state.threadContacts.cut[threadSpot(ends.model.strand, ends.state.assist->tip + 20e-3).node] = 1;   // the needle is off
  ASSERT_TRUE(finishedLoop(ends.model, ends.state));
  const std::uint64_t letGo = ends.state.step;
  run("", "[[action]]\ndo = \"take_out\"\n");
  const double looked = static_cast<double>(ends.state.step - letGo) * ends.model.params.dt;   // [s]
  EXPECT_GT(looked, 2.0);                      // a procedure looks along the seam before the next thread
  for (const ToolState& tool : ends.state.tools) EXPECT_LT(tool.threadCoordinate, 0.0);
  run("", "[[action]]\ndo = \"fresh_thread\"\n");
  EXPECT_TRUE(failures.empty()) << failures.front();
  EXPECT_EQ(ends.state.stitches->count, 1);
  EXPECT_EQ(ends.state.supply->handed, 1);
}

/// A script may name more places than the procedure asks for stitches, for those that tear out after they were tied.
TEST_F(LostStitch, IsMadeGoodAtAFurtherPlaceOnlyWhileTheProcedureGoesOn) {
  ends.model.procedure.resize(1);
  ends.model.procedure.front().done = {Quantity::kStitches, 1.0};
  for (const bool completed : {true, false}) {
    ends.state.procedure.current = completed ? 1 : 0;
    const std::uint64_t start = ends.state.step;
    run("stitch_at_deg = [0, 20]\n", "[[action]]\ndo = \"hold\"\nlimit_s = 0.5\n");
    const double took = static_cast<double>(ends.state.step - start) * ends.model.params.dt;   // [s]
    EXPECT_NEAR(took, completed ? 1.5 : 2.0, 0.01);              // a second of letting go, and each stitch takes half of one
  }
  EXPECT_TRUE(failures.empty()) << failures.front();
}

}  // namespace
}  // namespace halsted
