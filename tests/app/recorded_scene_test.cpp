/// A session file is all that its replay needs; what was set for the recording holds, and another anatomy is built or refused, never taken
/// for the recorded one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "app/session/database.h"
#include "app/session/session_writer.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::TemporaryFolder;
using halsted::testing::writeText;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kFewSteps = 5;

/// Records a few steps; returns the hash of the last state.
std::uint64_t record(const std::string& path, const Scenario& scenario, const std::string& trainee = "") {
  SessionWriter writer(path, sessionHeader(scenario, trainee));
  Lockstep run(scenario);
  for (int i = 0; i < kFewSteps && run.advance(); ++i) writer.addStep(run.input(), hash(run.state()));
  writer.close();
  return hash(run.state());
}

std::uint64_t replay(const Scenario& scenario) {
  Lockstep run(scenario);
  while (run.advance()) {}
  return hash(run.state());
}

std::string refusal(const std::string& path, const std::vector<std::string>& overrides) {
  try {
    scenarioFromFile(path, overrides);
  } catch (const scenes::InputError& error) {
    return error.what();
  }
  return "accepted";
}

void alter(const std::string& path, const std::string& sql) { Database(path, Database::Mode::kRead).execute(sql); }

/// A round tube as a surface file, open at both ends. [mm]
std::string tubeSurface() {
  constexpr int kAround = 48, kAlong = 40;     // [1]
  std::string text;
  for (int row = 0; row <= kAlong; ++row)
    for (int i = 0; i < kAround; ++i) {
      const double angle = 2.0 * 3.14159265358979323846 * i / kAround;   // [rad]
      text += "v " + number("%.9g", 18.0 * std::cos(angle)) + " " + number("%.9g", 18.0 * std::sin(angle)) + " " + number("%.9g", 3.0 * row) + "\n";
    }
  const auto at = [](int row, int i) { return std::to_string(row * kAround + i % kAround + 1); };
  for (int row = 0; row < kAlong; ++row)
    for (int i = 0; i < kAround; ++i) {
      text += "f " + at(row, i) + " " + at(row, i + 1) + " " + at(row + 1, i + 1) + "\n";
      text += "f " + at(row, i) + " " + at(row + 1, i + 1) + " " + at(row + 1, i) + "\n";
    }
  return text;
}

/// A scene folder of the user's own whose wall comes from a mesh beside its scene.toml.
std::string meshScene(const TemporaryFolder& folder) {
  const std::string place = folder.file("mine");
  std::filesystem::create_directories(place);
  writeText(place + "/tube.obj", tubeSurface());
  writeText(place + "/scene.toml", "title = \"Mine\"\n[anatomy]\nmesh = \"tube.obj\"\nscale = 1e-3\nsegment = \"0.2\"\nwall = 2e-3\n"
                                   "[tool.left]\nkind = \"forceps\"\n[tool.right]\nkind = \"needle_driver\"\n[tissue]\nmaterial = \"colon_handling\"\n");
  return place;
}

TEST(RecordedScene, ReplaysWithoutItsMeshItsFolderAndItsMaterial) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted"), place = meshScene(folder);
  const std::uint64_t expected = record(path, scenarioFromScene(place, {}, {}));
  std::filesystem::remove_all(place);
  alter(path, "UPDATE meta SET value=replace(value, 'colon_handling', 'none_of_today') WHERE key='scene_text'");
  EXPECT_EQ(replay(scenarioFromFile(path, {})), expected);
}

/// The wall of this mesh is not in the file as a surface, so no other can be built from it.
TEST(RecordedScene, AnotherAnatomyOfAMeshNeedsTheMesh) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted"), place = meshScene(folder), mesh = "anatomy.mesh=" + place + "/tube.obj";
  record(path, scenarioFromScene(place, {}, {}));
  EXPECT_THAT(refusal(path, {"anatomy.wall=2.5e-3"}), AllOf(HasSubstr(path), HasSubstr("anatomy.mesh"), Not(HasSubstr("\n"))));
  const Scenario other = scenarioFromFile(path, {mesh, "anatomy.wall=2.5e-3"});
  EXPECT_NE(other.anatomy.mesh.vertices, SessionReader(path).header().anatomy.mesh.vertices);
}

