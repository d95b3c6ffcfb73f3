/// The drag with which a step of touching thread is solved again.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/strand/strand_trust.h"
#include "tests/sim/knot_rig.h"

namespace halsted {
namespace {

KnotRig straightThread() { return {knotThread(), evenlySpaced({Vec3::Zero(), Vec3(20e-3, 0.0, 0.0)}, knotThread().thread.segmentLength)}; }

/// Thread that strays in every solve of every step, as between contacts which open and close without end.
TEST(StrandTrust, ThreadThatNeverSettlesIsNotPinnedInSpace) {
  KnotRig rig = straightThread();
  ThreadTouch touch{rig.contacts, rig.contactWork};
  bool slower = true;
  for (int k = 0; k < 100; ++k) {
    beginTouch(rig.model, rig.state, rig.dt, touch);
    std::fill(rig.work.rhs.begin(), rig.work.rhs.end(), 1e-3);   // [m] the last correction
    slower = mustSlow(rig.model, rig.state, rig.work, false, touch);
    for (int attempt = 0; slower && attempt < 5; ++attempt) slower = mustSlow(rig.model, rig.state, rig.work, false, touch);
  }
  double pull = 0.0;                           // [N] on one node that is drawn at 0.1 m/s
  for (int i = 0; i < rig.model.nodes; ++i) pull = std::max(pull, 0.1 * rig.model.mass[i] * rig.contacts.drag[i]);
  RecordProperty("pull", std::to_string(pull));
  EXPECT_GT(pull, 0.01);                       // it is slowed
  EXPECT_LT(pull, 1.0);                        // thread of this kind breaks at 17.4 N
  EXPECT_FALSE(slower);                        // and is taken as it is, when more would be too much
}

}  // namespace
}  // namespace halsted
