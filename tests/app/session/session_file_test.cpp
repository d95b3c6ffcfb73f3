/// Laws of the session file: what goes in comes out to the bit; anything else is refused with one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <thread>

#include "app/session/database.h"
#include "app/session/session_reader.h"
#include "app/session/session_writer.h"
#include "app/session/step_codec.h"
#include "scenes/scene.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

SessionHeader exampleHeader() {
  SessionHeader header;
  header.scene = "purse_string";
  header.sceneText = "title = \"Naht\"\n";
  header.expertText = "# none\n";
  header.overrides = {"sim.seed=7", "thread.nodes=20"};
  header.parameters = {"sim.dt=0.001", "sim.seed=7"};
  header.trainee = "Wm. Halsted";
  header.devices = {"virtual", "mouse"};
  header.dt = 1e-3;
  header.seed = 7;
  header.start[kRight].position = Vec3(0.1, 0.2, 0.3);
  header.anatomy.mesh = blockMesh(2, 2, 1, Vec3(0.02, 0.02, 0.01));
  header.anatomy.mesh.uv.resize(header.anatomy.mesh.vertices.size(), Eigen::Vector2d::Zero());
  header.anatomy.mesh.triangleLayer.resize(header.anatomy.mesh.surface.size(), 0);
  return header;
}

/// Different in every field and every step.
StepInput exampleInput(int i) {
  StepInput input;
  for (int hand = 0; hand < kHands; ++hand) {
    ToolSample& tool = input.tools[hand];
    tool.tick = static_cast<std::uint64_t>(10 * i + hand);
    tool.pose.position = Vec3(0.001 * i, -0.002 * i, 1.0 / (i + 3.0 + hand));
    tool.pose.orientation = Quat(Eigen::AngleAxisd(0.01 * i + hand, Vec3(1, 2, 3).normalized()));
    tool.velocity = Vec3(0.1, -0.2, 0.3) * i;
    tool.jaw = 0.5 + 0.4 * hand;
    tool.presses = static_cast<std::uint32_t>(i / 3);
  }
  return input;
}

void writeSession(const std::string& path, int steps, bool close = true) {
  SessionWriter writer(path, exampleHeader());
  for (int i = 0; i < steps; ++i) writer.addStep(exampleInput(i), 1000u + static_cast<std::uint64_t>(i));
  writer.addEvent({3, EventKind::kBiteCompleted, kRight, 1, 0.006});
  writer.addState(5, {1, 2, 3});
  if (close) writer.close();
}

std::string fileRefusal(const std::string& path) {
  try {
    SessionReader reader(path);
    StepInput input;
    std::uint64_t hash = 0;
    while (reader.next(input, hash)) {}
  } catch (const scenes::InputError& error) {
    return error.what();
  }
  return "accepted";
}

void alterFile(const std::string& path, const std::string& sql) { Database(path, Database::Mode::kRead).execute(sql); }

TEST(StepCodec, KeepsEveryBit) {
  for (int i = 0; i < 50; ++i) {
    Blob bytes, again;
    appendStepInput(exampleInput(i), bytes);
    ASSERT_EQ(bytes.size(), kStepInputBytes);
    appendStepInput(decodeStepInput(bytes), again);
    EXPECT_EQ(bytes, again);
  }
}

TEST(StepCodec, NamesWhatNoDeviceCouldSend) {
  EXPECT_EQ(flaw(exampleInput(4)), "");
  StepInput input = exampleInput(4);
  input.tools[0].pose.position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(flaw(input), HasSubstr("not finite"));
  input = exampleInput(4);
  input.tools[1].pose.orientation.coeffs() *= 2.0;
  EXPECT_THAT(flaw(input), HasSubstr("rotation"));
  input = exampleInput(4);
  input.tools[1].jaw = 1.5;
  EXPECT_THAT(flaw(input), HasSubstr("jaw"));
}

