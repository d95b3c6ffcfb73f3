/// One rule says which scene a word means, whatever folder the user stands in: an installed scene's name first, else a folder. The real program.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scenes/scene.h"
#include "tests/app/program.h"

namespace halsted::app {
namespace {

using halsted::testing::ProcessResult;
using halsted::testing::readText;
using halsted::testing::TemporaryFolder;
using halsted::testing::writeText;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A scene of the user's own: another title, so that it is told from the installed one.
void writeScene(const std::string& folder) {
  std::filesystem::create_directories(folder);
  const std::string text = readText(scenes::scenesDirectory() + "/purse_string/scene.toml");
  const std::size_t title = text.find("title = "), end = text.find('\n', title);
  writeText(folder + "/scene.toml", text.substr(0, title) + "title = \"Mine\"" + text.substr(end));
}

std::string titleOf(const std::string& folder, const std::string& scene) {
  const ProcessResult result = runIn(folder, "train " + scene + " --headless --seconds 0.3 --size 320x180");
  EXPECT_EQ(result.exitCode, 0) << scene << ": " << result.errors;
  return result.output.substr(0, result.output.find('\n')) + (result.errors.find("is trained with its preset") != std::string::npos ? " preset" : "");
}

TEST(SceneNames, MeanTheSameInEveryFolder) {
  const TemporaryFolder folder;
  writeScene(folder.file("stay"));
  EXPECT_THAT(titleOf(folder.path(), "stay"), AllOf(HasSubstr("stay"), HasSubstr("preset"), ::testing::Not(HasSubstr("Mine"))));
  EXPECT_THAT(titleOf(folder.path(), "./stay"), AllOf(HasSubstr("Mine"), ::testing::Not(HasSubstr("preset"))));
}

TEST(SceneNames, AreFoldersWhereNoSceneHasTheName) {
  const TemporaryFolder folder;
  writeScene(folder.file("mine"));
  for (const char* scene : {"mine", "mine/", "./mine"}) EXPECT_THAT(titleOf(folder.path(), scene), HasSubstr("Mine")) << scene;
  EXPECT_THAT(titleOf(folder.file("mine"), "."), HasSubstr("Mine"));
  const ProcessResult none = runIn(folder.path(), "train yours --headless");
  EXPECT_EQ(none.exitCode, 2);
  EXPECT_THAT(none.errors, AllOf(HasSubstr("unknown scene 'yours'"), HasSubstr("purse_string")));
}

TEST(SceneNames, AreListedBesideOneThatIsBroken) {
  const TemporaryFolder folder;
  for (const char* file : {"materials.toml", "purse_string/scene.toml"}) {
    std::filesystem::create_directories(std::filesystem::path(folder.file(file)).parent_path());
    writeText(folder.file(file), readText(scenes::scenesDirectory() + "/" + file));
  }
  std::filesystem::create_directories(folder.file("broken"));
  writeText(folder.file("broken/scene.toml"), "title = 3\n");
  const ProcessResult result = runIn("/", "scenes --json");
  EXPECT_EQ(result.exitCode, 0);
  const ProcessResult broken = halsted::testing::run({"/usr/bin/env", "HALSTED_SCENES=" + folder.path(), HALSTED_BINARY, "scenes", "--json"});
  EXPECT_EQ(broken.exitCode, 2);
  EXPECT_THAT(broken.errors, HasSubstr("broken/scene.toml:1: title"));
  ASSERT_EQ(nlohmann::json::parse(broken.output).size(), 1u);
}

}  // namespace
}  // namespace halsted::app
