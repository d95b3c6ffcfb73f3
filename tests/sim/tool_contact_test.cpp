/// A tool against the wall and a grasp of its edge, through the whole step.
#include <gtest/gtest.h>

#include "sim/tools/find_touch.h"
#include "tests/sim/press_rig.h"

namespace halsted {
namespace {

TEST(ToolContact, ForceIsWhatHoldsTheWallInStaticEquilibrium) {
  Press p;
  for (int k = 0; k < 300; ++k) p.to(pressing(20e-3 - 7e-5 * k));
  p.run(2000);
  const Vec3 force = p.onTissue(), held = p.footReaction();
  ASSERT_LT(p.tissueSpeed(), 1e-5);
  ASSERT_LT(force.x(), -0.1);
  RecordProperty("force_n", std::to_string(force.norm()));
  RecordProperty("foot_over_tool", std::to_string(held.x() / force.x()));
  EXPECT_LT((held - force).norm(), 0.01 * force.norm());
  EXPECT_LT((p.tool().force + force).norm(), 1e-12);         // and the hand feels its opposite
  EXPECT_LT((p.out.contact[kLeft].force - p.tool().force).norm(), 1e-12);
}

/// The simulated tool stands off the device by the force over the coupling.
TEST(ToolContact, ProxyStandsOffTheDeviceByTheForceOverTheCoupling) {
  Press p;
  for (int k = 0; k < 300; ++k) {
    p.to(pressing(20e-3 - 7e-5 * k));
    const Vec3 off = p.model.params.tools[kLeft].couplingStiffness * (p.tool().proxy.position - p.tool().device.position);
    ASSERT_LT((off - p.tool().force).norm(), 1e-9);
  }
}

TEST(ToolContact, NothingSticksOnRetreat) {
  Press p;
  for (int k = 0; k < 300; ++k) p.to(pressing(20e-3 - 7e-5 * k));
  p.run(300);
  for (int k = 300; k > 0; --k) {
    p.to(pressing(20e-3 - 7e-5 * k));
    for (int i = 0; i < p.tool().contactCount; ++i) ASSERT_GE(p.tool().contactForce[i].dot(p.tool().contactNormal[i]), 0.0);
    ASSERT_LE(p.onTissue().x(), 1e-12) << "the wall is drawn along";
  }
  EXPECT_EQ(p.tool().contactCount, 0);
  EXPECT_EQ(p.tool().force, Vec3::Zero());
  EXPECT_FALSE(p.out.contact[kLeft].touching);
  p.run(2000);
  EXPECT_LT(p.displacement(), 1e-6);
}

TEST(ToolContact, EveryContactRespectsItsFrictionCone) {
  Press p;
  for (int k = 0; k < 300; ++k) p.to(pressing(20e-3 - 7e-5 * k));
  const double mu = p.model.params.contact.toolTissueFriction;               // [1]
  double dragged = 0.0;                          // [1] largest ratio seen
  int seen = 0;
  for (int k = 0; k < 1500; ++k) {
    p.to(pressing(-1e-3, 5e-3 * std::sin(6.28e-3 * k)));
    for (int i = 0; i < p.tool().contactCount; ++i) {
      const Vec3 f = p.tool().contactForce[i], n = p.tool().contactNormal[i];
      const double normal = f.dot(n), tangential = (f - normal * n).norm();    // [N]
      ASSERT_LE(tangential, mu * normal + 1e-9);
      dragged = std::max(dragged, tangential / normal);
      ++seen;
    }
  }
  ASSERT_GT(seen, 1000);
  EXPECT_NEAR(dragged / mu, 1.0, 1e-6);          // and it does slide on the cone
}

TEST(ToolContact, TheOtherHandFeelsNothing) {
  Press p;
  for (int k = 0; k < 400; ++k) {
    p.to(pressing(20e-3 - 5.5e-5 * k));
    const LocalContact& other = p.out.contact[kRight];
    ASSERT_LT(other.force.norm(), 1e-9);
    ASSERT_LT(other.stiffness.norm(), 1e-9);
    ASSERT_FALSE(other.touching);
    ASSERT_EQ(other.planeCount, 0);
  }
  EXPECT_GT(p.tool().force.norm(), 0.1);
}

/// Jaws that are deep in the tissue at once, as those that opened there, let it out at a pace. Tissue that leaves them faster by itself needs no push:
/// pushed to go faster than it went in each step, it was flung out.
TEST(ToolContact, WhatLeavesAToolFastEnoughIsNotPushed) {
  SimParams soft = wallParams();
  soft.tissue.youngsModulus = 1e4;               // hardly slowed in a step
  double pushed[2];                              // [N]
  for (int leaving = 0; leaving < 2; ++leaving) {
    Press p(soft);
    p.run(2);                                    // the list of what is near is made anew in the step that follows
    ToolState& tool = p.state.tools[kLeft];
    const Pose deep = pressing(-1e-3);
    p.input.tools[kLeft].pose = tool.device = tool.proxy = deep;
    if (leaving)
      for (Vec3& v : p.state.tissue.velocity) v.x() = -0.3;      // [m/s]
    p.to(deep);
    pushed[leaving] = p.onTissue().norm();
  }
  EXPECT_GT(pushed[0], 5e-3);
  EXPECT_LT(pushed[1], 0.05 * pushed[0]);
}

/// A tool between contacts that push so hard from either side.
ToolState between(double left, double right) { // [N]
  ToolState t;
  t.contactForce[0] = left * Vec3::UnitX();
  t.contactForce[1] = -right * Vec3::UnitX();
  t.contactCount = 2;
  return t;
}

/// What contacts take back against each other is work that no hand does: wild hands with a shaft in a fold made 15 mJ of it at a time (`altemeier`).
TEST(Recovery, TakesBackLittleWhereTissuePushesAToolFromBothSides) {
  constexpr double kPace = 0.1e-3, kMost = 0.4e-3;   // [m], [J] a step
  EXPECT_EQ(recovered(between(0.0, 0.0)), kPace);
  EXPECT_EQ(recovered(between(2.0, 1.9)), kPace);
  for (const double push : {2.5, 8.0, 30.0}) EXPECT_NEAR(recovered(between(push, push)) * 2.0 * push, kMost, 1e-12);
  EXPECT_NEAR(recovered(between(30.0, 10.0)) * 20.0, kMost, 1e-12);   // ten of them are the hand's
}

/// Against a hand it is taken back at the whole pace, however hard that pushes: what it gives way by is its own work.
TEST(Recovery, TakesBackAtTheWholePaceAgainstAHand) {
  EXPECT_EQ(recovered(between(30.0, 0.0)), 0.1e-3);
}

/// Open jaws straddle the top edge from above.
Pose straddling(double rise) { return {Vec3(0.5 * kWallX, 12e-3, kWallZ - 2e-3 + rise), Quat::Identity()}; }   // [m]

struct EdgeGrasp : StepRig {
  EdgeGrasp() : StepRig(wallParams(), kNeedleAway, straddling(0.0)) { run(10); }
  void close() {
    for (int k = 0; k < 100; ++k) { input.tools[kLeft].jaw = 1.0 - 7e-3 * k; step(); }
  }
};

TEST(Grasp, HoldsTheEdgeAndLiftsItWithTheHand) {
  EdgeGrasp g;
  g.close();
  ASSERT_GT(g.state.tools[kLeft].grasp.count, 0);
  for (int k = 0; k < 200; ++k) { g.input.tools[kLeft].pose = straddling(1e-5 * k); g.step(); }
  g.run(500);
  EXPECT_LT(g.state.tools[kLeft].force.z(), -0.1);           // the wall pulls the hand back down
  const ToolState& t = g.state.tools[kLeft];
  const double slips = g.model.params.tools[kLeft].gripForce / t.grasp.count;   // [N] a point's share of the grip
  int holding = 0;
  for (int i = 0; i < t.grasp.count; ++i) {
    if (t.grasp.force[i].norm() > 0.999 * slips) continue;
    ++holding;
    const Vec3 held = pointOn(g.model.surface, g.state.tissue.position, t.grasp.triangle[i], t.grasp.weight[i]);
    EXPECT_LT((held - t.proxy.apply(t.grasp.local[i])).norm(), 1e-6);
  }
  EXPECT_GE(holding, 3);
}

TEST(Grasp, ReleaseReturnsTheTissueToRest) {
  EdgeGrasp g;
  g.close();
  for (int k = 0; k < 200; ++k) { g.input.tools[kLeft].pose = straddling(1e-5 * k); g.step(); }
  ASSERT_GT(g.displacement(), 0.2e-3);
  g.input.tools[kLeft].jaw = 1.0;
  g.step();
  EXPECT_TRUE(g.happened(EventKind::kTissueReleased));
  EXPECT_TRUE(g.out.contact[kLeft].puncture);    // the force may jump
  EXPECT_EQ(g.state.tools[kLeft].grasp.count, 0);
  for (int k = 0; k < 2000; ++k) { g.input.tools[kLeft].pose = straddling(2e-3 + 2e-5 * k); g.step(); }
  EXPECT_LT(g.displacement(), 1e-6);
  EXPECT_LT(g.tissueSpeed(), 1e-6);
  EXPECT_EQ(g.state.tools[kLeft].force, Vec3::Zero());
}

/// The coupling has no mass: without its lag the tool would be at the hand in one step, past all that lies on the way.
TEST(Grasp, AToolThatComesFreeFollowsItsHandAtTheSpeedOfOne) {
  constexpr double kFastest = 0.5;               // [m/s]
  EdgeGrasp g;
  g.close();
  for (int k = 0; k < 380; ++k) { g.input.tools[kLeft].pose = straddling(1e-5 * k); g.step(); }
  const ToolState& t = g.state.tools[kLeft];
  ASSERT_GT((t.proxy.position - t.device.position).norm(), 2.0 * kFastest * g.model.params.dt);
  g.input.tools[kLeft].jaw = 1.0;
  double most = 0.0;                             // [m]
  for (int k = 0; k < 20; ++k) {
    const Vec3 before = t.proxy.position;
    g.step();
    ASSERT_EQ(t.grasp.count, 0);
    most = std::max(most, (t.proxy.position - before).norm());
  }
  EXPECT_LT(most, 1.01 * kFastest * g.model.params.dt);
  EXPECT_EQ(t.lag, Vec3::Zero());
  EXPECT_LT((t.proxy.position - t.device.position).norm(), 1e-9);
}

TEST(Grasp, SlipsOutAboveTheGripForce) {
  EdgeGrasp g;
  g.close();
  ASSERT_GT(g.state.tools[kLeft].grasp.count, 0);
  double most = 0.0;                             // [N]
  for (int k = 0; k < 1000; ++k) {
    g.input.tools[kLeft].pose = straddling(1e-5 * k);
    g.step();
    double sum = 0.0;                            // [N]
    for (int i = 0; i < g.state.tools[kLeft].grasp.count; ++i) sum += g.state.tools[kLeft].grasp.force[i].norm();
    most = std::max(most, sum);
  }
  RecordProperty("most_n", std::to_string(most));
  EXPECT_LE(most, g.model.params.tools[kLeft].gripForce * (1.0 + 1e-9));
  EXPECT_GT(most, 0.5 * g.model.params.tools[kLeft].gripForce);
}

/// A slip is friction, not a spring: once it has slid, the tissue does not pull the hand back to where it was held first. Drawn back
/// by a fraction of the way that it slid, the hand feels nothing any more.
TEST(Grasp, AfterASlipItHoldsWhereItLies) {
  EdgeGrasp g;
  g.close();
  ASSERT_GT(g.state.tools[kLeft].grasp.count, 0);
  double rise = 0.0, most = 0.0;                 // [m] [N]
  const auto lift = [&](double by) {             // [m]
    rise += by;
    g.input.tools[kLeft].pose = straddling(rise);
    g.step();
    return -g.state.tools[kLeft].force.z();      // [N] the wall pulls the hand down
  };
  int slid = 0;                                  // steps
  for (int k = 0; k < 4000 && slid < 150 && g.state.tools[kLeft].grasp.count > 0; ++k) {
    const double before = most, force = lift(1e-5);
    most = std::max(most, force);
    slid = most > before + 1e-4 ? 0 : slid + 1;
  }
  ASSERT_EQ(slid, 150) << "1.5 mm under an even pull: it slides";
  const double stuck = rise;                     // [m]
  int back = 0;                                  // steps
  while (back < 2000 && lift(-1e-5) > 0.1 * most && g.state.tools[kLeft].grasp.count > 0) ++back;
  ASSERT_GT(g.state.tools[kLeft].grasp.count, 0);
  const double stretch = most / 1000.0 + 6e-3;   // [m] of coupling and wall under the grip force
  RecordProperty("back_mm", std::to_string((stuck - rise) * 1e3));
  RecordProperty("most_n", std::to_string(most));
  std::printf("slip: %.2f N, gone after %.2f mm back from %.2f mm\n", most, (stuck - rise) * 1e3, stuck * 1e3);
  EXPECT_LT(stuck - rise, stretch);
  EXPECT_LT(stuck - rise, stuck - 1e-3) << "the slip is not taken back";
}

/// Tissue drawn right through the jaws is let go, and is at rest again.
TEST(Grasp, LetsGoOfWhatSlipsOutOfTheJaws) {
  EdgeGrasp g;
  g.close();
  ASSERT_GT(g.state.tools[kLeft].grasp.count, 0);
  bool released = false;
  for (int k = 0; k < 3000; ++k) {
    g.input.tools[kLeft].pose = straddling(1e-5 * k);
    g.step();
    released = released || g.happened(EventKind::kTissueReleased);
  }
  EXPECT_TRUE(released);
  EXPECT_EQ(g.state.tools[kLeft].grasp.count, 0);
  EXPECT_EQ(g.state.tools[kLeft].force, Vec3::Zero());
  g.run(1500);
  EXPECT_LT(g.displacement(), 1e-6);
}

}  // namespace
}  // namespace halsted
