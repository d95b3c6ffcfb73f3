#pragma once
/// The shipped scene and its script, as the tests run them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/lockstep.h"
#include "app/run_summary.h"
#include "app/scenario.h"
#include "tests/support/source_folder.h"

namespace halsted::app {

inline std::string expertPath() { return testing::sourceFolder() + "/scenes/purse_string/expert.toml"; }
inline Scenario expertScenario(const std::vector<std::string>& overrides = {}) { return scenarioFromFile(expertPath(), overrides); }

/// Runs a script to its end, `look` after every step; the procedure must be complete, without a fault.
template <class Look> RunSummary expectCompleted(const Scenario& scenario, const std::string& scene, Look look) {
  Lockstep run(scenario);
  while (run.advance()) look(run);
  EXPECT_EQ(run.failure(), "");
  const RunSummary summary = summariseRun(scene, "t", scenario.model, run.state(), run.stepTimes(), 1.0);
  EXPECT_TRUE(summary.completed);
  for (const ProcedureLine& line : summary.procedure) EXPECT_EQ(line.faults, 0) << line.id;
  return summary;
}

}  // namespace halsted::app
