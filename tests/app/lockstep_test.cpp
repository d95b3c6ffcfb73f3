/// Determinism of the whole loop: devices, physics, scripted surgeon (DESIGN 7).
#include "app/lockstep.h"

#include <gtest/gtest.h>

#include <memory>

#include "tests/app/scenario_for_tests.h"

namespace halsted::app {
namespace {

constexpr int kSteps = 200;

std::uint64_t hashAfter(Lockstep& run, int steps) {
  for (int i = 0; i < steps; ++i)
    if (!run.advance()) break;
  return hash(run.state());
}

TEST(LockstepDeterminism, SameScriptGivesTheSameBits) {
  const Scenario first = expertScenario(), second = expertScenario();
  Lockstep a(first), b(second);
  for (int i = 0; i < kSteps; ++i) {
    ASSERT_TRUE(a.advance());
    ASSERT_TRUE(b.advance());
    ASSERT_EQ(hash(a.state()), hash(b.state())) << diff(a.state(), b.state());
  }
}

/// Blocks of odd sizes between two runs: nothing may depend on where the heap puts things.
TEST(LockstepDeterminism, HeapLayoutDoesNotMatter) {
  const Scenario first = expertScenario();
  Lockstep a(first);
  const std::uint64_t expected = hashAfter(a, kSteps);
  std::vector<std::unique_ptr<char[]>> blocks;
  for (int i = 0; i < 300; ++i) blocks.push_back(std::make_unique<char[]>(static_cast<std::size_t>(37 + 91 * i)));
  const Scenario second = expertScenario();
  Lockstep b(second);
  EXPECT_EQ(hashAfter(b, kSteps), expected);
}

/// The physics alone, fed with the same inputs from a restored state, goes on as if nothing had happened.
TEST(LockstepDeterminism, RestoredStateContinuesIdentically) {
  const Scenario scenario = expertScenario();
  Lockstep run(scenario);
  hashAfter(run, kSteps / 2);
  const std::vector<std::uint8_t> saved = save(run.state());
  State restored = initialState(scenario.model, scenario.start);
  std::string error;
  ASSERT_TRUE(load(saved, restored, error)) << error;
  StepOutput output;
  for (int i = 0; i < kSteps / 2; ++i) {
    ASSERT_TRUE(run.advance());
    step(scenario.model, run.input(), restored, output);
    ASSERT_EQ(hash(restored), hash(run.state())) << "step " << run.state().step << ": " << diff(restored, run.state());
  }
}

TEST(LockstepDeterminism, AnotherParameterGivesOtherBits) {
  const Scenario soft = expertScenario({"tissue.youngs_modulus=60e3"}), stiff = expertScenario();
  Lockstep a(soft), b(stiff);
  EXPECT_NE(hashAfter(a, 50), hashAfter(b, 50));
}

TEST(Lockstep, TicksOncePerMillisecondWhateverTheStep) {
  for (const auto& [dt, steps, ticks] : {std::tuple{"1e-3", 20, 20}, std::tuple{"0.5e-3", 20, 10}, std::tuple{"2e-3", 20, 40}}) {
    const Scenario scenario = expertScenario({std::string("sim.dt=") + dt});
    Lockstep run(scenario);
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(run.advance());
    EXPECT_EQ(run.input().tools[kLeft].tick + 1, static_cast<std::uint64_t>(ticks)) << dt;
  }
}

}  // namespace
}  // namespace halsted::app
