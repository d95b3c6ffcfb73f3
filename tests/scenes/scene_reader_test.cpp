/// Scene files: every key is read, and every mistake is refused in one line that names file, line and key.
#include <gtest/gtest.h>

#include <algorithm>

#include "scenes/scene.h"
#include "tests/scenes/wall_laws.h"

namespace halsted {
namespace {

using scenes::parseScene;
using scenes::SceneFile;
using testing::expectRefused;

SceneFile parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parseScene(text, "test.toml", "/tmp/test_scene", overrides);
}
SceneFile withTitle(const std::string& rest, const std::vector<std::string>& overrides = {}) {
  return parse("title = \"t\"\n" + rest, overrides);
}

TEST(PurseStringScene, IsReadAndBuilt) {
  const SceneFile scene = scenes::readScene(scenes::scenesDirectory() + "/purse_string", {});
  EXPECT_EQ(scene.name, "purse_string");
  EXPECT_EQ(scene.title, "Purse-string suture");
  EXPECT_EQ(scene.params.tools[kLeft].kind, ToolKind::kForceps);
  EXPECT_EQ(scene.params.tools[kRight].kind, ToolKind::kNeedleDriver);
  EXPECT_EQ(scene.params.thread.nodes, 175);
  EXPECT_DOUBLE_EQ(scene.params.tissue.youngsModulus, 120e3);
  EXPECT_DOUBLE_EQ(scene.camera.fovDegrees, 27.0);
  testing::expectWholeWall(scenes::buildAnatomy(scene).mesh);
}

TEST(PurseStringScene, HasTheProcedureOfTheSurgeon) {
  const SceneFile scene = scenes::readScene("purse_string", {});
  ASSERT_EQ(scene.procedure.size(), 4u);
  EXPECT_EQ(scene.procedure[0].done.quantity, Quantity::kNeedleHeld);
  EXPECT_EQ(scene.procedure[1].done.quantity, Quantity::kBites);
  EXPECT_DOUBLE_EQ(scene.procedure[1].done.min, 8.0);
  EXPECT_TRUE(scene.procedure[1].hasFault);
  EXPECT_EQ(scene.procedure[1].fault.quantity, Quantity::kStitchAcrossOpening);
  EXPECT_EQ(scene.procedure[2].done.quantity, Quantity::kTailsHeld);
  EXPECT_DOUBLE_EQ(scene.procedure[3].done.max, 0.15);
  EXPECT_DOUBLE_EQ(scene.procedure[3].done.hold, 0.5);
  for (const ProcedureStep& step : scene.procedure) EXPECT_GT(step.limit, 0.0);
}

TEST(Scenes, AreListedInOrder) {
  const std::vector<std::string> folders = scenes::sceneFolders();
  EXPECT_TRUE(std::is_sorted(folders.begin(), folders.end()));
  EXPECT_NE(std::find(folders.begin(), folders.end(), scenes::scenesDirectory() + "/purse_string"), folders.end());
  for (const std::string& folder : folders) EXPECT_NO_THROW(scenes::readScene(folder, {})) << folder;
}

TEST(SceneReader, PutsValuesWhereTheyBelong) {
  const SceneFile scene = withTitle("[tissue]\nsolver = \"shape_matching\"\nyoungs_modulus = 5000\n[tool.left]\ngrip_force = 3.5\n"
                                    "[anvil]\nto = [0, 0.001, 2e-3]\n[sim]\nseed = 9\n[needle]\ntear_force = 2");
  EXPECT_EQ(scene.params.tissue.solver, TissueSolver::kShapeMatching);
  EXPECT_DOUBLE_EQ(scene.params.tissue.youngsModulus, 5000.0);
  EXPECT_DOUBLE_EQ(scene.params.tools[kLeft].gripForce, 3.5);
  EXPECT_EQ(scene.params.anvil.to, Vec3(0, 0.001, 2e-3));
  EXPECT_EQ(scene.params.seed, 9u);
  EXPECT_DOUBLE_EQ(scene.params.needle.tearForce, 2.0);
}

TEST(SceneReader, LetsOverridesWinOverTheFileAndLaterOnesOverEarlier) {
  const SceneFile scene = withTitle("tissue.density = 1000", {"tissue.density=1100", "tissue.density=1200", "title=Other words"});
  EXPECT_DOUBLE_EQ(scene.params.tissue.density, 1200.0);
  EXPECT_EQ(scene.title, "Other words");
  EXPECT_EQ(scene.overrides.size(), 3u);
}

TEST(SceneReader, AppliesThePresetThatAnOverrideNamesWhereItStands) {
  const std::string text = "[thread]\nnodes = 60\n[preset]\nfine = [\"thread.nodes=90\", \"anatomy.gap=2e-3\"]\nnested = [\"preset=fine\"]\nwrong = [\"thread.colour=1\"]\n";
  EXPECT_EQ(withTitle(text).params.thread.nodes, 60);            // a preset that nobody names changes nothing
  const SceneFile fine = withTitle(text, {"preset=fine"});
  EXPECT_EQ(fine.params.thread.nodes, 90);
  EXPECT_DOUBLE_EQ(fine.params.anatomy.gap, 2e-3);
  EXPECT_EQ(fine.overrides, std::vector<std::string>{"preset=fine"});
  EXPECT_EQ(withTitle(text, {"preset=fine", "thread.nodes=70"}).params.thread.nodes, 70);
  EXPECT_EQ(withTitle(text, {"thread.nodes=70", "preset=fine"}).params.thread.nodes, 90);
  expectRefused([&] { withTitle(text, {"preset=coarse"}); }, {"--set preset=coarse", "fine, nested, wrong"});
  expectRefused([&] { withTitle(text, {"preset=nested"}); }, {"--set preset=nested", "not other presets"});
  expectRefused([&] { withTitle(text, {"preset=wrong"}); }, {"thread.colour"});
}

TEST(SceneReader, KnowsThePresetThatIsTrainedAndTheSceneAsItIs) {
  const SceneFile scene = withTitle("train_preset = \"easy\"\n[thread]\nnodes = 60\n[preset]\neasy = [\"thread.nodes=90\"]\n", {"preset=default"});
  EXPECT_EQ(scene.trainPreset, "easy");
  EXPECT_EQ(scene.params.thread.nodes, 60);
  expectRefused([&] { withTitle("train_preset = \"hard\"\n[preset]\neasy = []\n"); }, {":2: train_preset", "no preset 'hard'"});
}

TEST(SceneReader, LetsExplicitKeysWinOverTheMaterial) {
  const SceneFile scene = withTitle("[tissue]\ndensity = 999\nmaterial = \"rectosigmoid\"");
  EXPECT_DOUBLE_EQ(scene.params.tissue.youngsModulus, 5.18e6);
  EXPECT_DOUBLE_EQ(scene.params.tissue.density, 999.0);
}

TEST(SceneReader, GivesTheSameSceneFromTheTextItKept) {
  const SceneFile first = scenes::readScene("purse_string", {"tissue.material=fat"});
  const SceneFile again = parseScene(first.text, "session", first.folder, first.overrides);
  EXPECT_EQ(testing::bitsOf(scenes::buildAnatomy(first).mesh), testing::bitsOf(scenes::buildAnatomy(again).mesh));
  EXPECT_DOUBLE_EQ(again.params.tissue.youngsModulus, first.params.tissue.youngsModulus);
}

struct BadText {
  const char* text;
  const char* message;
};

class BadScenes : public ::testing::TestWithParam<BadText> {};

TEST_P(BadScenes, AreRefusedNamingFileLineAndKey) {
  expectRefused([] { withTitle(GetParam().text); }, {"test.toml:", GetParam().message});
}

INSTANTIATE_TEST_SUITE_P(
    All, BadScenes,
    ::testing::Values(
        BadText{"[thread]\nspare = 2", "test.toml:3: thread.spare: needs thread.knots"},
        BadText{"[assistant]\nclamps = 2", "test.toml:3: assistant.clamps: no hand has a clamp"},
        BadText{"[assistant]\nclamps = 5", "test.toml:3: assistant.clamps: "},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"i\"\ndone = { quantity = \"bites\", min = 1 }\nrepeat_from = \"a\"",
                "repeat_from and repeat_until go together"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"i\"\ndone = { quantity = \"bites\", min = 1 }\nagain_from = \"a\"",
                "again_from and again_when go together"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"i\"\ndone = { quantity = \"bites\", min = 1 }\nagain_from = \"a\"\n"
                "again_when = { quantity = \"bites\", max = 0 }",
                "procedure.again_from: no step up to here is called 'a'"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"i\"\ndone = { quantity = \"bites\", min = 1 }\nrepeat_from = \"b\"\n"
                "repeat_until = { quantity = \"stitches\", min = 2 }",
                "procedure.repeat_from: no step up to here is called 'b'"},
        BadText{"[tisue]\nyoungs_modulus = 1e5", "test.toml:3: tisue.youngs_modulus: unknown table [tisue]"},
        BadText{"[tissue]\nyoung = 1e5", "test.toml:3: tissue.young: unknown key"},
        BadText{"[tool.middle]\nkind = \"forceps\"", "unknown table [tool.middle]"},
        BadText{"[nothing]", "test.toml:2: nothing: unknown key"},
        BadText{"[tissue]\nyoungs_modulus = \"soft\"", "test.toml:3: tissue.youngs_modulus: must be a number, is a text"},
        BadText{"[tissue]\nyoungs_modulus = -1", "test.toml:3: tissue.youngs_modulus: must be 100 to 1e+09 Pa, is -1"},
        BadText{"[tissue]\nyoungs_modulus = nan", "tissue.youngs_modulus: must be 100 to 1e+09 Pa, is nan"},
        BadText{"[tissue]\nyoungs_modulus = inf", "must be 100 to 1e+09 Pa, is inf"},
        BadText{"[tissue]\npoisson_ratio = 0.5", "tissue.poisson_ratio: must be 0 to 0.495"},
        BadText{"[tissue]\nsolver = \"magic\"", "'magic' is not one of projective, xpbd, shape_matching"},
        BadText{"[tissue]\nsubsteps = 1.5", "tissue.substeps: must be an integer, is a number"},
        BadText{"[tissue]\nmaterial = \"gold\"", "tissue.material: 'gold' is not one of brain, colon_handling"},
        BadText{"tissue = 3", "test.toml:2: tissue: unknown key"},
        BadText{"[sim]\ngravity = [0, 1]", "sim.gravity: must be a list of three numbers, is a list of another length"},
        BadText{"[sim]\ngravity = 9.81", "sim.gravity: must be a list of three numbers, is a number"},
        BadText{"[sim]\ngravity = [0, \"down\", 0]", "sim.gravity: must be a number, is a text"},
        BadText{"[sim]\ndt = 1.0", "sim.dt: must be 1e-05 to 0.02 s, is 1"},
        BadText{"[sim]\nseed = -1", "sim.seed: must be 0 to"},
        BadText{"[camera]\neye = [0, 0, 0]\ntarget = [0, 0, 0]", "camera.eye: eye and target coincide"},
        BadText{"[anvil]\nfrom = [0, 0, 0]\nto = [0, 0, 0]", "anvil.to: the anvil has no length"},
        BadText{"[anatomy]\naround = 200\nalong = 200", "anatomy.around: 2 x around x along must be at most 20000"},
        BadText{"[anatomy]\nwall = 0.018", "anatomy.wall: wall and haustra_depth together leave no lumen"},
        BadText{"[anatomy]\nsegment = \"0.3\"", "anatomy.segment: needs anatomy.mesh"},
        BadText{"[thread]\nnodes = 2000\nsegment_length = 0.02", "thread.segment_length: the thread is longer than 3 m"},
        BadText{"technique = \"a\\u0007b\"", "technique: contains a control character"},
        BadText{"[tissue", "test.toml:2: "},
        BadText{"\u00e9 = 1", "test.toml:2: a letter outside ASCII, outside double quotes"},
        BadText{"[tissue]\n# a comment may say \u00e9\ndensity \u00e9 = 1000", "test.toml:4: a letter outside ASCII"},
        BadText{"technique = \"\u00e9 \\\" \u00e9\"\n\u00e9 = 1", "test.toml:3: a letter outside ASCII"},
        BadText{"[!]", "test.toml:2: '[' without a name or value"}, BadText{"[+]", "test.toml: is not TOML"},
        BadText{"technique = \"\\\u00e9\"", "test.toml:2: a backslash before a letter outside ASCII"},
        BadText{"technique = \"\xff\"", "test.toml:2: bytes that are not UTF-8"},
        BadText{"technique = \"\xc0\x80\"", "test.toml:2: bytes that are not UTF-8"},
        BadText{"technique = \"\xed\xa0\x80\"", "test.toml:2: bytes that are not UTF-8"},
        BadText{"technique = '\u00e9'", "test.toml:2: a letter outside ASCII, outside double quotes"},
        BadText{"technique = 0\"\u00e9\"", "test.toml:2: "},
        BadText{"a\x01 = 1", "test.toml:2: a control character"},
        BadText{"title = \"again\"", "test.toml:2: "},
        BadText{"procedure = 3", "procedure: must be [[procedure]] tables, is an integer"},
        BadText{"[[procedure]]\nid = \"a\"", "step 'a' has no instruction"},
        BadText{"[[procedure]]\ninstruction = \"a\"", "a step has no id"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"", "step 'a' has no done condition"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"\ndone = { quantity = \"luck\", min = 1 }",
                "test.toml:5: procedure.done.quantity: 'luck' is not one of time, needle_held"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"\ndone = { quantity = \"bites\" }", "has neither min nor max"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"\ndone = { min = 1 }", "has no quantity"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"\ndone = { quantity = \"bites\", min = 2, max = 1 }", "min must not exceed max"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"\ndone = { quantity = \"bites\", min = 2, hold_s = -1 }",
                "procedure.done.hold_s: must be 0 to 86400 s"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"\ndone = { quantity = \"bites\", minimum = 2 }", "done.minimum: unknown key"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"\nlimit = 3\ndone = { quantity = \"bites\", min = 1 }",
                "procedure.limit: unknown key"},
        BadText{"[[procedure]]\nid = \"a\"\ninstruction = \"b\"\ndone = { quantity = \"bites\", min = 1 }\n"
                "fault = { quantity = \"tears\", min = 1 }", "procedure.fault: has no name"}));

