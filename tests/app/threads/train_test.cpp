/// The whole program in real time with virtual devices: it starts, runs, ends cleanly, and loses nothing when it is killed.
/// No test here asserts how fast the machine is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/session/session_reader.h"
#include "haptics/virtual_device.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/app/threads/small_options.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::ProcessResult;
using halsted::testing::run;
using halsted::testing::RunningProcess;
using halsted::testing::TemporaryFolder;
using ::testing::HasSubstr;

std::vector<std::string> trainCommand(const std::vector<std::string>& more) {
  std::vector<std::string> command{HALSTED_BINARY, "train", "purse_string", "--headless", "--size", "320x180"};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

TEST(Train, HeadlessRunsReportsAndReplays) {
  const TemporaryFolder folder;
  const std::string script = "script:" + expertPath();
  const ProcessResult result =
      run(trainCommand({"--seconds", "2", "--json", "--left", script, "--right", script, "--record", folder.file("a.halsted")}));
  ASSERT_EQ(result.exitCode, 0) << result.errors;
  const auto json = nlohmann::json::parse(result.output);
  for (const char* key : {"scene", "dt_s", "steps", "completed", "procedure", "faults", "metrics", "state_hash", "timing"}) EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"rate_hz", "lateness_us", "bare_lateness_us", "max_force_n", "stale_ticks"}) EXPECT_TRUE(json["haptic"].contains(key)) << key;
  for (const char* key : {"rate_hz", "late_steps"}) EXPECT_TRUE(json["physics"].contains(key)) << key;
  for (const char* key : {"fps", "start_up_s", "frame_ms"}) EXPECT_TRUE(json["render"].contains(key)) << key;
  EXPECT_GT(json["steps"].get<int>(), 0);
  EXPECT_GT(json["haptic"]["rate_hz"].get<double>(), 0.0);
  EXPECT_LE(json["haptic"]["max_force_n"].get<double>(), 3.3);
  EXPECT_EQ(json["recorder"]["steps"], json["steps"]);

  const ProcessResult replay = run({HALSTED_BINARY, "replay", folder.file("a.halsted"), "--verify", "--json"});
  EXPECT_EQ(replay.exitCode, 0) << replay.errors;
  EXPECT_EQ(nlohmann::json::parse(replay.output)["state_hash"], json["state_hash"]);
}

TEST(Train, InterruptEndsCleanlyWithNothingLost) {
  const TemporaryFolder folder;
  RunningProcess process(trainCommand({"--record", folder.file("a.halsted")}));
  std::this_thread::sleep_for(std::chrono::seconds(4));
  process.send(SIGINT);
  EXPECT_EQ(process.wait(), 0);
  const SessionReader reader(folder.file("a.halsted"));
  EXPECT_TRUE(reader.closedProperly());
  EXPECT_GT(reader.steps(), 0u);
}

/// At the moment of death the file on disk must open and replay; how much of the last second it holds is at most one commit less.
TEST(Train, KilledSessionOpensAndReplaysToThatPoint) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  RunningProcess process(trainCommand({"--record", path}));
  std::uint64_t before = 0;
  for (int i = 0; i < 200 && before < 500 && !process.ended(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    if (!std::filesystem::exists(path)) continue;
    try {
      before = SessionReader(path).steps();
    } catch (const scenes::InputError&) {
      continue;                                // its header is still being written
    }
  }
  ASSERT_GE(before, 500u);
  process.send(SIGKILL);
  EXPECT_EQ(process.wait(), 128 + SIGKILL);
  const SessionReader reader(path);
  EXPECT_FALSE(reader.closedProperly());
  EXPECT_GE(reader.steps(), before);
  const ProcessResult replay = run({HALSTED_BINARY, "replay", path, "--verify"});
  EXPECT_EQ(replay.exitCode, 0) << replay.errors;
  EXPECT_THAT(replay.errors, HasSubstr("without a proper close"));
}

TEST(TrainThreads, AVanishedDeviceEndsTheSessionAndKeepsTheRecording) {
  const TemporaryFolder folder;
  const Scenario scenario = scenarioFromScene("purse_string", {}, {});
  LiveSession session(scenario, smallOptions(folder.file("a.halsted")));
  static_cast<haptics::VirtualDevice&>(*session.hands()[kLeft].device).setConnected(false);
  session.start();
  for (int i = 0; i < 200 && session.running(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(session.running());
  const LiveOutcome& outcome = session.stop();
  EXPECT_THAT(outcome.fault, HasSubstr("left device (virtual): gone"));
  const SessionReader reader(folder.file("a.halsted"));
  EXPECT_TRUE(reader.closedProperly());
}

TEST(TrainThreads, EveryPhysicsStepIsRecorded) {
  const TemporaryFolder folder;
  const Scenario scenario = scenarioFromScene("purse_string", {}, {});
  LiveSession session(scenario, smallOptions(folder.file("a.halsted")));
  session.start();
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  const LiveOutcome& outcome = session.stop();
  EXPECT_EQ(outcome.fault, "");
  EXPECT_EQ(outcome.recorder.dropped, 0u);
  EXPECT_EQ(outcome.recorder.stepsRecorded, outcome.physics.steps);
  EXPECT_EQ(SessionReader(folder.file("a.halsted")).steps(), session.state().step);
}

/// The servo loop sleeps in its own wait and nowhere else, and once warm touches no new page.
TEST(TrainThreads, HapticThreadGivesUpTheProcessorOnlyToWait) {
  const Scenario scenario = scenarioFromScene("purse_string", {}, {});
  LiveSession session(scenario, smallOptions(""));
  session.start();
  std::this_thread::sleep_for(std::chrono::seconds(1));
  const LiveOutcome& outcome = session.stop();
  ASSERT_GT(outcome.haptic.ticks, 0u);
  EXPECT_LE(static_cast<std::uint64_t>(outcome.haptic.usage.voluntarySwitches), outcome.haptic.ticks + 2);
#ifndef HALSTED_SANITIZED
  EXPECT_LE(outcome.haptic.usage.pageFaults, 40);   // the first turn of the loop and of its rings
#endif
}

}  // namespace
}  // namespace halsted::app
