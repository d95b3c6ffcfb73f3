/// Two bowel ends, thread that can be knotted, and hands that do anything: the step stays finite and bounded. From the scene's start and
/// from the middle of its script, with thread in the walls.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <tuple>

#include "tests/app/scenario_for_tests.h"
#include "tests/sim/hand_noise.h"

namespace halsted::app {
namespace {

const Vec3 kSeam(0.0, 2e-3, 4e-3);             // [m] about which the hands move
constexpr int kAsk = 97;                       // steps: again and again a new thread is asked for, at bad moments mostly

StepInput handsAsTheyAre(const State& s) {
  StepInput input;
  for (int hand = 0; hand < kHands; ++hand) {
    input.tools[hand].pose = s.tools[hand].device;
    input.tools[hand].jaw = s.tools[hand].jaw;
  }
  return input;
}

double kineticEnergy(const Model& m, const State& s) {           // [J]
  double sum = 0.0;                            // [J]
  for (std::size_t i = 0; i < s.tissue.velocity.size(); ++i) sum += 0.5 * m.tissue.mass[i] * s.tissue.velocity[i].squaredNorm();
  for (std::size_t i = 0; i < s.strand.velocity.size(); ++i) sum += 0.5 * m.strand.mass[i] * s.strand.velocity[i].squaredNorm();
  return sum;
}

bool finite(const State& s) {
  for (const Vec3& p : s.tissue.position)
    if (!p.allFinite()) return false;
  for (const Vec3& p : s.strand.position)
    if (!p.allFinite()) return false;
  return s.strand.needle.position.allFinite() && s.tools[kLeft].force.allFinite() && s.tools[kRight].force.allFinite();
}

/// 2000 steps a case, or as many as HALSTED_ABUSE_STEPS says.
int abuseSteps() {
  const char* asked = std::getenv("HALSTED_ABUSE_STEPS");
  return asked ? std::max(1, std::atoi(asked)) : 2000;
}

using Case = std::tuple<const char*, double, std::uint64_t>;     // scene, [s] of its script before, seed
class WildHandsOnTwoEnds : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Scene, WildHandsOnTwoEnds,
                         ::testing::Combine(::testing::Values("stay", "connell", "lembert"), ::testing::Values(0.1, 9.0), ::testing::Values(1, 3)));

/// The hands move at 0.15 m/s in a box of 43 mm: its diagonal and the coupling allow 43 N.
TEST_P(WildHandsOnTwoEnds, StayFiniteAndNothingIsFlung) {
  const auto [name, script, seed] = GetParam();
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/" + name + "/expert.toml", {"thread.assist=knot"});
  Lockstep run(scenario);
  while (run.time() < script && run.advance()) {}
  State& s = run.state();
  HandNoise hands(seed, kSeam);
  StepInput input = handsAsTheyAre(s);
  StepOutput out;
  double most = 0.0, liveliest = 0.0;          // [N] [J]
  int broken = 0;                              // steps
  const int steps = abuseSteps();
  for (int k = 0; k < steps; ++k) {
    hands.move(input);
    input.command.kind = k % kAsk == 0 ? Command::Kind::kFreshThread : Command::Kind::kNone;
    step(scenario.model, input, s, out);
    broken += finite(s) ? 0 : 1;
    for (const ToolState& t : s.tools) most = std::max(most, t.force.norm());
    liveliest = std::max(liveliest, kineticEnergy(scenario.model, s));
  }
  double mass = 0.0;                           // [kg]
  for (double m : scenario.model.tissue.mass) mass += m;
  std::printf("%s from %.1f s, seed %d, %d steps: at most %.2f N, %.3f mJ of %.1f g, %d holes, %d tears, %d breaks, %d steps with a number that is none\n", name, script,
              static_cast<int>(seed), steps, most, 1e3 * liveliest, 1e3 * mass, s.strand.holeCount, s.metrics.tears, s.knot.breaks, broken);
  EXPECT_EQ(broken, 0);
  EXPECT_LT(most, 60.0);
  EXPECT_LT(liveliest, 0.5 * mass * 1.6 * 1.6);   // all of it at 1.6 m/s, ten times as fast as the hands: the law of RandomHands
}

}  // namespace
}  // namespace halsted::app