TEST(SceneReader, KeepsLettersOfAnyLanguageInQuotes) {
  EXPECT_EQ(withTitle("technique = \"N\u00e4hte\" # \u00e9").technique, "N\u00e4hte");
  EXPECT_EQ(withTitle("technique = \"\"\"\n\"a\"\u00e9\"\"\"\"").technique, "\"a\"\u00e9\"");
  EXPECT_EQ(withTitle("technique = \"\u20ac \U0001F9F5\"").technique, "\u20ac \U0001F9F5");
}

TEST(SceneReader, NeedsATitle) { expectRefused([] { parse(""); }, {"test.toml: title: is missing"}); }

TEST(SceneReader, RefusesTwoStepsOfOneNameAndTooManySteps) {
  const std::string step = "\ninstruction = \"b\"\ndone = { quantity = \"bites\", min = 1 }\n";
  expectRefused([&] { withTitle("[[procedure]]\nid = \"a\"" + step + "[[procedure]]\nid = \"a\"" + step); }, {"two steps are called 'a'"});
  std::string many;
  for (int i = 0; i <= kMaxProcedureSteps; ++i) many += "[[procedure]]\nid = \"" + std::to_string(i) + "\"" + step;
  expectRefused([&] { withTitle(many); }, {"more than 32 steps"});
}

