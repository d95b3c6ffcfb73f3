/// What lies deep inside a tool is let out at a pace.
#include <gtest/gtest.h>

#include "tests/sim/press_rig.h"

namespace halsted {
namespace {

/// Jaws that are deep in the tissue at once, as those that opened there, let it out at a pace. Tissue that leaves them faster by itself needs no push:
/// pushed to go faster than it went in each step, it was flung out.
TEST(Recovery, WhatLeavesAToolFastEnoughIsNotPushed) {
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

/// Against what holds it there it is let out slower, so that no contact does more than 0.2 mJ of work by it in a step.
TEST(Recovery, WhatPushesHardTakesBackLess) {
  SimParams stiff = wallParams();
  stiff.tissue.youngsModulus = 5e6;              // pushes with more than the two newtons up to which all is let out
  stiff.tools[kLeft].couplingStiffness = 2e4;    // [N/m] a hand that does not give way
  Press p(stiff);
  p.run(2);                                      // the list of what is near is made anew in the step that follows
  ToolState& tool = p.state.tools[kLeft];
  const Pose deep = pressing(-1e-3);
  p.input.tools[kLeft].pose = tool.device = tool.proxy = deep;
  double hardest = 0.0, most = 0.0;              // [N], [J] of one contact in a step
  for (int k = 0; k < 40; ++k) {
    const ToolState before = tool;
    const auto tissue = p.state.tissue.position;
    p.to(deep);
    for (int i = 0; i < before.contactCount; ++i) {
      const Vec3 n = before.contactNormal[i], f = before.contactForce[i];
      const auto where = [&](const auto& x) { return pointOn(p.model.surface, x, before.contactTriangle[i], before.contactWeight[i]); };
      const double apart = n.dot(where(p.state.tissue.position) - where(tissue) - (tool.proxy.position - before.proxy.position));   // [m]
      hardest = std::max(hardest, f.dot(n));
      most = std::max(most, f.dot(n) * apart);
    }
  }
  RecordProperty("hardest_n", std::to_string(hardest));
  RecordProperty("most_j", std::to_string(most));
  EXPECT_GT(hardest, 2.0);
  EXPECT_LT(most, 0.22e-3);                      // 0.34 mJ where all take back alike
}

}  // namespace
}  // namespace halsted
