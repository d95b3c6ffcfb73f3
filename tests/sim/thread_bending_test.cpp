/// Thread that is bent harder than its yield moment keeps a set: the curvature it had less what springs back, M_y / EI.
#include <gtest/gtest.h>

#include "sim/strand/thread_bending.h"
#include "tests/sim/knot_rig.h"

namespace halsted {
namespace {

constexpr int kArcNodes = 9;                      // short: even the tightest arc is no full circle and does not meet itself

/// An arc in the plane x y from the origin, at first along x.  [1/m], [m]
std::vector<Vec3> arc(double curvature, double segment) {
  std::vector<Vec3> x{Vec3::Zero()};
  for (int i = 0; i + 1 < kArcNodes; ++i) {
    const double angle = curvature * segment * (i + 0.5);   // [rad]
    x.push_back(x.back() + segment * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  return x;
}

/// In the middle of the thread.  [1/m]
double curvatureOf(const std::vector<Vec3>& x) {
  const Vec3 a = x[kArcNodes / 2] - x[kArcNodes / 2 - 1], b = x[kArcNodes / 2 + 1] - x[kArcNodes / 2];
  return std::atan2(a.cross(b).norm(), a.dot(b)) / a.norm();
}

SimParams fineThread() { return knotThread(0.1e-3); }
double yieldCurvature() { return fineThread().thread.yieldMoment / fineThread().thread.bendingStiffness; }   // [1/m] 526

/// As hands have bent it that now let go.
struct Bent {
  KnotRig rig;
  explicit Bent(double curvature) : rig(fineThread(), arc(curvature, fineThread().thread.segmentLength)) {   // [1/m]
    takeSet(rig.model, arc(0.0, fineThread().thread.segmentLength), rig.state.position, rig.contacts.set);
  }
  double afterwards() {                        // [1/m] curvature once it has come to rest
    EXPECT_TRUE(rig.run(800));
    return curvatureOf(rig.state.position);
  }
};

TEST(ThreadBending, SpringsBackByItsYield) {
  for (double times : {1.2, 1.6, 2.4})         // [1] of the yield's curvature
    EXPECT_NEAR(Bent(times * yieldCurvature()).afterwards(), (times - 1.0) * yieldCurvature(), 0.03 * yieldCurvature()) << times;
}

TEST(ThreadBending, BelowItsYieldIsElastic) {
  Bent bent(0.9 * yieldCurvature());
  EXPECT_LT(bent.afterwards(), 0.01 * yieldCurvature());
  for (const Vec3& set : bent.rig.contacts.set) EXPECT_EQ(set, Vec3::Zero());
}

TEST(ThreadBending, ASetTurnsWithTheThread) {
  Bent bent(2.0 * yieldCurvature());
  const std::vector<Vec3> set = bent.rig.contacts.set;
  ASSERT_GT(set[kArcNodes / 2].norm(), 0.0);
  const Quat turn(Eigen::AngleAxisd(0.8, Vec3::UnitZ()));   // in its plane, where the smallest rotation is the whole one
  std::vector<Vec3> turned = bent.rig.state.position;
  for (Vec3& x : turned) x = turn * x;
  takeSet(bent.rig.model, bent.rig.state.position, turned, bent.rig.contacts.set);
  for (std::size_t i = 0; i < set.size(); ++i) EXPECT_LT((bent.rig.contacts.set[i] - turn * set[i]).norm(), 1e-9 * set[i].norm() + 1e-15);
}

}  // namespace
}  // namespace halsted
