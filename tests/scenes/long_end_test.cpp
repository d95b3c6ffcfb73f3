/// The long end of a tie in the hand that winds it (scenes/tie_take_long.cpp).
#include <gtest/gtest.h>

#include <array>

#include "scenes/tie_phases.h"
#include "sim/strand/strand.h"
#include "tests/scenes/tying.h"

namespace halsted {
namespace {

class LongEnd : public Tying {
 protected:
  LongEnd() : Tying("1") {}

  /// A look at the long end that the left hand holds; does a curl of it, 12 mm nearer to the stitch, lie between the jaws, too?
  int phaseAfter(bool curl) {
    memory->phase = scenes::kFreeLong;
    memory->phaseStart = w.state.step;
    std::vector<Vec3>& x = w.state.strand.position;
    const std::vector<Vec3> kept = x;          // [m]
    const ToolState& hand = w.state.tools[kLeft];
    const int node = threadSpot(w.model.strand, hand.threadCoordinate - 12e-3).node;
    for (const int side : {0, 1})
      if (curl) x[node + side] = hand.proxy.apply(Vec3(0.0, side == 0 ? -0.3e-3 : 0.3e-3, 5e-3));
    std::array<HandTarget, kHands> target;
    scenes::advanceExpert(script, w.model, w.state, *memory, target, w.failure);
    x = kept;
    return memory->phase;
  }
};

/// What lies between closed jaws is held by them; the grip at their tips does not feel it. Wound so, 40 mm of tail were drawn through the walls of `connell`.
TEST_F(LongEnd, TakenTwiceIsTakenOnceMore) {
  runTo(scenes::kLiftLong);
  EXPECT_NE(phaseAfter(false), scenes::kNearer);
  const int misses = memory->knot.misses;
  EXPECT_EQ(phaseAfter(true), scenes::kNearer);
  EXPECT_EQ(memory->knot.misses, misses + 1);
  memory->knot.misses = scenes::kAttempts;     // there may be no place where it lies by itself
  EXPECT_NE(phaseAfter(true), scenes::kNearer);
}

}  // namespace
}  // namespace halsted
