/// Which mesh files a scene may name, and the tissue presets beside the scenes.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "scenes/materials.h"
#include "scenes/scene.h"
#include "tests/scenes/surface_makers.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

using scenes::parseScene;
using scenes::SceneFile;
using testing::expectRefused;

/// A scene folder with a mesh inside, and another mesh beside the folder.
struct MeshPaths : ::testing::Test {
  std::string root = testing::freshFolder("root"), folder = root + "/scene";

  void SetUp() override {
    std::filesystem::create_directories(folder + "/meshes");
    const std::string obj = testing::asObj(testing::tubeSurface({}));
    testing::writeFile(folder + "/meshes/tube.obj", obj);
    testing::writeFile(root + "/outside.obj", obj);
  }
  SceneFile read(const std::string& path) const {
    return parseScene("title = \"t\"\n[anatomy]\nmesh = \"" + path + "\"\n", "scene.toml", folder, {});
  }
};

TEST_F(MeshPaths, InsideTheFolderAreOpened) {
  testing::expectWholeWall(scenes::buildAnatomy(read("meshes/tube.obj")).mesh);
  EXPECT_NO_THROW(read("meshes/../meshes/tube.obj"));
}

TEST_F(MeshPaths, InAFileMayNotLeaveTheFolder) {
  const std::string place = "scene.toml:3: anatomy.mesh: ", outside = "lies outside the scene's folder and HALSTED_DATA";
  expectRefused([&] { read("../outside.obj"); }, {place, outside});
  expectRefused([&] { read(root + "/outside.obj"); }, {place, outside});
  expectRefused([&] { read("/etc/passwd"); }, {place, outside});
  std::filesystem::create_symlink(root + "/outside.obj", folder + "/link.obj");
  expectRefused([&] { read("link.obj"); }, {place, outside});
  expectRefused([&] { read("missing.obj"); }, {place, "no file 'missing.obj'"});
}

TEST_F(MeshPaths, OnTheCommandLineAreTheUsersWord) {
  const std::string set = "anatomy.mesh=" + root + "/outside.obj";
  EXPECT_NO_THROW(scenes::buildAnatomy(parseScene("title = \"t\"", "scene.toml", folder, {set})));
  expectRefused([&] { parseScene("title = \"t\"", "session", folder, {set}, scenes::PathTrust::kFile); }, {"--set ", "lies outside"});
}

TEST_F(MeshPaths, MayLieInTheDataFolder) {
  const char* before = std::getenv("HALSTED_DATA");
  const std::string kept = before ? before : "";
  ASSERT_EQ(setenv("HALSTED_DATA", root.c_str(), 1), 0);
  EXPECT_NO_THROW(read("outside.obj"));
  EXPECT_NO_THROW(read("$HALSTED_DATA/outside.obj"));
  ASSERT_EQ(unsetenv("HALSTED_DATA"), 0);
  expectRefused([&] { read("$HALSTED_DATA/outside.obj"); }, {"HALSTED_DATA is not set"});
  if (before) setenv("HALSTED_DATA", kept.c_str(), 1);
}

TEST(Materials, AllHaveASourceAndValuesInRange) {
  const std::vector<scenes::Material> materials = scenes::readMaterials();
  EXPECT_GE(materials.size(), 10u);
  for (const scenes::Material& material : materials) EXPECT_GT(material.source.size(), 20u) << material.name;
}

TEST(Materials, RefuseMistakesNamingTheLine) {
  const auto parsing = [](const std::string& text) { return [text] { scenes::parseMaterials(text, "m.toml"); }; };
  expectRefused(parsing("[a]\nyoungs_modulus = 1e5\n"), {"m.toml:1: a: has no poisson_ratio"});
  expectRefused(parsing("[a]\nstiffness = 1e5\n"), {"m.toml:2: a.stiffness: unknown key"});
  expectRefused(parsing("[a]\nyoungs_modulus = 1e5\npoisson_ratio = 0.6\ndensity = 1000"), {"m.toml:3: a.poisson_ratio: must be 0 to 0.495"});
  expectRefused(parsing("[a]\nyoungs_modulus = 1e5\npoisson_ratio = 0.4\ndensity = 1000"), {"m.toml:1: a: has no source"});
  expectRefused(parsing("a = 3"), {"m.toml:1: a: must be a table"});
}

}  // namespace
}  // namespace halsted
