/// One script for two levels of assistance: an action that names a level is done at that level only.
#include <gtest/gtest.h>

#include "tests/scenes/tied_wall.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

constexpr const char* kHolds =
    "[[action]]\ndo = \"hold\"\nassist = \"knot\"\nlimit_s = 0.2\n"
    "[[action]]\ndo = \"hold\"\nassist = \"none\"\nlimit_s = 0.05\n"
    "[[action]]\ndo = \"hold\"\nlimit_s = 0.01\n";

double timeOf(ThreadAssist assist) {           // [s]
  SimParams p = tiedWallParams();
  p.thread.assist = assist;
  TiedWall w(p);
  EXPECT_TRUE(w.act(kHolds)) << w.failure;
  return static_cast<double>(w.state.step) * p.dt;
}

TEST(ExpertAssist, DoesWhatIsMeantForTheLevelOfTheScene) {
  EXPECT_NEAR(timeOf(ThreadAssist::kNone), 0.06, 5e-3);
  EXPECT_NEAR(timeOf(ThreadAssist::kKnot), 0.21, 5e-3);
}

TEST(ExpertAssist, IsALevelThatThereIs) {
  const auto parse = [](const std::string& level) { scenes::parseExpert("scene = \"stay\"\n[[action]]\ndo = \"hold\"\nassist = " + level + "\n", "test"); };
  testing::expectRefused([&] { parse("\"glue\""); }, {"test:4", "action.assist", "\"none\" or \"knot\""});
  testing::expectRefused([&] { parse("1"); }, {"test:4", "action.assist"});
}

}  // namespace
}  // namespace halsted
