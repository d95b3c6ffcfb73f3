/// Bad input of every kind: one line that names the file and what is wrong, and the exit code of DESIGN 5. The real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/program.h"
#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

using halsted::testing::ProcessResult;
using halsted::testing::run;
using halsted::testing::TemporaryFolder;
using ::testing::HasSubstr;

TEST(CommandLine, BadUsageIsCodeTwo) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{}, {"operate"}, {"replay"}, {"replay", expertPath(), "--bogus"}, {"bench", "--steps", "many"},
        {"bench", "--preset", "fast"}, {"train", "purse_string", "--seconds", "-1"}})
    EXPECT_EQ(runHalsted(arguments).exitCode, 2);
}

TEST(CommandLine, WhatWasTypedIsNamedWithTheNearest) {
  expectRefused({"bogus"}, "unknown command bogus; there are scenes, train, replay");
  expectRefused({"trian", "purse_string"}, "unknown command trian; did you mean train?");
  expectRefused({"--jsn", "scenes"}, "unknown option --jsn");
  expectRefused({"scenes", "--jsn"}, "unknown option --jsn; did you mean --json?");
  expectRefused({"replay", "--verfy"}, "unknown option --verfy; did you mean --verify?");
  expectRefused({"train", "purse_string", "--secnods=3"}, "unknown option --secnods; did you mean --seconds?");
  expectRefused({"replay", expertPath(), "second.toml"}, "one argument too many: second.toml");
  expectRefused({}, "halsted --help");
  expectRefused({"replay"}, "halsted replay --help");
  expectRefused({"survey", "scroe"}, "unknown command scroe; did you mean score?");
}

