/// A recording replays to the bit, and a tampered one is found out (issue: recording and replay).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/playback.h"
#include "app/session/database.h"
#include "app/session/session_writer.h"
#include "app/session/step_codec.h"
#include "app/verifier.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Records `steps` steps of the expert; a whole state every `stateEvery` steps.
void recordSteps(const std::string& path, int steps, int stateEvery) {
  const Scenario scenario = expertScenario({"tissue.mass_damping=6.5"});
  SessionWriter writer(path, sessionHeader(scenario, ""));
  Lockstep run(scenario);
  for (int i = 1; i <= steps && run.advance(); ++i) {
    writer.addStep(run.input(), hash(run.state()));
    if (i % stateEvery == 0) writer.addState(run.state().step, save(run.state()));
  }
  writer.close();
}

/// Moves the right tool of one recorded step by one millimetre.
void tamper(const std::string& path, int step) {
  Database database(path, Database::Mode::kRead);
  Blob inputs;
  {
    Statement row = database.prepare("SELECT inputs FROM chunk WHERE first_step=0");
    ASSERT_TRUE(row.step());
    inputs = row.blob(0);
  }
  const auto at = inputs.begin() + static_cast<std::ptrdiff_t>(step * static_cast<int>(kStepInputBytes));
  StepInput input = decodeStepInput(std::span(&*at, kStepInputBytes));
  input.tools[kRight].pose.position.x() += 1e-3;
  Blob changed;
  appendStepInput(input, changed);
  std::copy(changed.begin(), changed.end(), at);
  database.prepare("UPDATE chunk SET inputs=? WHERE first_step=0").bind(1, std::span<const std::uint8_t>(inputs)).run();
}

std::string verifyAll(const std::string& path, std::uint64_t& checked) {
  const Scenario scenario = scenarioFromFile(path, {});
  Lockstep run(scenario);
  Verifier verifier;
  while (run.advance() && verifier.check(run)) {}
  checked = verifier.stepsChecked();
  return verifier.message();
}

TEST(Verify, ARecordingReplaysToTheBit) {
  const TemporaryFolder folder;
  recordSteps(folder.file("a.halsted"), 300, 100);
  std::uint64_t checked = 0;
  EXPECT_EQ(verifyAll(folder.file("a.halsted"), checked), "");
  EXPECT_EQ(checked, 300u);
}

/// A session of so many steps with a whole state every so many, about to be replayed.
struct Recorded {
  TemporaryFolder folder;
  Scenario scenario;
  Lockstep run;
  Recorded(int steps, int stateEvery) : scenario(recorded(steps, stateEvery)), run(scenario) {}

 private:
  Scenario recorded(int steps, int stateEvery) {
    recordSteps(folder.file("a.halsted"), steps, stateEvery);
    return scenarioFromFile(folder.file("a.halsted"), {});
  }
};

TEST(Verify, AReplayCanBeginAtAStoredState) {
  Recorded session(300, 100);
  session.run.seek(299);
  EXPECT_EQ(session.run.state().step, 200u);
  Verifier verifier;
  while (session.run.advance() && verifier.check(session.run)) {}
  EXPECT_EQ(verifier.message(), "");
  EXPECT_EQ(verifier.stepsChecked(), 100u);
}

TEST(Verify, BeforeTheFirstStoredStateAReplayBeginsAtTheStart) {
  Recorded session(30, 20);
  session.run.seek(19);
  EXPECT_EQ(session.run.state().step, 0u);
}

/// The state in the file is of another step than it says, as one from another session would be.
TEST(Verify, AStoredStateOfAnotherStepIsRefused) {
  Recorded session(30, 20);
  Database(session.folder.file("a.halsted"), Database::Mode::kRead).prepare("UPDATE state SET step=10").run();
  EXPECT_THROW(session.run.seek(25), scenes::InputError);
}

/// A stored state that is not the recorded one would be stepped from with indices that lead anywhere.
TEST(Verify, AStoredStateThatIsNotTheRecordedOneIsRefused) {
  Recorded session(30, 20);
  State other = session.run.state();
  other.step = 20;
  Database(session.folder.file("a.halsted"), Database::Mode::kRead)
      .prepare("UPDATE state SET content=?").bind(1, std::span<const std::uint8_t>(save(other))).run();
  try {
    session.run.seek(25);
    FAIL() << "accepted";
  } catch (const scenes::InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("a.halsted: state after step 20: "), HasSubstr("recorded hash")));
  }
}

TEST(Verify, NothingToVerifyIsNoSuccess) {
  const TemporaryFolder folder;
  recordSteps(folder.file("a.halsted"), 0, 100);
  PlayOptions options;
  options.file = folder.file("a.halsted");
  options.verify = true;
  EXPECT_EQ(play(options, nullptr), 1);
}

TEST(Verify, AChangedSampleIsFoundAtItsStepAndByField) {
  const TemporaryFolder folder;
  recordSteps(folder.file("a.halsted"), 300, 100);
  tamper(folder.file("a.halsted"), 142);
  std::uint64_t checked = 0;
  const std::string message = verifyAll(folder.file("a.halsted"), checked);
  EXPECT_THAT(message, HasSubstr("after step 143 differs"));
  EXPECT_THAT(message, HasSubstr("first differing field after step 200"));
  EXPECT_EQ(checked, 200u);
}

TEST(Verify, ARecordingKeepsItsParametersWhateverTheSceneFolderSays) {
  const TemporaryFolder folder;
  recordSteps(folder.file("a.halsted"), 5, 100);
  EXPECT_EQ(scenarioFromFile(folder.file("a.halsted"), {}).model.params.tissue.massDamping, 6.5);
  EXPECT_EQ(scenarioFromFile(folder.file("a.halsted"), {"tissue.mass_damping=9"}).model.params.tissue.massDamping, 9.0);
}

}  // namespace
}  // namespace halsted::app
