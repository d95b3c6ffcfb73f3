/// The preset `paper`: what its frame is measured on must be a bowel that stands, not one that has fallen in a heap.
#include <gtest/gtest.h>

#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

class PaperPreset : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, PaperPreset, ::testing::Values("purse_string", "stay", "connell", "lembert"), [](const auto& p) { return std::string(p.param); });

/// Shape matching with the paper's numbers has no material: hung from one end, the bowel fell by 70 to 110 mm, into itself, and shook at 0.6 to 2.5 m/s.
TEST_P(PaperPreset, StandsWhereItWasBuilt) {
  constexpr double kLook = 0.6;                // [s]
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/" + GetParam() + "/expert.toml", {"preset=paper"});
  Lockstep run(scenario);
  const auto& x = run.state().tissue.position;
  const auto rest = x;                         // [m]
  while (run.time() < kLook && run.advance()) {}
  double moved = 0.0;                          // [m] mean: a hand may have taken an edge by now
  for (std::size_t i = 0; i < x.size(); ++i) moved += (x[i] - rest[i]).norm() / static_cast<double>(x.size());
  EXPECT_LT(moved, 2e-3);
  EXPECT_EQ(run.state().tissue.pairCount, 0);  // nor does any of it lie on the rest
}

}  // namespace
}  // namespace halsted::app
