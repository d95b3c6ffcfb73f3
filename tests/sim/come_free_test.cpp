/// Tools that come free follow their hands, and do not jump through what is on the way.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

/// Closed jaws 3 mm over the wall's top edge that thread holds there, beside a hand that would like to be somewhere else; the thread parts.
struct Parted : StepRig {
  explicit Parted(const Vec3& wanted) : StepRig(wallParams(), kNeedleAway, over(3e-3)) {   // [m]
    input.tools[kLeft].jaw = 0.0;              // open ones would straddle the wall
    run(5);
    ToolState& t = state.tools[kLeft];
    input.tools[kLeft].pose.position = wanted;
    t.strandForce = model.params.tools[kLeft].couplingStiffness * (t.proxy.position - wanted);
  }
  static Pose over(double height) { return {Vec3(0.5 * kWallX, 12e-3, kWallZ + 1.2e-3 + height), Quat::Identity()}; }   // [m]
  double way() {                               // [m] of the tool in the next step
    const Vec3 before = state.tools[kLeft].proxy.position;
    step();
    return (state.tools[kLeft].proxy.position - before).norm();
  }
};

/// The coupling has no mass: the tool would be 3 mm deep in the wall in one step, and contacts with both sides of the wall would then part it.
TEST(ComeFree, AToolWhoseThreadPartsMeetsTheWallOnItsWayBack) {
  Parted p(Parted::over(-3e-3).position);
  EXPECT_LT(p.way(), 1e-3);
  p.run(100);
  const ToolState& t = p.state.tools[kLeft];
  ASSERT_GT(t.contactCount, 0);
  EXPECT_GT(t.force.z(), 0.5);                 // [N] the wall holds it up
  EXPECT_LT(std::fabs(t.force.x()), 0.1 * t.force.z());
  EXPECT_EQ(t.lag, Vec3::Zero());
}

TEST(ComeFree, WhereNothingIsInTheWayTheToolIsAtItsHandAtOnce) {
  Parted p(Parted::over(9e-3).position);
  p.step();
  EXPECT_LT((p.state.tools[kLeft].proxy.position - p.input.tools[kLeft].pose.position).norm(), 1e-9);
}

}  // namespace
}  // namespace halsted