TEST(SessionFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  writeSession(path, 100);
  SessionReader reader(path);
  const SessionHeader expected = exampleHeader();
  EXPECT_EQ(reader.header().scene, expected.scene);
  EXPECT_EQ(reader.header().sceneText, expected.sceneText);
  EXPECT_EQ(reader.header().expertText, expected.expertText);
  EXPECT_EQ(reader.header().overrides, expected.overrides);
  EXPECT_EQ(reader.header().parameters, expected.parameters);
  EXPECT_EQ(reader.header().trainee, expected.trainee);
  EXPECT_EQ(reader.header().devices, expected.devices);
  EXPECT_EQ(reader.header().dt, expected.dt);
  EXPECT_EQ(reader.header().start[kRight].position, expected.start[kRight].position);
  EXPECT_EQ(reader.header().anatomy.mesh.tets, expected.anatomy.mesh.tets);
  EXPECT_EQ(reader.header().anatomy.mesh.vertices, expected.anatomy.mesh.vertices);
  EXPECT_TRUE(reader.closedProperly());
  ASSERT_EQ(reader.steps(), 100u);
  StepInput input;
  std::uint64_t hash = 0;
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(reader.next(input, hash));
    Blob read, written;
    appendStepInput(input, read);
    appendStepInput(exampleInput(i), written);
    ASSERT_EQ(read, written) << "step " << i;
    EXPECT_EQ(hash, 1000u + static_cast<std::uint64_t>(i));
  }
  EXPECT_FALSE(reader.next(input, hash));
  EXPECT_EQ(reader.stateAfter(5), (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_FALSE(reader.stateAfter(6).has_value());
}

TEST(SessionFile, SaysWhenItWasNotClosed) {
  const TemporaryFolder folder;
  writeSession(folder.file("a.halsted"), 10, false);
  const SessionReader reader(folder.file("a.halsted"));
  EXPECT_FALSE(reader.closedProperly());
  EXPECT_EQ(reader.steps(), 10u);
}

/// Closed means that the last recorded state is the one that the session ended with.
TEST(SessionFile, IsNotClosedProperlyWhereItsLastStepsAreGone) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  for (const char* damage : {"DELETE FROM chunk WHERE first_step>0", "DELETE FROM chunk", "UPDATE meta SET value='0' WHERE key='state_hash'"}) {
    writeSession(path, 8000);
    alterFile(path, "INSERT INTO chunk SELECT 8000, 1, substr(inputs, 1, length(inputs)/count), X'2a00000000000000' FROM chunk WHERE first_step=0");
    alterFile(path, "UPDATE meta SET value='000000000000002a' WHERE key='state_hash'");
    ASSERT_TRUE(SessionReader(path).closedProperly());
    alterFile(path, damage);
    EXPECT_FALSE(SessionReader(path).closedProperly()) << damage;
  }
}

/// Somebody who reads the file for longer than SQLite waits costs no step.
TEST(SessionFile, WaitsForAReaderWithoutLosingAStep) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  SessionWriter writer(path, exampleHeader());
  int steps = 0;
  const auto add = [&] { for (int i = 0; i < 3; ++i, ++steps) writer.addStep(exampleInput(steps), 1000u + static_cast<std::uint64_t>(steps)); };
  add();
  writer.addHaptic({});
  {
    Database reader(path, Database::Mode::kRead);
    Statement look = reader.prepare("SELECT key FROM meta");
    ASSERT_TRUE(look.step());
    std::this_thread::sleep_for(std::chrono::milliseconds(260));
    EXPECT_NO_THROW(writer.commitWhenDue());   // five seconds later it has not been let in
    add();
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(260));
  writer.commitWhenDue();
  add();
  writer.close();
  SessionReader reader(path);
  EXPECT_TRUE(reader.closedProperly());
  EXPECT_EQ(reader.steps(), 9u);
  StepInput input;
  std::uint64_t hash = 0;
  for (std::uint64_t i = 0; i < 9; ++i) {
    ASSERT_TRUE(reader.next(input, hash));
    EXPECT_EQ(hash, 1000u + i);
  }
}

TEST(SessionFile, ReplacesAnEarlierSessionButNothingElse) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  writeSession(path, 10);
  writeSession(path, 20);
  EXPECT_EQ(SessionReader(path).steps(), 20u);
  const std::string letter = folder.file("letter.txt");
  halsted::testing::writeText(letter, "not yours");
  EXPECT_THROW(writeSession(letter, 1), scenes::InputError);
  EXPECT_EQ(halsted::testing::readText(letter), "not yours");
}

