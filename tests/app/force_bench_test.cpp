/// The law of energy in a real scene: both hands stir the purse-string scene at random for a minute, and no device gives its hand
/// more than 1e-4 J that the loop made up (devices.md 2). The same function as `halsted devices --bench`,
/// which takes a second seed too.
#include <gtest/gtest.h>

#include <cstdio>

#include "app/commands/devices_bench.h"

namespace halsted::app {
namespace {

class StirredScene : public ::testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(Seed, StirredScene, ::testing::Values(1));

TEST_P(StirredScene, NoDeviceIsGivenEnergyThatNobodyPutIn) {
  const Scenario scenario = scenarioFromScene("purse_string", {}, {});
  for (const haptics::bench::Measurement& m : measureSceneEnergy(scenario, 60.0, GetParam(), {})) {
    std::printf("%s\n", text(m).c_str());
    EXPECT_TRUE(m.met()) << text(m);
  }
}

}  // namespace
}  // namespace halsted::app
