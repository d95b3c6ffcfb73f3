/// What has been tied is written down from look to look.
#include <gtest/gtest.h>

#include "sim/suture/knot_watch.h"
#include "tests/sim/knot_tie.h"
#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

constexpr int kThreadNodes = 600;

/// Thread that touches itself and lies as a test says.
struct Watched {
  StepRig rig;

  Watched() : rig(params(), kNeedleAway) {
    rig.state.knot.watched = true;
    rig.state.step = 0;
    rig.state.threadContacts.count = 1;
    rig.state.threadContacts.contacts[0].partner = 0;
  }
  static SimParams params() {
    SimParams p = wallParams();
    p.thread.knots = true;
    p.thread.nodes = kThreadNodes;
    p.thread.segmentLength = 0.3e-3;
    return p;
  }
  const KnotState& look(const std::vector<Vec3>& curve) {   // [m]
    rig.out = StepOutput{};
    for (int i = 0; i < kThreadNodes; ++i) {
      const double at = i * (curve.size() - 1.0) / (kThreadNodes - 1.0);   // [1]
      const std::size_t k = std::min(static_cast<std::size_t>(at), curve.size() - 2);
      rig.state.strand.position[i] = curve[k] + (at - k) * (curve[k + 1] - curve[k]);
    }
    watchKnots(rig.model, rig.state, rig.out);
    return rig.state.knot;
  }
};

std::vector<Vec3> surgeonsBegun() { return LooseKnot(std::vector{5, -3}, {}).nodes(0.3e-3); }

/// Two throws on one thread, beside each other: not a knot of throws on one loop, so it is not read.
std::vector<Vec3> unreadable() {
  std::vector<Vec3> x = LooseKnot(std::vector{3}, {}).nodes(0.3e-3);
  const std::vector<Vec3> second = x;
  const Vec3 shift = x.back() - second.front() + Vec3(-5e-3, 0.0, 0.0);
  for (const Vec3& p : second) x.push_back(p + shift + Vec3(0.0, 30e-3, 0.0));
  return x;
}

std::vector<Vec3> straight() { return {Vec3::Zero(), Vec3(0.1, 0.0, 0.0)}; }

TEST(KnotWatch, WritesDownWhatIsTiedAndUntied) {
  Watched w;
  EXPECT_EQ(w.look(surgeonsBegun()).throws, 2);
  EXPECT_TRUE(w.rig.state.knot.complete);
  EXPECT_EQ(locks(w.rig.state.knot), 1);
  EXPECT_TRUE(w.rig.happened(EventKind::kThrowTied));
  EXPECT_EQ(w.look(straight()).throws, 0);
  EXPECT_TRUE(w.rig.happened(EventKind::kThrowLost));
}

TEST(KnotWatch, LeavesTheLastReadingWhileNoneCanBeTaken) {
  Watched w;
  const KnotState read = w.look(surgeonsBegun());
  const KnotState after = w.look(unreadable());
  EXPECT_EQ(after.throws, read.throws);
  EXPECT_EQ(after.turns, read.turns);
  EXPECT_EQ(after.sense, read.sense);
  EXPECT_EQ(w.rig.out.eventCount, 0);
  EXPECT_EQ(w.look(straight()).throws, 0);
}

/// Nothing was read before: then what is seen of it is not called tied.
TEST(KnotWatch, TakesNoPartOfWhatItCannotReadForTied) {
  Watched w;
  EXPECT_EQ(w.look(unreadable()).throws, 0);
  EXPECT_FALSE(w.rig.state.knot.complete);
}

}  // namespace
}  // namespace halsted