TEST(CommandLine, HelpTeachesWithExamples) {
  const ProcessResult help = runHalsted({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_THAT(help.output, HasSubstr("halsted replay run.halsted --verify"));
  for (const char* command : {"scenes", "train", "replay", "capture", "bench"}) EXPECT_EQ(runHalsted({command, "--help"}).exitCode, 0);
}

TEST(CommandLine, UnknownNamesAreNamed) {
  expectRefused({"train", "appendix", "--headless"}, "appendix");
  expectRefused({"train", "purse_string", "--headless", "--left", "novint"}, "novint");
  expectRefused({"bench", "--scene", "altemeier", "--preset", "paper"}, "altemeier: has no preset 'paper'");
  expectRefused({"train", "purse_string", "--headless", "--left", "script:none.toml"}, "none.toml");
  expectRefused({"replay", "none.toml"}, "none.toml");
  expectRefused({"replay", "none.halsted"}, "none.halsted");
  expectRefused({"replay", expertPath(), "--set", "tissue.colour=3"}, "tissue.colour");
  expectRefused({"replay", expertPath(), "--set", "tissue.poisson_ratio=2"}, "tissue.poisson_ratio");
  expectRefused({"replay", expertPath(), "--set", "novalue"}, "novalue");
  expectRefused({"replay", expertPath(), "--preset", "fast"}, "no such preset; it has paper");
  expectRefused({"train", "purse_string", "--headless", "--preset", "fast"}, "no such preset; it has paper");
  expectRefused({"replay", expertPath(), "--verify"}, "--verify");
  expectRefused({"bench", "--scene", "appendix"}, "appendix");
  expectRefused({"capture", expertPath()}, "--out");
  expectRefused({"capture", expertPath(), "--out", "/nowhere", "--size", "1x1"}, "--size");
}

TEST(CommandLine, WhatIsNotANumberIsNotInItsRange) {
  const TemporaryFolder folder;
  const std::vector<std::string> capture{"capture", expertPath(), "--out", folder.file("frames")};
  const auto with = [](std::vector<std::string> arguments, const std::string& option, const std::string& value) {
    arguments.insert(arguments.end(), {option, value});
    return arguments;
  };
  for (const char* text : {"nan", "inf", "1e999", "two", "3s"}) {
    expectRefused({"train", "purse_string", "--headless", "--seconds", text}, "--seconds");
    expectRefused({"replay", expertPath(), "--from", text}, "--from");
    expectRefused(with(capture, "--at", std::string("0.1,") + text + ",2"), "--at");
    expectRefused(with(capture, "--fps", text), "--fps");
    expectRefused({"survey", "score", "none.csv", "--mu", text}, "--mu");
  }
  expectRefused({"train", "purse_string", "--headless", "--seconds", "two"}, "two is not a number");
  expectRefused({"survey", "score", "none.csv", "--mu", "1.5"}, "1.5 is not 0 to 1");
}

TEST(CommandLine, ATableOfScoresIsUtf8) {
  const TemporaryFolder folder;
  halsted::testing::writeText(folder.file("raters.csv"), "system,rater\nGer\xe4t,1\n");
  expectRefused({"survey", "score", folder.file("raters.csv"), "--json"}, "raters.csv:2: bytes that are not UTF-8");
}

TEST(CommandLine, AnUnknownSceneOfAScriptIsNamedWithItsLine) {
  const TemporaryFolder folder;
  halsted::testing::writeText(folder.file("a.toml"), "# mine\nscene = \"nope\"\n[[action]]\ndo = \"hold\"\n");
  expectRefused({"replay", folder.file("a.toml")}, "a.toml:2: scene: unknown scene 'nope'");
  halsted::testing::writeText(folder.file("b.toml"), "scene = \"stay\"\n[[action]]\ndo = \"hold\"\n");
  expectRefused({"train", "purse_string", "--headless", "--left", "script:" + folder.file("b.toml")}, "b.toml:1: scene: this script is for stay");
}

TEST(CommandLine, ABrokenScriptIsNamedWithItsLine) {
  const TemporaryFolder folder;
  halsted::testing::writeText(folder.file("expert.toml"), "scene = \"purse_string\"\n\n[[action]]\ndo = \"dance\"\n");
  expectRefused({"replay", folder.file("expert.toml")}, "expert.toml:");
}

TEST(CommandLine, WhatCannotBeWrittenIsSaidBeforeTheRun) {
  const TemporaryFolder folder;
  EXPECT_EQ(runHalsted({"replay", expertPath(), "--record", folder.file("no/such/folder/a.halsted")}).exitCode, 3);
  EXPECT_EQ(runHalsted({"replay", expertPath(), "--report", folder.file("no/such/folder/a.html")}).exitCode, 3);
  halsted::testing::writeText(folder.file("precious.txt"), "thesis");
  expectRefused({"replay", expertPath(), "--record", folder.file("precious.txt")}, "not overwritten");
}

/// 41 s of acupuncture, a whole state every 5 s.
TEST(CommandLine, ASessionIsEnteredAtTheLastWholeStateByThen) {
  const TemporaryFolder folder;
  const std::string session = folder.file("a.halsted"), script = testing::sourceFolder() + "/scenes/acupuncture/expert.toml";
  ASSERT_EQ(runHalsted({"replay", script, "--record", session}).exitCode, 0);
  for (const auto& [from, checked] : {std::pair{"9.9996", "36012"}, {"12.3", "31012"}, {"35", "6012"}}) {
    const ProcessResult result = runHalsted({"replay", session, "--verify", "--from", from});
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    EXPECT_THAT(result.output, HasSubstr(std::string("all ") + checked + " state hashes are equal")) << from;
  }
  const ProcessResult capture = runHalsted({"capture", session, "--from", "38", "--at", "3,36,37", "--out", folder.file("frames"), "--video", folder.file("a.mp4"), "--size", "320x180"});
  EXPECT_EQ(capture.exitCode, 0) << capture.errors;
  EXPECT_THAT(capture.output, HasSubstr("2 PNG frames"));
  EXPECT_THAT(capture.output, HasSubstr("1 of the times lie before the run begins"));
  EXPECT_THAT(capture.output, HasSubstr(": 181 frames at 30 Hz"));   // from 35 s to 41.012 s
  const ProcessResult pictures = runHalsted({"capture", session, "--from", "5", "--at", "6,7.5", "--out", folder.file("two"), "--size", "320x180"});
  EXPECT_EQ(pictures.exitCode, 0) << pictures.errors;
  EXPECT_THAT(pictures.output, HasSubstr("2 PNG frames"));
  EXPECT_THAT(pictures.output, HasSubstr("not completed in 7.50 s simulated"));
  EXPECT_THAT(pictures.output, HasSubstr("ended with the last of the frames asked for"));
  EXPECT_THAT(pictures.output, ::testing::Not(HasSubstr("core of its own")));   // other threads draw: it would not be so fast
  const ProcessResult checked = runHalsted({"capture", session, "--verify", "--from", "35", "--at", "35", "--out", folder.file("one"), "--size", "320x180"});
  EXPECT_EQ(checked.exitCode, 0) << checked.errors;
  EXPECT_THAT(checked.output, HasSubstr("all 6012 state hashes are equal"));   // drawn before the first step; all of it is checked
  expectRefused({"replay", session, "--from", "42"}, "a.halsted: --from 42 s: the session ends at 41.012 s");
  expectRefused({"replay", session, "--from", "-1"}, "--from");
  expectRefused({"replay", session, "--from", "5", "--record", folder.file("b.halsted")}, "leave out --from");
  expectRefused({"replay", script, "--from", "5"}, "expert.toml: --from needs a recorded session");
}

/// A thread cannot have had more of its core than time went by: with a core of its own it would be as fast or faster.
TEST(CommandLine, AReplaySaysHowFastACoreOfItsOwnWouldBe) {
  const ProcessResult result = runHalsted({"replay", testing::sourceFolder() + "/scenes/acupuncture/expert.toml", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  const auto timing = nlohmann::json::parse(result.output)["timing"];
  EXPECT_GT(timing["realtime_factor"].get<double>(), 0.0);
  EXPECT_GT(timing["realtime_factor_cpu"].get<double>(), 0.999 * timing["realtime_factor"].get<double>());
}

/// As many particles, of tissue and of thread, as the published scenes have (paper 003).
TEST(CommandLine, ScenesAreListedWithTheirSizeWhichIsThePublishedOne) {
  const ProcessResult result = runHalsted({"scenes", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  const auto list = nlohmann::json::parse(result.output);
  std::map<std::string, nlohmann::json> scenes;
  for (const auto& scene : list) scenes[scene["name"]] = scene;
  struct Published { const char* name; double tissue, thread; };   // [1] particles
  for (const auto& p : {Published{"purse_string", 1228, 175}, {"connell", 2370, 101}, {"stay", 2370, 101}, {"lembert", 4054, 101}}) {
    ASSERT_TRUE(scenes.contains(p.name)) << p.name;
    const nlohmann::json& scene = scenes[p.name];
    const double tissue = scene["particles"], thread = scene["thread_nodes"];
    EXPECT_NEAR(tissue, p.tissue, 0.02 * p.tissue) << p.name;
    EXPECT_NEAR(tissue + thread, p.tissue + p.thread, 0.02 * (p.tissue + p.thread)) << p.name;
    EXPECT_GT(scene["tets"].get<int>(), 1000) << p.name;
  }
  EXPECT_EQ(scenes["purse_string"]["thread_nodes"], 175);
}

/// Where knots of friction run slower than real time a session has the beginner's, unless something else is asked for.
TEST(CommandLine, TrainTakesTheLevelThatKeepsRealTime) {
  const auto assistOf = [](const std::vector<std::string>& more) {
    std::vector<std::string> command{"train", "stay", "--headless", "--seconds", "0.3", "--size", "320x180", "--json"};
    command.insert(command.end(), more.begin(), more.end());
    const ProcessResult result = runHalsted(command);
    EXPECT_EQ(result.exitCode, 0) << result.errors;
    return nlohmann::json::parse(result.output)["assist"].get<std::string>();
  };
  EXPECT_EQ(assistOf({}), "knot");
  EXPECT_EQ(assistOf({"--preset", "default"}), "none");
  EXPECT_EQ(assistOf({"--preset", "friction"}), "none");
  EXPECT_EQ(assistOf({"--set", "thread.assist=none"}), "none");
}

TEST(CommandLine, BenchPrintsItsRows) {
  const ProcessResult result = runHalsted({"bench", "--scene", "purse_string", "--steps", "20", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  const auto rows = nlohmann::json::parse(result.output);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["preset"], "default");
  EXPECT_EQ(rows[1]["preset"], "paper");
  EXPECT_EQ(rows[1]["published_ms"], 5.61);
  for (const char* key : {"particles", "tets", "thread_nodes", "step_ms", "frame_ms", "published_hardware"}) EXPECT_TRUE(rows[0].contains(key)) << key;
}

TEST(CommandLine, BenchMeasuresAPresetOnlyWhereASceneHasIt) {
  const ProcessResult result = runHalsted({"bench", "--preset", "paper", "--steps", "20", "--json"});
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  std::vector<std::string> scenes;
  for (const auto& row : nlohmann::json::parse(result.output)) scenes.push_back(row["scene"]);
  EXPECT_THAT(scenes, ::testing::UnorderedElementsAre("acupuncture", "connell", "lembert", "purse_string", "stay"));
}

}  // namespace
}  // namespace halsted::app
