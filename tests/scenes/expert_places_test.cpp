/// `stitch_at_deg`: one script, stitch after stitch round the ring.
#include <gtest/gtest.h>

#include "scenes/expert.h"
#include "scenes/scene.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

const std::string kStitch =
    "[[action]]\ndo = \"bite\"\nbowel = 1\nangle_deg = 90\n[[action]]\ndo = \"bite\"\nbowel = 2\nangle_deg = 90\n"
    "[[action]]\ndo = \"cut\"\n[[action]]\ndo = \"fresh_thread\"\n";

TEST(StitchPlaces, RepeatTheActionsWithMirroredAnglesAndAThreadBetween) {
  const auto script = scenes::parseExpert("scene = \"lembert\"\nstitch_at_deg = [0, 20, -35]\n" + kStitch, "test");
  ASSERT_EQ(script.actions.size(), 11u);       // no thread is asked for after the last
  EXPECT_EQ(script.actions[3].kind, "fresh_thread");
  EXPECT_EQ(script.actions[10].kind, "cut");
  const double left[] = {90.0, 110.0, 55.0}, right[] = {90.0, 70.0, 125.0};
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(script.actions[4 * i].angleDegrees, left[i]);
    EXPECT_DOUBLE_EQ(script.actions[4 * i + 1].angleDegrees, right[i]);
  }
}

TEST(StitchPlaces, DoOnceWhatComesBeforeTheInstrumentsAreChangedForSewing) {
  const std::string before = "[[action]]\ndo = \"hold\"\n[[action]]\ndo = \"change_tools\"\n[[action]]\ndo = \"fresh_thread\"\n";
  const std::string stitch = "[[action]]\ndo = \"bite\"\nbowel = 1\nangle_deg = 90\n[[action]]\ndo = \"cut\"\n";
  const auto script = scenes::parseExpert("scene = \"lembert\"\nstitch_at_deg = [0, 20]\n" + before + stitch, "test");
  ASSERT_EQ(script.actions.size(), 8u);
  const char* kinds[] = {"hold", "change_tools", "fresh_thread", "bite", "cut", "fresh_thread", "bite", "cut"};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(script.actions[i].kind, kinds[i]);
  EXPECT_DOUBLE_EQ(script.actions[6].angleDegrees, 110.0);
}

/// The walls of a prolapse, one in the other, are seen from the same side.
TEST(StitchPlaces, AreNotMirroredAfterAnExcision) {
  const std::string before = "[[action]]\ndo = \"cut_ring\"\n[[action]]\ndo = \"change_tools\"\n";
  const auto script = scenes::parseExpert("scene = \"altemeier\"\nstitch_at_deg = [30]\n" + before + kStitch, "test");
  ASSERT_EQ(script.actions.size(), 5u);
  EXPECT_DOUBLE_EQ(script.actions[2].angleDegrees, 120.0);
  EXPECT_DOUBLE_EQ(script.actions[3].angleDegrees, 120.0);
}

/// Each attempt clears away the one before and goes so far from the stitch's place; the last stitch's asks for a thread only to begin anew.
TEST(StitchPlaces, AreTriedAgainBesideWhereAScriptSaysSo) {
  const auto script = scenes::parseExpert("scene = \"lembert\"\nstitch_at_deg = [0, 20]\nagain_deg = [4, -3]\n" + kStitch, "test");
  std::vector<std::string> kinds[2][3];
  double left[2][3] = {}, right[2][3] = {};    // [deg]
  for (const scenes::ExpertAction& a : script.actions) {
    ASSERT_TRUE(a.stitch >= 0 && a.stitch < 2 && a.attempt >= 0 && a.attempt < 3);
    kinds[a.stitch][a.attempt].push_back(a.kind);
    if (a.kind == "bite") (a.bowel == 0 ? left : right)[a.stitch][a.attempt] = a.angleDegrees;
  }
  const double turn[] = {0.0, 4.0, -3.0};      // [deg]
  for (int stitch = 0; stitch < 2; ++stitch)
    for (int attempt = 0; attempt < 3; ++attempt) {
      std::vector<std::string> expected = {"bite", "bite", "cut"};
      if (attempt > 0) expected.insert(expected.begin(), {"take_out", "fresh_thread"});
      if (stitch == 0) expected.push_back("fresh_thread");
      EXPECT_EQ(kinds[stitch][attempt], expected) << stitch << attempt;
      EXPECT_DOUBLE_EQ(left[stitch][attempt], 90.0 + 20.0 * stitch + turn[attempt]);
      EXPECT_DOUBLE_EQ(right[stitch][attempt], 90.0 - 20.0 * stitch - turn[attempt]);
    }
}

