/// Where the scripted surgeon cuts the needle off: so far past the hand that holds the long end.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenes/tied_wall.h"

namespace halsted {
namespace {

/// Between the hand that holds the long end and the place where the thread is parted.  [m]
double leftPastTheHand(int beyond) {           // [mm] as the script has it
  SimParams p = tiedWallParams();
  p.tools[kRight].cutter = true;
  TiedWall w(p);
  const double through = w.model.strand.length - w.state.strand.holes[w.state.strand.holeCount - 1].coordinate;   // [m]
  EXPECT_TRUE(w.act("[[action]]\ndo = \"draw\"\ntail_mm = 30\npull_mm = " + std::to_string(1e3 * through + 2.0) + "\nlimit_s = 20\n[[action]]\ndo = \"cut\"\nbeyond_hand_mm = " +
                    std::to_string(beyond) + "\nlimit_s = 30\n")) << w.failure;
  const std::vector<std::uint8_t>& cut = w.state.threadContacts.cut;
  const auto at = std::find(cut.begin(), cut.end(), std::uint8_t{1});
  EXPECT_NE(at, cut.end()) << "nothing was cut";
  return at == cut.end() ? -1.0 : w.model.strand.place[at - cut.begin()] - w.state.tools[kLeft].threadCoordinate;
}

TEST(ExpertCut, LeavesAsMuchPastTheHandAsTheScriptSays) {
  EXPECT_NEAR(leftPastTheHand(24), 24e-3, 3e-3);   // [m] twice what it is where the script is silent; to a segment of 2 mm
}

}  // namespace
}  // namespace halsted
