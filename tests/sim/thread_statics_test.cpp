/// The thread at rest against closed forms: stretch, catenary, bent beams (physics.md V4, V5, B3). Static states are reached by letting
/// a damped thread settle at the scene's own step.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/strand_rig.h"

namespace halsted {
namespace {

SimParams settling(int nodes, double length) {   // length [m]
  SimParams p = threadParams(nodes, length);
  p.thread.damping = 200.0;                    // a static state does not know damping
  return p;
}

TEST(Thread, LoadedWithOneNewtonStretchesAsItsAxialStiffnessSays) {
  SimParams p = settling(175, 0.348);
  StrandRig rig(p);
  rig.clampNeedle();
  rig.pull(0.0, Vec3(0, -1, 0));
  ASSERT_TRUE(rig.run(400));
  const double stretch = rig.length() / rig.model.length - 1.0;                // [1]
  RecordProperty("stretch", std::to_string(stretch));
  EXPECT_LT(stretch, 1e-3);
  EXPECT_NEAR(stretch * p.thread.axialStiffness, 1.0, 1e-6);
  for (double tension : rig.state.tension) EXPECT_NEAR(tension, 1.0, 1e-4);    // [N] the hinge at the crimp feels the stretch
}

/// V4: a chain of 101 at true mass, as good as inextensible, loaded with 1 N: the direct solve leaves no stretch at all.
TEST(Thread, TheDirectSolveHoldsAnInextensibleChain) {
  SimParams p = settling(101, 0.2);
  p.thread.axialStiffness = 1e10;
  StrandRig rig(p);
  rig.clampNeedle();
  rig.pull(0.0, Vec3(0, -1, 0));
  ASSERT_TRUE(rig.run(50));
  EXPECT_LT(std::fabs(rig.length() / rig.model.length - 1.0), 1e-9);
}

/// a of the catenary y = a cosh(x / a) with this length and span [m], by bisection of L = 2 a sinh(span / 2 a).
double catenaryScale(double length, double span) {   // [m]
  double low = 0.05 * span, high = 100.0 * span;   // [m]
  for (int k = 0; k < 200; ++k) {
    const double a = 0.5 * (low + high);         // [m]
    (2.0 * a * std::sinh(0.5 * span / a) > length ? low : high) = a;
  }
  return low;
}

/// V5: 101 nodes between two pins at 0.6 of the length.
TEST(Thread, HangsAsACatenary) {
  const double length = 0.2, span = 0.12;        // [m]
  SimParams p = settling(101, length);
  p.thread.damping = 20.0;
  p.thread.bendingStiffness = 0.0;
  p.gravity = Vec3(0, -9.81, 0);
  StrandRig rig(p);
  const Vec3 swage = rig.state.position.back();
  const double half = 0.5 * length, down = std::sqrt(half * half - 0.25 * span * span);   // [m] starts as a V
  for (int i = 0; i < 101; ++i) {
    const double s = i * rig.model.segment, u = s < half ? s : length - s;     // [m]
    const double x = s < half ? -span + 0.5 * span * s / half : -0.5 * span * (length - s) / half;   // [m]
    rig.state.position[i] = swage + Vec3(x, -down * u / half, 0.0);
  }
  rig.hold(0.0);
  rig.hold(length);
  ASSERT_TRUE(rig.run(4000));
  const double a = catenaryScale(length, span);  // [m]
  const double sag = a * (std::cosh(0.5 * span / a) - 1.0);                    // [m]
  double lowest = 0.0;                           // [m]
  for (const Vec3& x : rig.state.position) lowest = std::max(lowest, swage.y() - x.y());
  RecordProperty("sag_over_catenary", std::to_string(lowest / sag));
  EXPECT_NEAR(lowest / sag, 1.0, 3e-3);
  EXPECT_LT(rig.fastest(), 1e-4);
}

class BentThread : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Nodes, BentThread, testing::Values(20, 80));

/// P L^3 / (3 E I), clamped in the crimp, whatever the number of nodes.
TEST_P(BentThread, ClampedAtTheNeedleBendsAsACantilever) {
  const double length = 0.04, wanted = 4e-4;     // [m] one per cent of the length: small
  const SimParams p = settling(GetParam(), length);
  StrandRig rig(p);
  rig.clampNeedle();
  const double load = 3.0 * p.thread.bendingStiffness * wanted / (length * length * length);   // [N]
  rig.pull(0.0, Vec3(0, 0, load));
  ASSERT_TRUE(rig.run(3000));
  const double tip = rig.state.position.front().z();                           // [m]
  RecordProperty("deflection_over_beam", std::to_string(tip / wanted));
  EXPECT_NEAR(tip / wanted, 1.0, 0.02);
}

/// P L^3 / (48 E I): supported at both ends, loaded in the middle.
TEST_P(BentThread, SupportedAtBothEndsBendsAsABeam) {
  const double length = 0.04, wanted = 4e-4;     // [m]
  const SimParams p = settling(GetParam(), length);
  StrandRig rig(p);
  Mat3 across = StrandRig::kHold * Mat3::Identity();
  across(1, 1) = 1e-3;                           // free along the thread, so that no membrane force arises
  rig.hold(0.0, across);
  rig.hold(length);
  rig.pull(0.5 * length, Vec3(0, 0, 48.0 * p.thread.bendingStiffness * wanted / (length * length * length)));
  ASSERT_TRUE(rig.run(3000));
  const double middle = strandPoint(rig.model, rig.state, 0.5 * length).z();   // [m]
  RecordProperty("deflection_over_beam", std::to_string(middle / wanted));
  EXPECT_NEAR(middle / wanted, 1.0, 0.02);
}

/// A strand between two clamps is pulled straight by its own bending stiffness only if a straight thread has one (physics.md A1 a).
TEST(Thread, AStraightThreadResistsTheSmallestBend) {
  SimParams p = settling(40, 0.04);
  StrandRig rig(p);
  rig.clampNeedle();
  const double load = 1e-9;                      // [N]
  rig.pull(0.0, Vec3(0, 0, load));
  ASSERT_TRUE(rig.run(3000));
  const double once = rig.state.position.front().z();                          // [m]
  rig.held.back().force0 *= 2.0;
  ASSERT_TRUE(rig.run(3000));
  EXPECT_GT(once, 0.0);
  EXPECT_NEAR(rig.state.position.front().z() / once, 2.0, 1e-3);
}

}  // namespace
}  // namespace halsted
