/// Jaws that close where more than one strand of thread lies between them.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/step_rig.h"

namespace halsted {
namespace {

constexpr double kMostSqueeze = 25.0;          // [N] of both jaws together; a hand closes them with less

/// The left hand's open jaws stand away from the wall, thread lies twice between them: out at 2 mm from the tips, back at 5 mm.
struct TwoStrands : StepRig {
  double hardest = 0.0;                        // [N] of either jaw on the thread, ever

  static SimParams params() {
    SimParams p = wallParams();
    p.thread.nodes = 100;
    p.thread.segmentLength = 1e-3;
    p.thread.knots = true;
    p.thread.bendingStiffness = 1e-10;         // limp, as in honey: it stays as it is laid
    p.thread.damping = 3000.0;
    return p;
  }
  TwoStrands() : StepRig(params(), kNeedleAway) {
    const Vec3 at(-60e-3, 12e-3, 40e-3);       // [m] the tips
    input.tools[kLeft].pose = state.tools[kLeft].device = state.tools[kLeft].proxy = Pose{at, Quat::Identity()};
    input.tools[kLeft].jaw = state.tools[kLeft].jaw = 1.0;
    const Vec3 corners[] = {{0, -20e-3, 2e-3}, {0, 20e-3, 2e-3}, {0, 20e-3, 5e-3}, {0, -60e-3, 5e-3}};
    std::size_t leg = 0;
    double before = 0.0;                       // [m] of the path up to this leg
    for (int i = 0; i < model.strand.nodes; ++i) {
      while (leg < 2 && model.strand.place[i] > before + (corners[leg + 1] - corners[leg]).norm()) {
        before += (corners[leg + 1] - corners[leg]).norm();
        ++leg;
      }
      state.strand.position[i] = at + corners[leg] + (model.strand.place[i] - before) * (corners[leg + 1] - corners[leg]).normalized();
    }
    ToolState& driver = state.tools[kRight];
    driver.holdsNeedle = driver.closed = driver.ratchet = false;
    driver.jaw = input.tools[kRight].jaw = 1.0;
    state.strand.needle.position += state.strand.position.back() - state.strand.needle.apply(model.strand.arcPoint.front());
    run(5);
  }
  void close() {
    for (int k = 1; k <= 300; ++k) {
      input.tools[kLeft].jaw = std::max(0.0, 1.0 - k / 200.0);
      step();
      double squeeze = 0.0;                    // [N]
      for (int i = 0; i < state.threadContacts.count; ++i)
        if (state.threadContacts.contacts[i].partner < 0) squeeze += state.threadContacts.contacts[i].normalForce;
      hardest = std::max(hardest, squeeze);
    }
  }
};

TEST(Jaws, RestOnWhatLiesBetweenThemInsteadOfCrushingIt) {
  TwoStrands w;
  w.close();
  ASSERT_TRUE(w.finite());
  EXPECT_GE(w.state.tools[kLeft].threadCoordinate, 0.0) << "one strand is held";
  EXPECT_GT(w.hardest, 0.5) << "the other is pressed";
  EXPECT_LT(w.hardest, kMostSqueeze);
  EXPECT_GT(w.state.tools[kLeft].jaw, 0.0);
  std::printf("two strands between the jaws: %.1f N, jaws %.3f open\n", w.hardest, w.state.tools[kLeft].jaw);
}

/// Thread is held where the jaws close on it. Drawn to their tips at once, 1.5 mm of thread would be flung by several newtons.
TEST(Jaws, HoldThreadAsDeepAsItLies) {
  TwoStrands w;
  double tension = 0.0;                        // [N]
  for (int k = 1; k <= 300; ++k) {
    w.input.tools[kLeft].jaw = std::max(0.0, 1.0 - k / 200.0);
    w.step();
    tension = std::max(tension, *std::max_element(w.state.strand.tension.begin(), w.state.strand.tension.end()));
  }
  const ToolState& t = w.state.tools[kLeft];
  ASSERT_GE(t.threadCoordinate, 0.0);
  const Vec3 held = t.proxy.inverseApply(strandPoint(w.model.strand, w.state.strand, t.threadCoordinate));   // [m]
  EXPECT_LT(held.head<2>().norm(), 0.1e-3);
  EXPECT_GT(held.z(), 1.5e-3);
  EXPECT_LT(tension, 0.5);
  std::printf("held %.2f mm from the tips, at most %.2f N in the thread as the jaws close\n", 1e3 * held.z(), tension);
}

TEST(Jaws, CloseWhereNothingLiesBetweenThem) {
  TwoStrands w;
  w.input.tools[kLeft].pose.position.z() += 60e-3;   // back along its shaft, off the thread
  w.run(50);
  w.close();
  EXPECT_EQ(w.state.tools[kLeft].threadCoordinate, -1.0);
  EXPECT_EQ(w.state.tools[kLeft].jaw, 0.0);
  EXPECT_EQ(w.hardest, 0.0);
}

}  // namespace
}  // namespace halsted
