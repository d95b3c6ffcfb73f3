/// What is said to the assistant is part of the record: a thread or an instrument asked for comes, a clamp offered is taken, at the same step of the replay.
#include <fstream>

#include "app/session/session_writer.h"
#include "app/verifier.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::TemporaryFolder;

/// A script that ends in a hold, run and recorded, then replayed from the record.
struct Asked {
  TemporaryFolder folder;
  Scenario scenario;
  Lockstep run;
  int said = 0;                                // commands in the record

  Asked(const std::string& action, const std::vector<std::string>& settings) : Asked("lembert", "do = \"" + action + "\"\n", settings) {}
  Asked(const std::string& scene, const std::string& actions, const std::vector<std::string>& settings)
      : scenario(scenarioFromFile(script(scene, actions), settings)), run(scenario) {
    SessionWriter writer(session(), sessionHeader(scenario, ""));
    while (run.advance()) {
      writer.addStep(run.input(), hash(run.state()));
      said += run.input().command.kind != Command::Kind::kNone;
    }
    writer.close();
  }
  std::string session() const { return folder.file("a.halsted"); }
  std::string script(const std::string& scene, const std::string& actions) const {
    const std::string path = folder.file("expert.toml");
    std::ofstream(path) << "scene = \"" << scene << "\"\n[[action]]\n" << actions << "[[action]]\ndo = \"hold\"\nlimit_s = 0.1\n";
    return path;
  }
  /// Empty when every step of the replay has the recorded state.
  std::string replayed() const {
    const Scenario again = scenarioFromFile(session(), {});
    Lockstep replay(again);
    Verifier verifier;
    while (replay.advance() && verifier.check(replay)) {}
    EXPECT_EQ(verifier.stepsChecked(), run.state().step);
    return verifier.message();
  }
};

/// An unused thread is put away and a new one taken.
TEST(FreshThreadCommand, IsRecordedAndReplays) {
  const Asked asked("fresh_thread", {});
  EXPECT_EQ(asked.run.failure(), "");
  EXPECT_EQ(asked.said, 1);
  EXPECT_EQ(asked.run.state().supply->handed, 1);
  EXPECT_EQ(asked.run.state().stitches->count, 0);               // there was no stitch
  EXPECT_TRUE(asked.run.state().tools[kRight].holdsNeedle);
  EXPECT_EQ(asked.replayed(), "");
}

TEST(ChangeToolsCommand, IsRecordedAndReplays) {
  const Asked asked("change_tools", {"tool.left.second.kind=forceps", "tool.left.second.jaw_length=20e-3"});
  EXPECT_EQ(asked.run.failure(), "");
  EXPECT_EQ(asked.said, 1);                                      // the right hand has no other instrument
  EXPECT_EQ(asked.run.state().instruments->second[kLeft], 1);
  EXPECT_EQ(asked.run.state().instruments->second[kRight], 0);
  EXPECT_EQ(asked.replayed(), "");
}

TEST(ChangeToolsCommand, ASceneWithoutASecondInstrumentSaysSo) {
  const Asked asked("change_tools", {});
  EXPECT_NE(asked.run.failure().find("tool.left.second"), std::string::npos);
  EXPECT_EQ(asked.run.failure().rfind(asked.folder.file("expert.toml") + ":2: change_tools: ", 0), 0u) << asked.run.failure();
}

const char* const kClampAndOffer = "do = \"hold_fold\"\nangle_deg = 90\ndepth_mm = 5\ntension_n = 1.0\n[[action]]\ndo = \"hand_over\"\n";

TEST(HandOverCommand, IsRecordedAndReplays) {
  const Asked asked("altemeier", kClampAndOffer, {});
  EXPECT_EQ(asked.run.failure(), "");
  EXPECT_EQ(asked.said, 1);
  EXPECT_EQ(asked.run.state().clamps->count, 1);
  EXPECT_EQ(asked.run.state().clamps->left, 2);
  EXPECT_EQ(asked.run.state().tools[kLeft].grasp.count, 0);
  EXPECT_EQ(asked.replayed(), "");
}

TEST(HandOverCommand, ASceneWithoutOtherClampsSaysSo) {
  const Asked asked("altemeier", kClampAndOffer, {"assistant.clamps=0"});
  EXPECT_NE(asked.run.failure().find("assistant.clamps"), std::string::npos);
}

}  // namespace
}  // namespace halsted::app
