/// What a command writes never costs the user a file: not the one that is replayed, not another output, not an earlier session that the
/// run could not have replaced. The real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/app/program.h"
#include "tests/app/short_script.h"

namespace halsted::app {
namespace {

using halsted::testing::ProcessResult;
using halsted::testing::readText;
using halsted::testing::TemporaryFolder;
using halsted::testing::writeText;
using ::testing::HasSubstr;

TEST(OutputFiles, AreNeverTheFileThatIsReplayed) {
  const TemporaryFolder folder;
  const std::string script = writeShortScript(folder), link = folder.file("link.toml"), before = readText(script);
  std::filesystem::create_hard_link(script, link);
  for (const char* option : {"--record", "--report"})
    for (const std::string& path : {script, folder.path() + "/./short.toml", link})
      expectRefused({"replay", script, option, path}, std::string(option) + " would overwrite the file that is replayed");
  expectRefused({"capture", script, "--video", script}, "--video would overwrite the file that is replayed");
  EXPECT_EQ(readText(script), before);
}

TEST(OutputFiles, AreDifferentFromEachOther) {
  const TemporaryFolder folder;
  const std::string script = writeShortScript(folder), same = folder.file("same"), again = folder.path() + "/./same";
  expectRefused({"replay", script, "--record", same, "--report", again}, "--record and --report name the same file");
  expectRefused({"capture", script, "--record", same, "--video", again}, "--record and --video name the same file");
  expectRefused({"capture", script, "--report", same, "--video", again}, "--report and --video name the same file");
  EXPECT_FALSE(std::filesystem::exists(same));
}

/// A name that SQLite would take for no file at all.
TEST(OutputFiles, AreMadeUnderTheNameThatWasGiven) {
  const TemporaryFolder folder;
  writeShortScript(folder);
  EXPECT_EQ(runIn(folder.path(), "replay short.toml --record :memory:").exitCode, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.file(":memory:")));
  EXPECT_EQ(runIn(folder.path(), "replay :memory: --verify").exitCode, 0);
}

TEST(OutputFiles, AnEarlierSessionStaysWhereNothingCouldBeDrawn) {
  const TemporaryFolder folder;
  const std::string script = writeShortScript(folder), session = folder.file("old.halsted");
  ASSERT_EQ(runHalsted({"replay", script, "--record", session}).exitCode, 0);
  const std::string before = readText(session);
  expectRefused({"capture", script, "--record", session, "--video", folder.file("a.mp4"), "--size", "321x181"}, "--size: a video needs an even width");
  expectRefused({"capture", script, "--record", session, "--video", folder.file("a.mp4"), "--fps", "500"}, "--fps: a video needs 1 to 240");
  expectRefused({"capture", script, "--record", session, "--video", folder.file("a.mp4"), "--fps", "0.5"}, "--fps: a video needs 1 to 240");
  EXPECT_EQ(readText(session), before);
}

/// A script that does not fit the scene is bad input, before any thread runs and before the earlier session gives way.
TEST(OutputFiles, AnEarlierSessionStaysWhereAScriptDoesNotFitTheScene) {
  const TemporaryFolder folder;
  const std::string script = writeShortScript(folder), bad = folder.file("bad.toml"), session = folder.file("k.halsted");
  ASSERT_EQ(runHalsted({"replay", script, "--record", session}).exitCode, 0);
  const std::string before = readText(session);
  writeText(bad, "scene = \"purse_string\"\n[[action]]\ndo = \"insert\"\n");
  const std::string expected = "bad.toml:2: action.do: 'insert' is not done in a scene of this kind";
  expectRefused({"train", "purse_string", "--headless", "--seconds", "1", "--size", "320x180", "--left", "script:" + bad, "--record", session}, expected);
  expectRefused({"replay", bad, "--record", session}, expected);
  writeText(bad, "scene = \"purse_string\"\n\n[[action]]\ndo = \"bite\"\nbowel = 2\n");
  expectRefused({"train", "purse_string", "--headless", "--seconds", "1", "--size", "320x180", "--left", "script:" + bad, "--record", session},
                "bad.toml:3: action.do: impossible bite");
  EXPECT_EQ(readText(session), before);
}

TEST(OutputFiles, LostStandardOutputIsASystemFault) {
  const TemporaryFolder folder;
  writeShortScript(folder);
  for (const std::string command : {"replay short.toml --json", "scenes", "--help", "--version"}) {
    const ProcessResult result = runIn(folder.path(), command, "/dev/full");
    EXPECT_EQ(result.exitCode, 3) << command;
    EXPECT_THAT(result.errors, HasSubstr("standard output")) << command;
  }
}

}  // namespace
}  // namespace halsted::app
