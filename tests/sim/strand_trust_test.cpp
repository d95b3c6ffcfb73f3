/// The drag with which a step of touching thread is solved again.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/strand/strand_trust.h"
#include "tests/sim/knot_rig.h"

namespace halsted {
namespace {

constexpr double kDrag = 5e7;                  // [1/s] as much as a node ever has

KnotRig straightThread() { return {knotThread(), evenlySpaced({Vec3::Zero(), Vec3(20e-3, 0.0, 0.0)}, knotThread().thread.segmentLength)}; }

/// One step of thread with this drag at every node.
void slowedStep(KnotRig& rig) {
  std::fill(rig.contacts.drag.begin(), rig.contacts.drag.end(), kDrag / 0.7);   // the step itself lets it fade
  ASSERT_TRUE(rig.step());
}

/// Thread that strays in every solve of every step, as between contacts which open and close without end.
TEST(StrandTrust, ThreadThatNeverSettlesIsTakenAsItIsInTheEnd) {
  KnotRig rig = straightThread();
  ThreadTouch touch{rig.contacts, rig.contactWork};
  bool slower = true;
  for (int k = 0; k < 100; ++k) {
    beginTouch(rig.model, rig.state, rig.dt, touch);
    std::fill(rig.work.rhs.begin(), rig.work.rhs.end(), 1e-3);   // [m] the last correction
    slower = mustSlow(rig.model, rig.state, rig.work, false, touch);
    for (int attempt = 0; slower && attempt < 5; ++attempt) slower = mustSlow(rig.model, rig.state, rig.work, false, touch);
  }
  EXPECT_GT(rig.contacts.drag[10], 1e3);       // [1/s] it is slowed
  EXPECT_FALSE(slower);
}

TEST(StrandTrust, ThreadThatMovesAsAWholeIsNotHeldBack) {
  KnotRig rig = straightThread();
  const Vec3 way(0.06, 0.08, 0.0);             // [m/s]
  std::fill(rig.state.velocity.begin(), rig.state.velocity.end(), way);
  rig.state.needleVelocity = way;
  for (int k = 0; k < 20; ++k) slowedStep(rig);
  const double left = std::exp(-rig.model.damping * 20 * rig.dt);   // [1] of its speed: its own damping takes the rest
  EXPECT_NEAR(rig.state.velocity[10].norm(), left * way.norm(), 0.01 * way.norm());
  EXPECT_LT(*std::max_element(rig.state.tension.begin(), rig.state.tension.end()), 1e-3);   // [N]
}

/// A wave two nodes long, as thread buckles that snaps.
TEST(StrandTrust, NodesThatMoveAgainstTheirNeighboursAreHeldBack) {
  KnotRig rig = straightThread();
  for (int i = 0; i < rig.model.nodes; ++i) rig.state.velocity[i] = Vec3(0.0, i % 2 ? 0.1 : -0.1, 0.0);   // [m/s]
  slowedStep(rig);
  EXPECT_LT(rig.state.velocity[10].norm(), 1e-3);   // [m/s]
}

}  // namespace
}  // namespace halsted
