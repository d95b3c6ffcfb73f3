/// How much of a Newton correction touching thread takes.
#include <gtest/gtest.h>

#include "sim/strand/step_share.h"
#include "tests/sim/knot_rig.h"

namespace halsted {
namespace {

constexpr double kStiffness = 3e4, kGap = 10e-6, kWay = 100e-6;   // [N/m], [m] to a solid, [m] that the model wants to go toward it
constexpr double kForce = 2e-3;                // [N] that drives it

/// One sample of straight thread, a gap above a solid that is wide enough to answer linearly, and a correction that goes down on it.
struct Falling {
  KnotRig rig{knotThread(), evenlySpaced({Vec3::Zero(), Vec3(6e-3, 0.0, 0.0)}, knotThread().thread.segmentLength)};
  double gain = 0.0;                           // [J]

  explicit Falling(double gap) {               // [m]
    rig.work.iterate = rig.state.position;
    rig.work.load.assign(rig.work.rhs.size(), 0.0);
    std::fill(rig.work.rhs.begin(), rig.work.rhs.end(), 0.0);
    for (int i = 0; i < rig.model.nodes; ++i) rig.work.rhs[3 * i + 2] = -kWay;
    rig.work.load[3 * 5 + 2] = -kForce;
    gain = kForce * kWay;
    TouchingPoint c;
    c.solid = true;
    c.normal = Vec3::UnitZ();
    c.reach = 2e-3;
    c.sample = curveWeights(5, 0.5);
    c.anchor = curvePoint(rig.work.iterate, c.sample) - (c.reach + gap) * c.normal;
    c.start = (c.reach + gap) * c.normal;
    c.stiffness = kStiffness;
    rig.contactWork.points.assign(1, c);
  }
  double take() { return takeCorrection(rig.work, rig.contactWork); }
};

TEST(StepShare, WhatMeetsNothingIsTakenWhole) {
  Falling f(2.0 * kWay);
  EXPECT_EQ(f.take(), 1.0);
  EXPECT_EQ(f.rig.work.rhs[3 * 5 + 2], -kWay);
}

/// Along the correction: (share - 1) gain + way k (share way - gap) = 0.
TEST(StepShare, WhatWouldGoThroughASolidStopsWhereItsPushBalancesTheRest) {
  Falling f(kGap);
  const double share = (f.gain + kWay * kStiffness * kGap) / (f.gain + kWay * kStiffness * kWay);   // [1]
  const double taken = f.take();
  EXPECT_NEAR(taken, share, 1e-3);             // 0.1 um
  EXPECT_DOUBLE_EQ(f.rig.work.rhs[3 * 5 + 2], -taken * kWay);
}

TEST(StepShare, AHandTakesTheSameShare) {
  Falling f(kGap);
  f.rig.contactWork.hands.tool[0].correction = Vec3(1e-3, 0.0, 0.0);
  const double taken = f.take();
  EXPECT_LT(taken, 0.2);
  EXPECT_DOUBLE_EQ(f.rig.contactWork.hands.tool[0].shift.x(), taken * 1e-3);
}

}  // namespace
}  // namespace halsted
