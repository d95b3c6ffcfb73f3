#pragma once
/// A sewing script run to its end, and what every one of them must hold.
#include <algorithm>
#include <fstream>
#include <map>

#include "tests/app/scenario_for_tests.h"
#include "tests/support/process.h"

namespace halsted::app {

/// A scene's own script, at these places only and as often asked for, or at its own where none is named; its path.
inline std::string scriptAt(const testing::TemporaryFolder& folder, const std::string& scene, const std::string& places) {   // [deg]
  std::ifstream file(testing::sourceFolder() + "/scenes/" + scene + "/expert.toml");
  std::string line, text;
  while (std::getline(file, line)) text += !places.empty() && line.rfind("stitch_at_deg", 0) == 0 ? "stitch_at_deg = [" + places + "]\n" : line + "\n";
  const std::string path = folder.file("expert.toml");
  std::ofstream(path) << text;
  return path;
}

inline double hardestHole(const State& s) {    // [N]
  double most = 0.0;                           // [N]
  for (int i = 0; i < s.strand.holeCount; ++i) most = std::max(most, s.strand.holes[i].force.norm());
  return most;
}

/// Completed without a failure, a fault or a tear, the needle cut off and nothing else broken. Returns the report's metrics by their names.
inline std::map<std::string, double> expectSewn(const Lockstep& run, const std::string& name) {   // by the name's unit
  EXPECT_EQ(run.failure(), "");
  EXPECT_TRUE(run.lostStitches().empty()) << run.lostStitches().front();
  const RunSummary summary = summariseRun(name, "t", run.scenario().model, run.state(), run.stepTimes(), 1.0);
  EXPECT_TRUE(summary.completed);
  for (const ProcedureLine& line : summary.procedure) EXPECT_EQ(line.faults, 0) << line.id;
  std::map<std::string, double> m(summary.metrics.begin(), summary.metrics.end());
  EXPECT_EQ(m["crossings"], 1.0);
  EXPECT_EQ(m["tears"], 0.0);
  EXPECT_EQ(run.state().knot.cuts, 1);
  EXPECT_EQ(run.state().knot.breaks, 1);       // where it was cut, and nowhere else
  return m;
}

/// With one beginner's knot that did not slip.
inline std::map<std::string, double> expectTied(const Lockstep& run, const std::string& name) {   // by the name's unit
  auto m = expectSewn(run, name);
  EXPECT_EQ(m["assisted_knots"], 1.0);
  EXPECT_EQ(run.state().assist->slipped, 0.0);
  return m;
}

}  // namespace halsted::app
