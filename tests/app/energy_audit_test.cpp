/// The audit's own laws: what hands do to the tissue is not created, whether their tools move as a whole or only their jaws do.
#include "tests/app/energy_audit.h"

#include <gtest/gtest.h>

#include "tests/sim/step_rig.h"

namespace halsted::app {
namespace {

/// Open jaws straddle the top edge of the wall from above.
const Pose kStraddling{Vec3(0.5 * kWallX, 12e-3, kWallZ - 2e-3), Quat::Identity()};

TEST(EnergyAudit, ClosingJawsDoTheWorkThatSqueezesAWall) {
  StepRig rig(wallParams(), kNeedleAway, kStraddling);
  rig.run(10);
  EnergyAudit audit;
  for (int k = 0; k < 450; ++k) {
    rig.input.tools[kLeft].jaw = 1.0 - 1e-3 * k;                       // wider than where jaws take hold
    audit.before(rig.state);
    rig.step();
    audit.after(rig.model, rig.state);
  }
  ASSERT_EQ(rig.state.tools[kLeft].grasp.count, 0);
  EXPECT_GT(audit.most(), 0.1e-3);             // [J]
  EXPECT_LT(audit.created(), 0.05 * audit.most());
}

TEST(EnergyAudit, AToolThatPushesDoesTheWorkThatBendsAWall) {
  Pose beside{Vec3(-4e-3, 12e-3, kWallZ - 3e-3), Quat::Identity()};
  StepRig rig(wallParams(), kNeedleAway, beside);
  rig.input.tools[kLeft].jaw = 0.0;
  rig.run(10);
  EnergyAudit audit;
  for (int k = 0; k < 600; ++k) {
    beside.position.x() += 1e-5;               // [m]
    rig.input.tools[kLeft].pose = beside;
    audit.before(rig.state);
    rig.step();
    audit.after(rig.model, rig.state);
  }
  EXPECT_GT(audit.most(), 0.1e-3);             // [J]
  EXPECT_LT(audit.created(), 0.05 * audit.most());
}

}  // namespace
}  // namespace halsted::app