TEST(SessionFile, RefusesAMissingForeignOrEmptyFile) {
  const TemporaryFolder folder;
  EXPECT_THAT(fileRefusal(folder.file("none.halsted")), HasSubstr("no such file"));
  EXPECT_THAT(fileRefusal(folder.path()), HasSubstr("not a file"));
  halsted::testing::writeText(folder.file("text.halsted"), std::string(5000, 'x'));
  EXPECT_THAT(fileRefusal(folder.file("text.halsted")), HasSubstr("not a Halsted session"));
  halsted::testing::writeText(folder.file("empty.halsted"), "");
  EXPECT_THAT(fileRefusal(folder.file("empty.halsted")), HasSubstr("not a Halsted session"));
  Database(folder.file("other.halsted"), Database::Mode::kCreate).execute("CREATE TABLE t(x); INSERT INTO t VALUES(1)");
  EXPECT_THAT(fileRefusal(folder.file("other.halsted")), HasSubstr("not a Halsted session"));
}

TEST(SessionFile, RefusesANewerFormatByName) {
  const TemporaryFolder folder;
  writeSession(folder.file("a.halsted"), 3);
  alterFile(folder.file("a.halsted"), "PRAGMA user_version=99");
  EXPECT_THAT(fileRefusal(folder.file("a.halsted")), AllOf(HasSubstr("newer"), HasSubstr("99")));
}

TEST(SessionFile, RefusesEveryTruncation) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  writeSession(path, 500);
  const std::string whole = halsted::testing::readText(path);
  ASSERT_GT(whole.size(), 60'000u);
  for (std::size_t keep = 100; keep < whole.size(); keep += whole.size() / 23) {
    halsted::testing::writeText(path, whole.substr(0, keep));
    const std::string message = fileRefusal(path);
    EXPECT_THAT(message, AllOf(HasSubstr(path), Not(HasSubstr("\n")))) << keep << " of " << whole.size();
  }
}

/// A query of one's own under a table's name may never end.
TEST(SessionFile, RefusesViewsAndTriggers) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  for (const char* addition : {"CREATE VIEW more AS SELECT 1", "CREATE TRIGGER more AFTER INSERT ON meta BEGIN SELECT 1; END",
                               "DROP TABLE chunk; CREATE VIEW chunk AS WITH RECURSIVE n(first_step) AS (SELECT 0 UNION ALL SELECT first_step FROM n) "
                               "SELECT first_step, 1 AS count, '' AS inputs, '' AS hashes FROM n"}) {
    writeSession(path, 3);
    alterFile(path, addition);
    EXPECT_THAT(fileRefusal(path), HasSubstr("not a Halsted session: it holds more than tables")) << addition;
  }
}

TEST(SessionFile, RefusesDamagedTables) {
  const std::pair<const char*, const char*> damage[] = {
      {"DELETE FROM meta WHERE key='scene_text'", "meta.scene_text: missing"},
      {"UPDATE meta SET value='fast' WHERE key='dt_s'", "not a time step"},
      {"UPDATE meta SET value='-1' WHERE key='dt_s'", "not a time step"},
      {"DELETE FROM anatomy", "anatomy: missing"},
      {"UPDATE anatomy SET hash=hash+1", "anatomy: damaged"},
      {"DELETE FROM start WHERE hand=1", "a hand is missing"},
      {"UPDATE start SET pose=zeroblob(3)", "a pose of the wrong size"},
      {"UPDATE start SET pose=zeroblob(56)", "not a rotation"},
      {"UPDATE chunk SET first_step=first_step+1", "expected step 0"},
      {"UPDATE chunk SET count=count+1", "wrong size"},
      {"UPDATE chunk SET hashes=zeroblob(8)", "wrong size"},
      {"UPDATE chunk SET inputs=zeroblob(length(inputs))", "input of step 0"},
      {"UPDATE chunk SET count=-5", "impossible length"},
      {"DROP TABLE chunk", "cannot read the session"},
  };
  for (const auto& [sql, expected] : damage) {
    const TemporaryFolder folder;
    writeSession(folder.file("a.halsted"), 30);
    alterFile(folder.file("a.halsted"), sql);
    EXPECT_THAT(fileRefusal(folder.file("a.halsted")), HasSubstr(expected)) << sql;
  }
}

}  // namespace
}  // namespace halsted::app
