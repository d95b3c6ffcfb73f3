/// The instrument tie through the whole step: two tools, one thread, no helping hand from the program.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "scenes/expert_state.h"
#include "scenes/tie_phases.h"
#include "sim/strand/knot_diagram.h"
#include "tests/scenes/tied_wall.h"
#include "tests/sim/tensile_test.h"

namespace halsted {
namespace {

constexpr double kWanted = 5.0;                // [N] that a knot must bear

struct Tied : TiedWall {
  Tied(const std::string& throws, const std::string& newtons, const std::string& then = "", double gravity = 0.0) : TiedWall(tiedWallParams(gravity)) {   // [m/s^2]
    const std::string tie = "[[action]]\ndo = \"tie\"\ntie = \"" + throws + "\"\ntension_n = " + newtons + "\nlimit_s = 120\n";
    EXPECT_TRUE(act(tie + then)) << failure;
    EXPECT_EQ(state.threadContacts.dropped, 0) << "thread has passed through thread";
    EXPECT_EQ(seen(Quantity::kThreadBreaks), 0);
  }
  std::string reading() const { return knotName(readKnot(state.strand.position)); }
  double stitchTension() const {               // [N] in the thread inside the wall
    const StrandState& s = state.strand;
    return strandTension(model.strand, s, 0.5 * (s.holes[0].coordinate + s.holes[s.holeCount - 1].coordinate), 1);
  }
  /// What the stitch keeps a second after both hands have let go.  [N]
  double stitchLeftAlone() {
    const double drawn = stitchTension();      // [N]
    EXPECT_TRUE(act("[[action]]\ndo = \"let_go\"\n[[action]]\ndo = \"hold\"\nlimit_s = 1\n")) << failure;
    std::printf("%s: stitch at %.2f N, %.3f N when the hands have let go\n", reading().c_str(), drawn, stitchTension());
    return stitchTension();
  }
  TensileTest::Result pull() const {
    const TensileTest::Result r = TensileTest(*this).load(kWanted);
    std::printf("%s after %.1f s: bore %.2f N, opened %.2f mm, %s\n", reading().c_str(), state.step * model.params.dt, r.most, 1e3 * r.gained,
                r.outcome());
    return r;
  }
};

TEST(InstrumentTie, ASingleThrowIsReadAndSlips) {
  Tied w("1", "3.0");
  EXPECT_EQ(w.reading(), "half hitch");
  EXPECT_EQ(w.seen(Quantity::kThrows), 1);
  EXPECT_EQ(w.seen(Quantity::kKnotLocks), 0);
  EXPECT_GT(w.seen(Quantity::kTailTension), 2.0);   // [N] drawn with 3, little of which comes through the throw
  const TensileTest::Result r = w.pull();
  EXPECT_TRUE(r.slipped());
  EXPECT_LT(r.most, 1.0);
  EXPECT_LT(w.stitchLeftAlone(), 0.005);       // [N] under a single throw the stitch gives up all its tension
}

/// Tying is chaotic: three ties, that differ by 10 pN of weight a gram, and the middle of what they keep.
TEST(InstrumentTie, ThrowsOfOppositeSenseLockTheOneBeforeAndHold) {
  std::array<double, 3> kept{};                // [N]
  for (std::size_t i = 0; i < kept.size(); ++i) {
    Tied w("1=1=1", "3.0", "", 1e-8 * static_cast<double>(i));
    EXPECT_NE(std::find(w.read.begin(), w.read.end(), "square"), w.read.end()) << "after the second throw";
    EXPECT_EQ(w.reading(), "1=1=1");
    EXPECT_EQ(w.seen(Quantity::kThrows), 3);
    EXPECT_EQ(w.seen(Quantity::kKnotLocks), 2);
    EXPECT_EQ(w.seen(Quantity::kWrongThrows), 0);
    EXPECT_GT(w.seen(Quantity::kTailTension), 2.0);   // [N]
    EXPECT_TRUE(w.pull().held);
    kept[i] = w.stitchLeftAlone();
  }
  std::sort(kept.begin(), kept.end());
  EXPECT_GT(kept[1], 0.04);                    // [N] under locked throws it keeps some, of the little that is left once the first has borne it alone
}

/// A double throw, of two turns round the driver, under two single ones that are wound to and fro.
TEST(InstrumentTie, ASurgeonsKnotIsReadThrowByThrowAndHolds) {
  Tied w("2=1=1", "3.0");
  for (const std::string& reading : w.read) std::printf("%s, ", reading.c_str());
  std::printf("at last %s\n", w.reading().c_str());
  for (const char* throws : {"2", "2=1", "surgeon's"}) EXPECT_NE(std::find(w.read.begin(), w.read.end(), throws), w.read.end()) << throws;
  EXPECT_EQ(w.seen(Quantity::kFirstTurns), 2);
  EXPECT_EQ(w.seen(Quantity::kWrongThrows), 0);
  EXPECT_TRUE(w.pull().held);
  EXPECT_GT(w.stitchLeftAlone(), 0.05);        // [N]
}

/// The driver that has drawn the thread through still holds it: the other hand takes it over, and at no moment does the long end fall.
TEST(InstrumentTie, TheLongEndIsHandedOverBeforeTheDriverLetsGo) {
  TiedWall w;
  const double through = w.model.strand.length - w.state.strand.holes[w.state.strand.holeCount - 1].coordinate;   // [m]
  const std::string pull = std::to_string(1e3 * through + 2.0);
  ASSERT_TRUE(w.act("[[action]]\ndo = \"draw\"\ntail_mm = 30\npull_mm = " + pull + "\nlimit_s = 20\n")) << w.failure;
  ASSERT_GT(w.state.tools[kRight].threadCoordinate, w.state.strand.holes[1].coordinate);
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\nlimit_s = 20\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  const auto holdsLong = [&](int hand) { return w.state.tools[hand].threadCoordinate > w.state.strand.holes[1].coordinate; };
  int steps = 0;
  for (; steps < 12000 && holdsLong(kRight); ++steps) ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  EXPECT_GT(steps, 100);
  EXPECT_FALSE(holdsLong(kRight)) << "it never lets go";
  EXPECT_TRUE(holdsLong(kLeft)) << "when the driver lets go";
}

/// A hand that has the long end farther from the stitch than the tie wants it: the driver takes it nearer and hands it over.
TEST(InstrumentTie, AnEndHeldTooFarOutComesNearerAndNeverFalls) {
  TiedWall w;
  const auto tie = [](int longEnd) { return scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\nlong_end_mm = " + std::to_string(longEnd) + "\nlimit_s = 20\n", "test"); };
  const auto held = [&](int hand) { return w.state.tools[hand].threadCoordinate - w.state.strand.holes[1].coordinate; };   // [m] from the stitch
  const scenes::ExpertScript far = tie(80), near = tie(50);
  const scenes::ExpertStatePtr before = scenes::beginExpert(far, w.model), memory = scenes::beginExpert(near, w.model);
  for (int k = 0; k < 12000 && held(kLeft) < 0.0; ++k) ASSERT_TRUE(w.advance(far, *before)) << w.failure;
  ASSERT_GT(held(kLeft), 70e-3);
  int steps = 0;
  double most = 0.0;                           // [N] on a hand
  for (; steps < 12000 && !(held(kLeft) > 0.0 && held(kLeft) < 60e-3); ++steps) {
    ASSERT_TRUE(w.advance(near, *memory)) << w.failure;
    ASSERT_TRUE(held(kLeft) > 0.0 || held(kRight) > 0.0) << "let fall after " << steps << " steps";
    for (const ToolState& t : w.state.tools) most = std::max(most, t.threadForce.norm());
  }
  EXPECT_LT(steps, 12000);
  EXPECT_LT(most, 1.0) << "what lies between the hands is drawn taut as one of them rises";
}

/// A needle that was cut off clings to the jaws that have the long end: they open, but only when the driver has that.
TEST(InstrumentTie, AHandThatFreesItselfOfTheNeedleLetsNoThreadFall) {
  TiedWall w;
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\nlimit_s = 20\n", "test");
  const scenes::ExpertStatePtr before = scenes::beginExpert(script, w.model), memory = scenes::beginExpert(script, w.model);
  const auto held = [&](int hand) { return w.state.tools[hand].threadCoordinate - w.state.strand.holes[1].coordinate; };   // [m] from the stitch
  for (int k = 0; k < 12000 && held(kLeft) < 0.0; ++k) ASSERT_TRUE(w.advance(script, *before)) << w.failure;
  ASSERT_GT(held(kLeft), 0.0);
  w.state.threadContacts.cut.assign(w.model.strand.nodes, 0);
  w.state.threadContacts.cut[threadSpot(w.model.strand, w.state.tools[kLeft].threadCoordinate + 8e-3).node] = 1;
  bool opened = false;
  for (int k = 0; k < 12000 && !(opened && held(kLeft) > 0.0 && held(kRight) < 0.0); ++k) {
    if (!opened) w.state.strand.needle.position += w.state.tools[kLeft].proxy.position - w.state.strand.needle.apply(w.model.strand.needleCentre);
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    ASSERT_TRUE(held(kLeft) > 0.0 || held(kRight) > 0.0) << "let fall after " << k << " steps";
    opened = opened || held(kLeft) < 0.0;
  }
  EXPECT_TRUE(opened);
  EXPECT_GT(held(kLeft), 0.0);
}

/// The other hand misses what hangs from the driver: each time it tries nearer to the jaws, where thread is steadier.
TEST(InstrumentTie, AHandThatMissesTheHangingThreadTriesNearerToTheJaws) {
  TiedWall w;
  const double through = w.model.strand.length - w.state.strand.holes[w.state.strand.holeCount - 1].coordinate;   // [m]
  const std::string pull = std::to_string(1e3 * through + 2.0);
  ASSERT_TRUE(w.act("[[action]]\ndo = \"draw\"\ntail_mm = 30\npull_mm = " + pull + "\nlimit_s = 20\n")) << w.failure;
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\nlimit_s = 20\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  const auto nearest = [&](const Vec3& p) {    // [m] along the thread, of the node that is nearest
    const auto& x = w.state.strand.position;
    return w.model.strand.place[std::min_element(x.begin(), x.end(), [&](const Vec3& a, const Vec3& b) { return (a - p).norm() < (b - p).norm(); }) - x.begin()];
  };
  std::vector<double> tried;                   // [m] of thread between the hands
  for (bool closed = true; tried.size() < 4;) {
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    const bool closes = w.state.tools[kLeft].closed;
    const double driver = w.state.tools[kRight].threadCoordinate;   // [m]
    if (closes && !closed) tried.push_back(nearest(w.state.tools[kLeft].proxy.position) - driver);
    w.state.tools[kLeft].threadCoordinate = -1.0;   // it has slipped out
    closed = closes;
  }
  for (std::size_t i = 1; i < tried.size(); ++i) EXPECT_LT(tried[i], tried[i - 1] - 1e-3);
  EXPECT_GT(tried.back(), 5e-3);               // not into the driver
}

/// Thread drawn through the wall while it is wound is slack for the winding hand: that goes no further out for it, or it would draw in the
/// whole tail.
TEST(InstrumentTie, ThreadDrawnInWhileItIsWoundIsNotWoundWith) {
  TiedWall w;
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\nlimit_s = 40\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  const auto apart = [&] { return (w.input.tools[kLeft].pose.position - w.input.tools[kRight].pose.position).norm(); };   // [m] of the hands
  for (int k = 0; k < 30000 && w.seen(Quantity::kToolTurns) < 1; ++k) ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  const double before = apart();               // [m]
  for (int k = 0; k < 300; ++k) {
    for (Hole& h : w.state.strand.holes) h.coordinate -= 3e-5;   // [m] 9 mm in all
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  }
  std::printf("hands %.1f mm apart before, %.1f mm after\n", 1e3 * before, 1e3 * apart());
  EXPECT_LT(apart(), before + 3e-3);
}

/// The winding hand feels the stitch as the driver closes on the tail: the loop lies between the jaws, too. They open again; drawn through, it
/// would tear at the wall.
TEST(InstrumentTie, JawsThatHaveClosedOnTheirLoopOpenAgain) {
  TiedWall w;
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\nlimit_s = 40\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  const auto holdsTail = [&] { return w.state.tools[kRight].threadCoordinate >= 0.0 && w.state.tools[kRight].threadCoordinate < w.state.strand.holes[0].coordinate; };
  for (int k = 0; k < 30000 && !holdsTail(); ++k) ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  ASSERT_TRUE(holdsTail());
  const Vec3 at = w.state.tools[kRight].proxy.position;   // [m]
  int steps = 0;
  for (; steps < 1000 && holdsTail(); ++steps) {
    w.state.tools[kLeft].threadForce = 1.0 * Vec3::UnitZ();   // [N] as if it were
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  }
  EXPECT_FALSE(holdsTail());
  EXPECT_LT((w.state.tools[kRight].proxy.position - at).norm(), 3e-3) << "opened where they closed";
}

/// The end of the tail comes between the blades while the jaws close on it: they open again, or it would be cut off and the tail be missed.
TEST(InstrumentTie, JawsThatWouldCutTheTailOpenAgain) {
  SimParams p = tiedWallParams();
  p.tools[kRight].cutter = true;
  TiedWall w(p);
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\nlimit_s = 40\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  const auto closing = [&] { return w.input.tools[kRight].jaw < 0.9 && w.state.tools[kRight].jaw < 0.9; };
  bool wound = false, wasOpen = false;         // with the loop on the jaws, for the tail
  for (int k = 0; k < 30000 && !(wasOpen && closing()); ++k) {
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    wound = wound || w.seen(Quantity::kToolTurns) >= 1;
    wasOpen = wasOpen || (wound && w.state.tools[kRight].jaw > 0.99);
  }
  ASSERT_TRUE(wasOpen && closing());
  const int cuts = w.state.knot.cuts;
  for (int k = 0; k < 200; ++k) {
    for (int i = 0; i < 3; ++i) w.state.strand.position[i] = w.state.tools[kRight].proxy.apply(Vec3(0.0, 0.2e-3 * i, 9.5e-3));   // [m] between the blades
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  }
  EXPECT_EQ(w.state.knot.cuts, cuts);
  EXPECT_GT(w.state.tools[kRight].jaw, 0.9);
}

/// As the tail is let go, the hand that holds the long end has eased off: or it would draw the throw along the tail, off the stitch, and lift
/// the wall by it as it rises to wind the next.
TEST(InstrumentTie, TheHandThatDrewEasesOffAsTheTailIsLaid) {
  TiedWall w;
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1=1\"\ntension_n = 3\nlimit_s = 60\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  const auto pull = [&](int hand) { return w.state.tools[hand].threadForce.norm(); };   // [N]
  const auto run = [&](const auto& until) { while (!until()) ASSERT_TRUE(w.advance(script, *memory)) << w.failure; };
  run([&] { return pull(kLeft) > 2.0 && pull(kRight) > 2.0; });
  run([&] { return w.state.tools[kRight].threadCoordinate < 0.0; });
  double most = 0.0;                           // [N]
  const auto idle = [&] { return memory->phase == scenes::kLetTail || memory->phase == scenes::kLiftLong || memory->phase == scenes::kStand; };
  run([&] {                                    // a throw that is drawn once more is let go once more
    if (idle()) most = std::max(most, pull(kLeft));
    return memory->phase == scenes::kWind;
  });
  std::printf("at most %.3f N in the long end until it is wound again\n", most);
  EXPECT_LT(most, 0.05);
}

/// Jaws that miss the tail close on it elsewhere the next time: what they took instead still lies where it lay.
TEST(InstrumentTie, ADriverThatMissesTheTailTriesElsewhereOnIt) {
  TiedWall w;
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\nlimit_s = 60\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  std::vector<double> tried;                   // [m] along the tail
  while (tried.size() < 2) {
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    double& held = w.state.tools[kRight].threadCoordinate;   // [m]
    if (held < 0.0 || held > w.state.strand.holes[0].coordinate) continue;
    tried.push_back(held);
    while (w.state.tools[kRight].closed) {
      held = -1.0;                             // it has slipped out
      ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    }
  }
  EXPECT_GT(tried[1], tried[0] + 2e-3);
}

/// A tail longer than the action wants it is drawn through the wall to that length by the hand that holds the long end, before a turn is wound.
TEST(InstrumentTie, ATailTooLongIsDrawnToTheLengthWanted) {
  TiedWall w;
  const auto tail = [&] { return w.state.strand.holes[0].coordinate; };   // [m]
  ASSERT_GT(tail(), 24e-3);
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"tie\"\ntie = \"1\"\ntail_mm = 16\nlimit_s = 20\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  int steps = 0;
  for (; steps < 12000 && tail() > 16e-3; ++steps) {
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    ASSERT_EQ(w.seen(Quantity::kToolTurns), 0) << "wound after " << steps << " steps, the tail still " << 1e3 * tail() << " mm";
  }
  EXPECT_NEAR(tail(), 16e-3, 0.1e-3);
  EXPECT_GT(w.state.tools[kLeft].threadCoordinate, w.state.strand.holes[1].coordinate);
}

/// Both hands open before the throw is drawn tight: nothing is left that bears anything.
TEST(InstrumentTie, LettingGoBeforeTighteningUndoesIt) {
  const Tied w("1", "0.05", "[[action]]\ndo = \"let_go\"\n[[action]]\ndo = \"hold\"\nlimit_s = 1\n");
  EXPECT_EQ(w.state.tools[kLeft].threadCoordinate, -1.0);
  EXPECT_EQ(w.state.tools[kRight].threadCoordinate, -1.0);
  const TensileTest::Result r = w.pull();
  EXPECT_TRUE(r.slipped());
  EXPECT_LT(r.most, 0.2);
}

}  // namespace
}  // namespace halsted
