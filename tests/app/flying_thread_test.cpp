/// Thread thrown at bowel ends faster than any hand moves: it meets the bowel that it flies to, and the edge that it flies over.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/step.h"
#include "sim/suture/strand_sample.h"
#include "tests/app/abuse_watch.h"
#include "tests/app/scenario_for_tests.h"
#include "tests/sim/knot_rig.h"

namespace halsted::app {
namespace {

/// Two ends side by side; the thread flies straight, its needle in nobody's hand.
struct Thrown {
  const Scenario scenario = scenarioFromFile(testing::sourceFolder() + "/scenes/stay/expert.toml", {"thread.assist=knot"});
  const Model& model = scenario.model;
  Lockstep run{scenario};
  State& state = run.state();
  StepInput input;
  StepOutput out;
  ThreadDepth worst;
  const Opening& end = model.bowels.opening[1];
  const double radius = (model.mesh.vertices[model.bowels.rim[1].front()] - end.centre).norm();   // [m]

  Thrown() {
    for (int hand = 0; hand < kHands; ++hand) {
      ToolState& tool = state.tools[hand];
      tool.holdsNeedle = tool.ratchet = tool.closed = false;
      input.tools[hand].pose = tool.device = tool.proxy = {Vec3(0.3 * (hand == kLeft ? -1.0 : 1.0), 0.3, 0.3), Quat::Identity()};
      input.tools[hand].jaw = tool.jaw = 1.0;
    }
  }
  /// Its tail at `tail` [m], thrown with `velocity` [m/s]; it knows of no tissue but a vertex of the bowel `known`, and one of `other`, if that is not -1.
  void lay(const Vec3& tail, const Vec3& along, const Vec3& velocity, int known, int other = -1) {
    StrandState& s = state.strand;
    for (int i = 0; i < model.strand.nodes; ++i) {
      s.position[i] = tail + model.strand.place[i] * along;
      s.velocity[i] = velocity;
    }
    s.needle = KnotRig::needlePose(model.strand, s.position);
    s.needleVelocity = velocity;
    std::fill(s.nearVertex.begin(), s.nearVertex.end(), model.bowels.rim[known].front());
    if (other >= 0) std::fill(s.otherVertex.begin(), s.otherVertex.end(), model.bowels.rim[other].front());
  }
  /// At rest over the bowel's top, `off` [m] its surface, every segment there stretched [1]; from 40 degrees on either side it leads straight up.
  void span(double off, double stretch) {
    StrandState& s = state.strand;
    const double r = radius + off, most = 0.7;   // [m], [rad]
    const Vec3 middle = end.centre - 10e-3 * end.axis;
    for (int i = 0; i < model.strand.nodes; ++i) {
      const double along = model.strand.place[i] - 0.5 * model.strand.length;   // [m] from the top
      const double angle = std::clamp(stretch * along / r, -most, most);        // [rad]
      const double rest = std::fabs(along) - most * r / stretch;                // [m] beyond
      s.position[i] = middle + r * std::cos(angle) * end.up + r * std::sin(angle) * end.right + std::fmax(0.0, rest) * end.up;
      s.velocity[i].setZero();
    }
    s.needle = KnotRig::needlePose(model.strand, s.position);
    std::fill(s.nearVertex.begin(), s.nearVertex.end(), model.bowels.rim[1].front());
  }
  void fly(int steps) {
    for (int k = 0; k < steps; ++k) {
      step(model, input, state, out);
      const ThreadDepth now = threadDepth(model, state);
      worst.tissue = std::max(worst.tissue, now.tissue);
      worst.through = std::max(worst.through, now.through);
    }
    std::printf("at most %.2f mm deep in tissue, %d times through a wall\n", 1e3 * worst.tissue, worst.through);
  }
};

/// Across both bowels from above. It knew of one of them only, and would have flown 30 mm, through the other, before it looked for it.
TEST(FlyingThread, MeetsTheBowelThatItFliesTo) {
  Thrown t;
  const Opening& o = t.end;
  t.lay(o.centre - 10e-3 * o.axis + (t.radius + 8e-3) * o.up - 0.1 * o.right, o.right, -1.0 * o.up, 0);
  t.fly(60);
  EXPECT_LT(t.worst.tissue, 1e-3);
  EXPECT_EQ(t.worst.through, 0);
}

/// Between two searches, too, thread meets the bowel whose surface is nearer. Known by the other alone it sank in for up to 32 steps.
TEST(FlyingThread, MeetsTheNearerOfTwoBowelsThatItKnows) {
  Thrown t;
  const Opening& o = t.end;
  t.lay(o.centre - 10e-3 * o.axis + (t.radius + 1.5e-3) * o.up - 0.1 * o.right, o.right, Vec3::Zero(), 0, 1);
  StrandState& s = t.state.strand;
  const int node = threadSpot(t.model.strand, 0.1).node;         // over the top
  t.state.step = static_cast<std::uint64_t>(node) + 1;           // not when it is searched for
  const SurfacePoint near = nearTissue(t.model, sampleAt(t.model, s, node), t.state);
  ASSERT_GE(near.triangle, 0);
  const std::vector<int>& bowel = t.model.bowels.of;
  EXPECT_EQ(bowel[t.model.surface.triangles[near.triangle][0]], 1);
  EXPECT_LT(near.distance, 1.5e-3);
  EXPECT_GT(near.distance, 0.0);
  EXPECT_EQ(bowel[s.nearVertex[node]], 1);
  EXPECT_EQ(bowel[s.otherVertex[node]], 0);
}

/// Against the edge from the front, its tail in front of the lumen, in many places of its nodes: none of it stays in the wall.
TEST(FlyingThread, IsStoppedByTheEdgeThatItFliesOver) {
  for (const double slant : {-0.7, -0.35, 0.0, 0.35, 0.7})       // [1] of the thread out of the plane of the edge
    for (const double before : {9.0e-3, 9.5e-3, 10.0e-3, 10.5e-3}) {   // [m] of thread before the edge
      Thrown t;
      const Opening& o = t.end;
      const Vec3 along = (o.up + slant * o.axis).normalized();
      t.lay(o.centre + 4e-3 * o.axis + t.radius * o.up - before * along, along, -0.9 * o.axis, 1);
      t.fly(30);
      EXPECT_LT(t.worst.tissue, 1e-3) << slant << " " << before;
      EXPECT_EQ(threadDepth(t.model, t.state).through, 0) << slant << " " << before;
    }
}

/// A step takes a node to where another face is nearer than the edge that it flew into: it was pushed out of that one, on through the wall. All
/// of these throws got through, two of them for good.
TEST(FlyingThread, GoesBackOutOfTheFaceThatItMet) {
  struct Throw { double speed, slant, before; };                 // [m/s], [1], [m]
  for (const Throw& a : {Throw{0.6, 0.7, 17.6e-3}, Throw{0.6, 1.0, 16.0e-3}, Throw{1.5, -1.0, 19.2e-3}, Throw{1.5, -0.7, 18.4e-3}, Throw{1.5, 0.7, 7.2e-3}, Throw{1.5, 0.7, 20.0e-3}}) {
    Thrown t;
    const Opening& o = t.end;
    const Vec3 along = (o.up + a.slant * o.axis).normalized();
    t.lay(o.centre + 4e-3 * o.axis + t.radius * o.up - a.before * along, along, -a.speed * o.axis, 1);
    t.fly(30);
    EXPECT_EQ(t.worst.through, 0) << a.speed << " " << a.slant << " " << a.before;
  }
}

/// At rest over a bowel, 1 mm off it, and stretched: within a step it snaps to where its own pull takes it. Inertia took it nowhere, so nothing was known to be
/// in its way, and it went through the wall.
TEST(FlyingThread, MeetsTheWallThatItsOwnPullTakesItTo) {
  Thrown t;
  t.span(1e-3, 1.3);
  t.fly(20);
  EXPECT_LT(t.worst.tissue, 0.8e-3);
  EXPECT_EQ(t.worst.through, 0);
}

}  // namespace
}  // namespace halsted::app