/// What a level does not do is not in its stitches; the thread between them is asked for at each level by itself.
TEST(StitchPlaces, MayDifferWithTheLevelOfAssistance) {
  const std::string tie = "[[action]]\ndo = \"let_go\"\nassist = \"none\"\n";
  const auto script = scenes::parseExpert("scene = \"lembert\"\nstitch_at_deg = { none = [0, 20], knot = [30] }\n" + tie + kStitch, "test");
  std::vector<std::string> kinds[2];
  std::vector<double> left[2];                 // [deg]
  for (const scenes::ExpertAction& a : script.actions) {
    ASSERT_TRUE(a.assist);
    const int level = *a.assist == ThreadAssist::kKnot ? 1 : 0;
    kinds[level].push_back(a.kind);
    if (a.kind == "bite" && a.bowel == 0) left[level].push_back(a.angleDegrees);
  }
  EXPECT_EQ(kinds[0], (std::vector<std::string>{"let_go", "bite", "bite", "cut", "fresh_thread", "let_go", "bite", "bite", "cut"}));
  EXPECT_EQ(kinds[1], (std::vector<std::string>{"bite", "bite", "cut"}));
  EXPECT_EQ(left[0], (std::vector<double>{90.0, 110.0}));
  EXPECT_EQ(left[1], (std::vector<double>{120.0}));
}

TEST(StitchPlaces, AreAnglesAndNotTooMany) {
  const auto parse = [](const std::string& places) { scenes::parseExpert("scene = \"lembert\"\nstitch_at_deg = " + places + "\n" + kStitch, "test"); };
  testing::expectRefused([&] { parse("[]"); }, {"test:2", "stitch_at_deg", "1 to 60"});
  testing::expectRefused([&] { parse("[0, 200]"); }, {"test:2", "stitch_at_deg", "-180 to 180"});
  testing::expectRefused([&] { parse("[0, \"top\"]"); }, {"test:2", "stitch_at_deg"});
  testing::expectRefused([&] { parse("[0]\nagain_deg = 4"); }, {"test:3", "again_deg", "1 to 60"});
  testing::expectRefused([&] { scenes::parseExpert("scene = \"lembert\"\nagain_deg = [4]\n" + kStitch, "test"); }, {"test:1", "again_deg", "stitch_at_deg"});
  testing::expectRefused([&] { parse("{ none = [0] }"); }, {"test:2", "stitch_at_deg", "both levels"});
  testing::expectRefused([&] { parse("{ none = [0], glue = [0] }"); }, {"test:2", "stitch_at_deg.glue", "\"none\" or \"knot\""});
  testing::expectRefused([&] { parse("{ none = [0], knot = [] }"); }, {"test:2", "stitch_at_deg.knot", "1 to 60"});
}

/// Places need something that is done at them, at each level that has places.
TEST(StitchPlaces, NeedActionsOfTheStitch) {
  const std::string again = "again_deg = [4]\n", level = "[[action]]\ndo = \"bite\"\nassist = \"knot\"\n";
  const auto parse = [](const std::string& text) { scenes::parseExpert("scene = \"lembert\"\n" + text, "test"); };
  for (const std::string& attempts : {std::string(), again}) {
    testing::expectRefused([&] { parse("stitch_at_deg = [0, 20]\n" + attempts + "[[action]]\ndo = \"change_tools\"\n"); },
                           {"test:2: stitch_at_deg: ", "no action"});
    testing::expectRefused([&] { parse("stitch_at_deg = { knot = [0], none = [1] }\n" + attempts + level); },
                           {"test:2: stitch_at_deg.none: ", "no action"});
  }
}

}  // namespace
}  // namespace halsted
