/// The recorder: what it cannot keep it says, and a recording with a gap is no finished session.
#include "app/threads/recorder_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/session_reader.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/app/threads/small_options.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::TemporaryFolder;
using ::testing::HasSubstr;

TEST(Recorder, AGapIsAFaultAndLeavesTheSessionOpen) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.halsted");
  {
    const Scenario scenario = scenarioFromScene("purse_string", {}, {});
    LiveSession session(scenario, smallOptions(path));
    StepRecord record;
    for (std::uint64_t step : {0u, 1u, 3u, 4u}) {
      record.step = step;
      for (ToolSample& tool : record.input.tools) tool.pose = scenario.start[0];
      session.links().steps.push(record);
    }
    session.links().stop.store(true);          // physics takes no step of its own
    session.start();
    EXPECT_THAT(session.stop().fault, HasSubstr("recording stops at step 2"));
  }
  const SessionReader reader(path);
  EXPECT_EQ(reader.steps(), 2u);
  EXPECT_FALSE(reader.closedProperly());
}

}  // namespace
}  // namespace halsted::app
