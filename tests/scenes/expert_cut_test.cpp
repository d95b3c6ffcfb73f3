/// Where the scripted surgeon cuts the needle off: so far past the hand that holds the long end, and nothing else with it.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/strand/strand.h"
#include "tests/scenes/tied_wall.h"

namespace halsted {
namespace {

SimParams withBlades() {
  SimParams p = tiedWallParams();
  p.tools[kRight].cutter = true;
  return p;
}

std::string drawAndCut(const TiedWall& w, int beyond) {          // [mm] as the script has it
  const double through = w.model.strand.length - w.state.strand.holes[w.state.strand.holeCount - 1].coordinate;   // [m]
  return "[[action]]\ndo = \"draw\"\ntail_mm = 30\npull_mm = " + std::to_string(1e3 * through + 2.0) +
         "\nlimit_s = 20\n[[action]]\ndo = \"cut\"\nbeyond_hand_mm = " + std::to_string(beyond) + "\nlimit_s = 30\n";
}

/// Between the hand that holds the long end and the place where the thread is parted.  [m]
double leftPastTheHand(int beyond) {           // [mm] as the script has it
  TiedWall w(withBlades());
  EXPECT_TRUE(w.act(drawAndCut(w, beyond))) << w.failure;
  const std::vector<std::uint8_t>& cut = w.state.threadContacts.cut;
  const auto at = std::find(cut.begin(), cut.end(), std::uint8_t{1});
  EXPECT_NE(at, cut.end()) << "nothing was cut";
  return at == cut.end() ? -1.0 : w.model.strand.place[at - cut.begin()] - w.state.tools[kLeft].threadCoordinate;
}

TEST(ExpertCut, LeavesAsMuchPastTheHandAsTheScriptSays) {
  EXPECT_NEAR(leftPastTheHand(24), 24e-3, 3e-3);   // [m] twice what it is where the script is silent; to a segment of 2 mm
}

/// The driver has the thread in its jaws there.
void holdThread(TiedWall& w, double coordinate) {   // [m]
  ToolState& driver = w.state.tools[kRight];
  driver.proxy.position = strandPoint(w.model.strand, w.state.strand, coordinate);
  driver.device = w.input.tools[kRight].pose = driver.proxy;
  driver.jaw = w.input.tools[kRight].jaw = 0.0;
  driver.closed = true;
  driver.threadCoordinate = coordinate;
}

TEST(ExpertCut, TakesTheThreadByTheStitchWhereTheDriverHasItCloseToTheNeedle) {
  TiedWall w(withBlades());
  const double place = w.model.strand.length - 20e-3;   // [m] what is left beyond is not enough to take it there
  holdThread(w, place);
  EXPECT_TRUE(w.act("[[action]]\ndo = \"cut\"\nlimit_s = 30\n")) << w.failure;
  EXPECT_GT(w.state.knot.cuts, 0);
  EXPECT_LT(w.state.tools[kLeft].threadCoordinate, place - 5e-3);
}

/// The hand closes on what the driver holds out to it and gets another turn of the thread: it lets go of that and tries again.
TEST(ExpertCut, TheOtherHandLetsGoOfAnotherTurnOfTheThread) {
  TiedWall w(withBlades());
  holdThread(w, w.model.strand.length - 60e-3);
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n[[action]]\ndo = \"cut\"\nlimit_s = 30\n", "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  double& held = w.state.tools[kLeft].threadCoordinate;          // [m]
  while (!w.state.tools[kLeft].closed || held < 0.0) ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
  const double wanted = held;                  // [m]
  bool opened = false;
  for (int k = 0; k < 1000 && !opened; ++k) {
    if (w.state.tools[kLeft].closed) held = wanted - 25e-3;
    ASSERT_TRUE(w.advance(script, *memory)) << w.failure;
    opened = !w.state.tools[kLeft].closed;
  }
  EXPECT_TRUE(opened);
  while (w.advance(script, *memory)) {}
  EXPECT_EQ(w.failure, "");
  EXPECT_GT(w.state.knot.cuts, 0);
}

/// The needle goes round one of the driver's open jaws, in the fork between them, like a ring.
void hookNeedle(TiedWall& w) {
  const StrandModel& m = w.model.strand;
  const Pose& driver = w.state.tools[kRight].proxy;
  const Vec3 middle = m.arcPoint[StrandModel::kArcTable / 2], along = m.arcTangent[StrandModel::kArcTable / 2];   // [m], [1] needle frame
  const Vec3 inward = (m.needleCentre - middle).normalized();
  Mat3 needle, tool;
  needle << inward, along, inward.cross(along);
  tool << Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ();
  StrandState& s = w.state.strand;
  s.needle.orientation = (driver.orientation * Quat(tool * needle.transpose())).normalized();
  s.needle.position = driver.apply(Vec3(0.0, 0.0, 11e-3)) - s.needle.orientation * middle;
  s.needleVelocity = s.needleSpin = Vec3::Zero();
}

/// The needle lies beside the driver, farther off than its own radius.
void layNeedleBeside(TiedWall& w) {
  StrandState& s = w.state.strand;
  s.needle.position += w.state.tools[kRight].proxy.apply(Vec3(20e-3, 0.0, 0.0)) - s.needle.apply(w.model.strand.needleCentre);
  s.needleVelocity = s.needleSpin = Vec3::Zero();
}

SimParams gravityAcross() {
  SimParams p = withBlades();
  p.gravity = Vec3(0.0, -9.81, 0.0);           // across the driver as it cuts
  return p;
}

/// Cuts; from when the driver is nearly up again the needle is put where `put` wants it, until the driver has turned its tips to the ground.
/// True if it has.
bool turnsTipsDown(TiedWall& w, void (*put)(TiedWall&)) {
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n" + drawAndCut(w, 24), "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  double low = 0.0;                            // [m] the driver as it cuts
  bool turned = false, placed = false;
  while (w.advance(script, *memory)) {
    const Pose& driver = w.state.tools[kRight].proxy;
    if (w.state.knot.cuts == 0) low = driver.position.z();
    if (driver.position.z() < low + 28e-3 && !placed) continue;
    turned = turned || (driver.orientation * Vec3::UnitZ()).y() > 0.9;
    if (!turned) put(w);
    placed = true;
  }
  EXPECT_EQ(w.failure, "");
  EXPECT_TRUE(placed);
  return turned;
}

TEST(ExpertCut, ShakesOffTheNeedleThatHasCaughtOnItsJaws) {
  TiedWall w(gravityAcross());
  EXPECT_TRUE(turnsTipsDown(w, hookNeedle));
  ASSERT_TRUE(w.act("[[action]]\ndo = \"let_go\"\nlimit_s = 10\n")) << w.failure;   // and up, without it
  const Vec3 needle = w.state.strand.needle.apply(w.model.strand.needleCentre);   // [m]
  EXPECT_GT((needle - w.state.tools[kRight].proxy.position).norm(), 30e-3);
}

TEST(ExpertCut, IsNotShakenOfANeedleThatOnlyLiesNear) {
  TiedWall w(gravityAcross());
  EXPECT_FALSE(turnsTipsDown(w, layNeedleBeside));
}

/// The first segment of the tail across the driver's blades, where they are open, for as long as this lives.
struct TailBetweenTheBlades {
  State& state;
  Vec3 where[2];                               // [m]

