/// Where the scripted surgeon cuts the needle off: so far past the hand that holds the long end, and nothing else with it.
#include <gtest/gtest.h>

#include <algorithm>

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
