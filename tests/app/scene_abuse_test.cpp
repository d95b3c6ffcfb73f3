/// Every scene, and hands that do anything: the step stays finite and bounded, contacts create little energy, little of the thread sinks into tissue and
/// tools and none goes through a wall, and the same hands bring about the same bits again. From the scene's start and from the middle of its script, with thread
/// in the walls or a pen under current. 2000 steps a case, or as many as HALSTED_ABUSE_STEPS says.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "sim/fits.h"
#include "tests/app/abuse_watch.h"
#include "tests/app/energy_audit.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/sim/hand_noise.h"
#include "tests/sim/kinetic_energy.h"

namespace halsted::app {
namespace {

constexpr int kAsk = 97;                       // steps: again and again a new thread is asked for, at bad moments mostly
constexpr int kThreadLook = 64;                      // steps between two looks at the thread
constexpr int kAgain = 1000;                   // steps at the end that are done twice
constexpr int kStill = 1000;                   // steps of still hands after all

StepInput handsAsTheyAre(const State& s) {
  StepInput input;
  for (int hand = 0; hand < kHands; ++hand) {
    input.tools[hand].pose = s.tools[hand].device;
    input.tools[hand].jaw = s.tools[hand].jaw;
  }
  return input;
}

int abuseSteps() {
  const char* asked = std::getenv("HALSTED_ABUSE_STEPS");
  return asked ? std::max(1, std::atoi(asked)) : 2000;
}

struct Case {
  const char* scene;
  double script;                               // [s] of its script before
  std::uint64_t seed;
  Vec3 centre;                                 // [m] about which the hands move
  std::vector<std::string> overrides;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.scene << " from " << c.script << " s, seed " << c.seed; }

/// Knots as `train` offers them; in the purse-string thread does not meet itself, and a body that is needled has none.
std::vector<std::string> overridesOf(const std::string& scene) {
  if (scene == "purse_string" || scene == "acupuncture") return {};
  return {"thread.assist=knot"};
}

std::vector<Case> cases() {
  const Vec3 seam(0.0, 2e-3, 4e-3), rim(0.0, 12e-3, 4e-3), fold(0.0, 18e-3, 18e-3), skin(0.0, 0.0, 4e-3);   // [m]
  std::vector<Case> all;
  for (const auto& [scene, centre] : {std::pair{"purse_string", rim}, {"stay", seam}, {"connell", seam}, {"lembert", seam}, {"altemeier", fold}, {"acupuncture", skin}})
    for (const double script : {0.1, 9.0})     // [s]
      for (const std::uint64_t seed : {1, 3}) all.push_back({scene, script, seed, centre, overridesOf(scene)});
  return all;
}

class WildHands : public ::testing::TestWithParam<Case> {
 protected:
  void drive(int steps) {
    for (int k = 0; k < steps; ++k) {
      hands_.move(input_);
      input_.command.kind = ++asked_ % kAsk == 0 ? Command::Kind::kFreshThread : Command::Kind::kNone;
      advance();
    }
  }
  void hold(int steps) {
    input_.command.kind = Command::Kind::kNone;
    for (int k = 0; k < steps; ++k) advance();
  }
  void advance() {
    State& s = run_.state();
    audit_.before(s);
    step(scenario_.model, input_, s, out_);
    audit_.after(scenario_.model, s);
    for (const ToolState& t : s.tools) most_ = std::max(most_, t.force.norm());
    liveliest_ = std::max(liveliest_, kineticEnergy(scenario_.model, s));
    broken_ += finite(s) ? 0 : 1;
    if (s.step % kThreadLook != 0) return;
    const ThreadDepth d = threadDepth(scenario_.model, s);
    deepest_.tissue = std::max(deepest_.tissue, d.tissue);
    deepest_.tool = std::max(deepest_.tool, d.tool);
    deepest_.inTissue += d.inTissue;
    deepest_.inTool += d.inTool;
    deepest_.inPassed += d.inPassed;
    deepest_.through += d.through;
    deepest_.nodes += d.nodes;
  }
  /// The last steps once more, from a saved state.
  void expectTheSameAgain(int steps) {
    const std::vector<std::uint8_t> saved = save(run_.state());
    const HandNoise hands = hands_;
    const StepInput input = input_;
    const int asked = asked_;
    const EnergyAudit audit = audit_;
    drive(steps);
    const std::uint64_t once = hash(run_.state());
    std::string error;
    ASSERT_TRUE(load(saved, run_.state(), error)) << error;
    hands_ = hands;
    input_ = input;
    asked_ = asked;
    audit_ = audit;
    drive(steps);
    EXPECT_EQ(hash(run_.state()), once);
  }