TEST(SceneReader, RefusesABombOfText) {
  expectRefused([] { parse(std::string((1 << 20) + 1, '#')); }, {"test.toml: larger than"});
  expectRefused([] { withTitle("a = " + std::string(100000, '[')); }, {"test.toml:2: "});
}

class BadOverrides : public ::testing::TestWithParam<BadText> {};

TEST_P(BadOverrides, AreRefusedAsTheUserWroteThem) {
  expectRefused([] { withTitle("", {GetParam().text}); }, {"--set " + std::string(GetParam().text) + ": ", GetParam().message});
}

INSTANTIATE_TEST_SUITE_P(All, BadOverrides,
                         ::testing::Values(BadText{"tissue.nope=1", "unknown key"}, BadText{"tisue.density=1", "unknown table [tisue]"},
                                           BadText{"tissue.density", "must be key=value"}, BadText{"=1", "must be key=value"},
                                           BadText{"tissue.density=", "is not a value"}, BadText{"tissue.density=1 2", "is not a value"},
                                           BadText{"tissue.density=1#", "is not a value"}, BadText{"tissue.density=1,5", "is not a value"},
                                           BadText{"tissue.density=5", "must be 100 to 20000 kg/m^3, is 5"},
                                           BadText{"tissue.solver=magic", "is not one of projective"},
                                           BadText{"thread.nodes=10.5", "must be an integer"},
                                           BadText{"anvil.from=0", "must be a list of three numbers"},
                                           BadText{"anatomy.mesh=/nowhere/colon.obj", "no file '/nowhere/colon.obj'"},
                                           BadText{"procedure=1", "unknown key"}));

TEST(SceneReader, NamesTheKnownScenesWhenOneIsUnknown) {
  expectRefused([] { scenes::readScene("appendectomy", {}); }, {"unknown scene 'appendectomy'", "purse_string"});
  expectRefused([] { scenes::readScene("", {}); }, {"unknown scene ''"});
}

}  // namespace
}  // namespace halsted
