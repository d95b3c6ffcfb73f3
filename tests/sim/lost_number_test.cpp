/// A state that holds no numbers any more (read from a damaged file, say) is lost, but the step still ends.
#include <gtest/gtest.h>

#include <limits>

#include "sim/tools/come_free.h"
#include "sim/tools/find_touch.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

/// Nothing that is not a number is near. The wall has more triangles than the list holds: it was made anew for ever, with a smaller reach each time.
TEST(LostNumbers, AreNearNoTool) {
  StepRig rig(wallParams(), kNeedleAway, Pose{Vec3(kWallX + 2e-3, 12e-3, 11e-3), Quat::Identity()});
  rig.run(5);
  ASSERT_GT(rig.model.surface.triangles.size(), static_cast<std::size_t>(ToolState::kMaxNear));
  ASSERT_GT(rig.state.tools[kLeft].nearCount, 0);
  for (Vec3& x : rig.state.tissue.position) x.setConstant(std::numeric_limits<double>::quiet_NaN());
  for (int hand = 0; hand < kHands; ++hand) {
    listNearTriangles(rig.model, hand, rig.state);
    EXPECT_EQ(rig.state.tools[hand].nearCount, 0);
  }
  rig.run(20);
  EXPECT_EQ(rig.state.step, 25u);
}

/// Places on the way of a tool that comes free are looked at one by one: not a hundred million of them.
TEST(LostNumbers, DoNotKeepAToolLookingForTissueOnItsWay) {
  StepRig rig(wallParams(), kNeedleAway);
  rig.run(5);
  const Vec3 lag = rig.state.tools[kLeft].lag;
  followSlowly(rig.model, kLeft, rig.state.tools[kLeft].proxy.position + Vec3(1e5, 0.0, 0.0), rig.state);
  EXPECT_EQ(rig.state.tools[kLeft].lag, lag);
}

}  // namespace
}  // namespace halsted