TEST(RecordedScene, KeepsTheTextsThatWereSet) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  const Scenario given = scenarioFromScene("connell", {"anatomy.layout=one_end", "title=Of one end"}, {});
  record(path, given);
  const Scenario same = scenarioFromFile(path, {});
  EXPECT_EQ(same.scene.params.anatomy.layout, "one_end");
  EXPECT_EQ(same.scene.title, "Of one end");
  const Scenario other = scenarioFromFile(path, {"anatomy.wall=2.2e-3"});
  EXPECT_EQ(other.anatomy.mesh.vertices.size(), given.anatomy.mesh.vertices.size());   // one end, as recorded
  EXPECT_NE(other.anatomy.mesh.vertices, given.anatomy.mesh.vertices);
}

/// A preset may set the anatomy, too; what leaves it as it was builds nothing.
TEST(RecordedScene, IsBuiltAnewExactlyWhereItsAnatomyIsAnother) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  const Scenario given = scenarioFromScene("purse_string", {}, {});
  record(path, given);
  EXPECT_EQ(scenarioFromFile(path, {"anatomy.wall=2e-3", "preset=default"}).anatomy.mesh.vertices, given.anatomy.mesh.vertices);
  alter(path, "UPDATE meta SET value=value||char(10)||'[preset]'||char(10)||'thin = [\"anatomy.wall=1.5e-3\"]' WHERE key='scene_text' AND value NOT LIKE '%[preset]%'");
  alter(path, "UPDATE meta SET value=replace(value, '[preset]', '[preset]'||char(10)||'thin = [\"anatomy.wall=1.5e-3\"]') WHERE key='scene_text' AND value NOT LIKE '%thin = %'");
  const Scenario thin = scenarioFromFile(path, {"preset=thin"});
  EXPECT_DOUBLE_EQ(thin.scene.params.anatomy.wall, 1.5e-3);
  EXPECT_NE(thin.anatomy.mesh.vertices, given.anatomy.mesh.vertices);
}

/// A file of an earlier Halsted has no texts among its parameters; where it was recorded with settings they may matter.
TEST(RecordedScene, AnOldOneIsNotBuiltAnewFromHalfOfItsSettings) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  const std::uint64_t expected = record(path, scenarioFromScene("connell", {"anatomy.layout=one_end"}, {}));
  alter(path, "DELETE FROM parameter WHERE key IN ('title','technique','train_preset','anatomy.layout','anatomy.segment','anatomy.body','anatomy.point')");
  EXPECT_EQ(replay(scenarioFromFile(path, {})), expected);
  EXPECT_THAT(refusal(path, {"anatomy.wall=2.2e-3"}), AllOf(HasSubstr(path), HasSubstr("anatomy")));
}

TEST(RecordedScene, NamesARowThatIsNoParameter) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  record(path, scenarioFromScene("purse_string", {}, {}));
  alter(path, "INSERT INTO parameter VALUES('foo.bar','1')");
  EXPECT_THAT(refusal(path, {}), AllOf(HasSubstr(path), HasSubstr("foo.bar"), Not(HasSubstr("--set"))));
  EXPECT_THAT(refusal(path, {"anatomy.nothing=1"}), Not(HasSubstr("accepted")));
}

TEST(RecordedScene, RecordedAgainKeepsItsTraineeAndItsScript) {
  const TemporaryFolder folder;
  const std::string first = folder.file("a.halsted"), second = folder.file("b.halsted");
  record(first, expertScenario({"tissue.mass_damping=6.5"}), "Wm. Halsted");
  record(second, scenarioFromFile(first, {"sim.seed=3"}));
  const SessionReader a(first), b(second);
  EXPECT_FALSE(a.header().expertText.empty());
  EXPECT_EQ(b.header().expertText, a.header().expertText);
  EXPECT_EQ(b.header().trainee, "Wm. Halsted");
  EXPECT_EQ(b.header().overrides, (std::vector<std::string>{"tissue.mass_damping=6.5", "sim.seed=3"}));
}

}  // namespace
}  // namespace halsted::app
