/// The preset `paper`: what its frame is measured on must be a bowel that stands, not one that has fallen in a heap.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

class PaperPreset : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, PaperPreset, ::testing::Values("purse_string", "stay", "connell", "lembert"), [](const auto& p) { return std::string(p.param); });

constexpr double kFallTime = 0.6;                  // [s]

/// How far the tissue has gone by then, in the mean: a hand may have taken an edge.  [m]
double moved(Lockstep& run) {
  const auto& x = run.state().tissue.position;
  const auto rest = x;                         // [m]
  while (run.time() < kFallTime && run.advance()) {}
  double sum = 0.0;                            // [m]
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - rest[i]).norm();
  return sum / static_cast<double>(x.size());
}

/// Shape matching with the paper's numbers has no material: hung from one end, the bowel falls, into itself.
TEST_P(PaperPreset, StandsWhereItWasBuilt) {
  const std::string script = testing::sourceFolder() + "/scenes/" + GetParam() + "/expert.toml";
  const Scenario bedded = scenarioFromFile(script, {"preset=paper"}), hung = scenarioFromFile(script, {"preset=paper", "tissue.bedded=false"});
  Lockstep stands(bedded), falls(hung);
  const double held = moved(stands), fallen = moved(falls);
  std::printf("after %.1f s: %.1f mm in the mean; hung from one end %.1f mm\n", kFallTime, 1e3 * held, 1e3 * fallen);
  EXPECT_LT(held, 2e-3);
  EXPECT_EQ(stands.state().tissue.pairCount, 0);   // nor does any of it lie on the rest
}

}  // namespace
}  // namespace halsted::app
