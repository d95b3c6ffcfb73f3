/// The sewing scenes by physics from their scripts, with knots that nothing but friction holds. SlowFriction takes up to an hour.
#include "sim/strand/knot_diagram.h"
#include "sim/strand/strand.h"
#include "tests/app/sewn_run.h"

namespace halsted::app {
namespace {

struct Sewn {
  const char* scene;
  const char* places;                          // [deg] of the stitches
  int stitches;                                // tied at least, each followed by a fresh thread; 0: one thread, the needle cut off
  double widest;                               // [m] between the walls when all is done
  int fullThickness, held;                     // bites of each stitch through the whole wall; tails in a hand at the end
  bool completes;                              // the whole procedure
  double apart;                                // [m] between nodes, at most, where a knot at the end presses; 0: the thread is a fresh one, or not looked at
  std::size_t lost = 0;                        // stitches that may be lost on the way and set anew
};

std::ostream& operator<<(std::ostream& out, const Sewn& s) { return out << s.scene; }

constexpr double kFinest = 0.2e-3, kCoarsest = 0.4e-3;   // [m] between nodes where thread is knotted: asked for

/// What part of the force with which thread presses on thread is where its nodes are no farther apart.  [1] [m]
double finelyKnotted(const StrandModel& strand, const ThreadContactState& contacts, double apart) {
  double fine = 0.0, all = 0.0;                // [N]
  for (int i = 0; i < contacts.count; ++i) {
    const ThreadContact& c = contacts.contacts[i];
    if (c.partner < 0) continue;
    all += c.normalForce;
    if (strand.place[c.partner + 1] - strand.place[c.partner] < 1.01 * apart) fine += c.normalForce;
  }
  return all > 0.0 ? fine / all : 0.0;
}

class FrictionPreset : public ::testing::TestWithParam<const char*> {};

TEST_P(FrictionPreset, RefinesThreadForKnotsOfItsOwnSize) {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/" + GetParam() + "/expert.toml", {"preset=friction"});
  const StrandModel& strand = scenario.model.strand;
  double fine = 0.0;                           // [m] of thread
  for (int i = 0; i + 1 < strand.nodes; ++i) {
    const double length = strand.place[i + 1] - strand.place[i];       // [m]
    EXPECT_GT(length, 0.99 * kFinest);
    if (length < 1.01 * kCoarsest) fine += length;
  }
  EXPECT_GT(fine, 60e-3);                      // tail, bites and the long end's side of the knot
}

INSTANTIATE_TEST_SUITE_P(Scenes, FrictionPreset, ::testing::Values("stay", "connell", "lembert", "altemeier"), [](const auto& scene) { return std::string(scene.param); });

class SlowFriction : public ::testing::TestWithParam<Sewn> {};

TEST_P(SlowFriction, HoldsTheWallsByThreadOnThreadAlone) {
  const testing::TemporaryFolder folder;
  const Sewn& sewn = GetParam();
  const Scenario scenario = scenarioFromFile(scriptAt(folder, sewn.scene, sewn.places), {"preset=friction"});
  Lockstep run(scenario);
  int throws = 0;                              // the most that were read on one thread
  while (run.advance()) throws = std::max(throws, run.state().knot.throws);
  EXPECT_EQ(run.failure(), "");
  EXPECT_LE(run.lostStitches().size(), sewn.lost) << run.lostStitches().back();
  const State& s = run.state();
  const RunSummary summary = summariseRun(sewn.scene, "t", scenario.model, s, run.stepTimes(), 1.0);
  EXPECT_EQ(summary.completed, sewn.completes);
  for (const ProcedureLine& line : summary.procedure) EXPECT_EQ(line.faults, 0) << line.id;
  std::map<std::string, double> m(summary.metrics.begin(), summary.metrics.end());   // by the name's unit
  EXPECT_FALSE(s.assist);
  EXPECT_EQ(m.count("assisted_knots"), 0u);
  EXPECT_GE(throws, 2);
  EXPECT_EQ(m["tears"], 0.0);
  EXPECT_EQ(m["full_thickness_bites"], sewn.fullThickness * std::max(1.0, m["stitches"]));
  if (sewn.stitches == 0) {                    // with one thread
    expectSewn(run, sewn.scene);
    if (sewn.apart > 0.0) { EXPECT_GT(finelyKnotted(scenario.model.strand, s.threadContacts, sewn.apart), 0.9); }
  }
  int held = 0;
  for (const ToolState& t : s.tools) held += t.threadCoordinate >= 0.0 ? 1 : 0;
  EXPECT_EQ(held, sewn.held);
  EXPECT_LT(m["wall_gap_m"], sewn.widest);
  EXPECT_GE(m["stitches"], sewn.stitches);
  EXPECT_EQ(s.threadContacts.dropped, 0) << "thread has passed through thread";
  std::printf("%s by friction: %.1f s, at most %d throws read, now %s, walls %.2f mm apart, at most %.2f N in the thread\n", sewn.scene, run.time(), throws,
              knotName(readKnot(s.strand.position)).c_str(), 1e3 * m["wall_gap_m"], m["peak_tension_n"]);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SlowFriction,
                         ::testing::Values(Sewn{"connell", "", 0, 1.5e-3, 4, 0, true, 0.0}, Sewn{"stay", "", 0, 1.5e-3, 0, 2, true, kCoarsest}, Sewn{"lembert", "1, 14, 28", 3, 1.5e-3, 0, 0, false, 0.0, 1},
                                           Sewn{"altemeier", "", 4, 1.5e-3, 2, 0, true, 0.0}),
                         [](const auto& scene) { return std::string(scene.param.scene); });

}  // namespace
}  // namespace halsted::app