  explicit TailBetweenTheBlades(State& s) : state(s) {
    for (int i = 0; i < 2; ++i) {
      where[i] = s.strand.position[i];
      s.strand.position[i] = s.tools[kRight].proxy.apply(Vec3(0.0, i == 0 ? -0.5e-3 : 0.5e-3, 9.5e-3));
    }
  }
  ~TailBetweenTheBlades() { std::copy(where, where + 2, state.strand.position.begin()); }
};

/// Cuts made by a surgeon who sees another turn of the thread between the blades as often as these are open.
int cutsThoughAnotherTurnIsSeen(std::string& failure) {
  TiedWall w(withBlades());
  const scenes::ExpertScript script = scenes::parseExpert("scene = \"wall\"\n" + drawAndCut(w, 24), "test");
  const scenes::ExpertStatePtr memory = scenes::beginExpert(script, w.model);
  for (bool more = true; more;) {
    std::array<HandTarget, kHands> target;
    {
      const TailBetweenTheBlades seen(w.state);
      more = scenes::advanceExpert(script, w.model, w.state, *memory, target, failure);
    }
    w.follow(target);
    w.step();
  }
  return w.state.knot.cuts;
}

TEST(ExpertCut, DoesNotCloseTheBladesOnAnotherTurnOfTheThread) {
  std::string failure;
  EXPECT_EQ(cutsThoughAnotherTurnIsSeen(failure), 0);
  EXPECT_NE(failure.find("not between the blades"), std::string::npos) << failure;
}

}  // namespace
}  // namespace halsted