  const Scenario scenario_ = scenarioFromFile(testing::sourceFolder() + "/scenes/" + GetParam().scene + "/expert.toml", GetParam().overrides);
  Lockstep run_{scenario_};
  HandNoise hands_{GetParam().seed, GetParam().centre};
  StepInput input_;
  StepOutput out_;
  double most_ = 0.0, liveliest_ = 0.0;        // [N] [J]
  int broken_ = 0, asked_ = 0;                 // steps
  ThreadDepth deepest_;
  EnergyAudit audit_;
};
INSTANTIATE_TEST_SUITE_P(Scene, WildHands, ::testing::ValuesIn(cases()),
                         [](const auto& c) { return std::string(c.param.scene) + (c.param.script > 1.0 ? "_at_work_" : "_at_start_") + std::to_string(c.param.seed); });

/// The hands move at 0.15 m/s in a box of 43 mm and give way at 20 N (`hand_force`), a step after they feel it.
TEST_P(WildHands, StayFiniteAndNothingIsFlung) {
  while (run_.time() < GetParam().script && run_.advance()) {}
  input_ = handsAsTheyAre(run_.state());
  const int steps = abuseSteps(), again = std::min(steps, kAgain);
  drive(steps - again);
  expectTheSameAgain(again);
  hold(kStill);
  const State& s = run_.state();
  const double left = kineticEnergy(scenario_.model, s);         // [J]
  double mass = 0.0;                           // [kg]
  for (double m : scenario_.model.tissue.mass) mass += m;
  std::printf("%s from %.1f s, seed %d, %d steps: at most %.2f N, %.3f mJ of %.1f g, %.1e J left; of %.1f mJ at most %.4f mJ created; %d holes, %d tears, %d breaks, %d steps with a number that is none; "
              "of %d nodes looked at, deeper than %.1f mm in tissue %d (at most %.2f mm), in tools %d (%.2f mm; %d in one that has gone through a wall), through a wall %d\n",
              GetParam().scene, GetParam().script, static_cast<int>(GetParam().seed), steps, most_, 1e3 * liveliest_, 1e3 * mass, left, 1e3 * audit_.most(), 1e3 * audit_.created(), s.strand.holeCount, s.metrics.tears,
              s.knot.breaks, broken_, deepest_.nodes, 1e3 * kDeep, deepest_.inTissue, 1e3 * deepest_.tissue, deepest_.inTool, 1e3 * deepest_.tool, deepest_.inPassed, deepest_.through);
  EXPECT_EQ(broken_, 0);
  EXPECT_LT(most_, 60.0);
  EXPECT_LE(left, 1e-4);                       // [J] a second after the hands have come to rest
  EXPECT_LE(deepest_.inTissue, deepest_.nodes / 50);
  EXPECT_LE(deepest_.inTool, deepest_.nodes / 1000);
  EXPECT_EQ(deepest_.through, 0);
  EXPECT_LE(audit_.created(), 5e-3);            // [J] at a time
  EXPECT_LE(liveliest_, 0.5 * mass * 1.6 * 1.6);   // all of it at 1.6 m/s, ten times as fast as the hands: the law of RandomHands
  std::string error;
  EXPECT_TRUE(fits(scenario_.model, s, error)) << error;
}

/// Everything that may be asked of the assistant, again and again and of hands that there are not. Where two instruments and clamps are laid out and thread is handed.
TEST(WildCommands, AreAnsweredAtAnyMomentAndLeaveEverythingFinite) {
  constexpr Command::Kind kKinds[] = {Command::Kind::kFreshThread, Command::Kind::kChangeInstrument, Command::Kind::kHandOver};
  constexpr double kValues[] = {0.0, 1.0, -1e300, 1e300, std::numeric_limits<double>::quiet_NaN()};   // [1]
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/altemeier/expert.toml", {"thread.assist=knot"});
  Lockstep run(scenario);
  while (run.time() < 0.1 && run.advance()) {}
  State& s = run.state();
  HandNoise hands(5, Vec3(0.0, 18e-3, 18e-3));   // [m] about the fold
  StepInput input = handsAsTheyAre(s);
  StepOutput out;
  int answers[3] = {}, asked = 0;
  double most = 0.0;                           // [N]
  for (int k = 0; k < 800; ++k) {
    hands.move(input);
    input.command = {};
    if (k % 7 == 0) { input.command = {kKinds[asked % 3], kValues[asked % 5]}; ++asked; }
    step(scenario.model, input, s, out);
    ASSERT_TRUE(finite(s)) << "step " << k;
    for (const ToolState& t : s.tools) most = std::max(most, t.force.norm());
    for (int e = 0; e < out.eventCount; ++e) {
      const EventKind kind = out.events[e].kind;
      answers[0] += kind == EventKind::kThreadHanded || kind == EventKind::kThreadRefused;
      answers[1] += kind == EventKind::kInstrumentChanged || kind == EventKind::kInstrumentRefused;
      answers[2] += kind == EventKind::kClampHandedOver || kind == EventKind::kClampRefused;
    }
  }
  for (int kind = 0; kind < 3; ++kind) EXPECT_EQ(answers[kind], asked / 3 + (kind < asked % 3 ? 1 : 0)) << kind;
  EXPECT_LT(most, 60.0);
  std::string error;
  EXPECT_TRUE(fits(scenario.model, s, error)) << error;
}

}  // namespace
}  // namespace halsted::app
