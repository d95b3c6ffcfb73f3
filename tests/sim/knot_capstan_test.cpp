/// Euler and Eytelwein on a fixed cylinder: a thread that slides carries T exp(mu phi).
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "sim/portable_math.h"
#include "tests/sim/knot_rig.h"

namespace halsted {
namespace {

/// Two straight ends and `phi` of turn about the z axis with a little pitch, so that turns lie side by side.
std::vector<Vec3> wrapped(double phi, double radius, double segment) {   // [rad], [m], [m]
  const double straight = 10e-3, pitch = 0.6e-3;   // [m], [m per turn]
  const double total = 2.0 * straight + radius * phi;   // [m]
  return evenlySpaced([=](double u) -> Vec3 {
    const double s = u * total;                // [m]
    double angle = (s - straight) / radius, beyond = 0.0;   // [rad], [m]
    if (angle < 0.0) { beyond = s - straight; angle = 0.0; }
    if (angle > phi) { beyond = s - straight - radius * phi; angle = phi; }
    const Vec3 tangent(-std::sin(angle), std::cos(angle), 0.0);
    return radius * Vec3(std::cos(angle), std::sin(angle), 0.0) + beyond * tangent + Vec3(0.0, 0.0, pitch * angle / (2.0 * kPi));
  }, segment);
}

/// Ratio of the pull that makes the thread slide to the load on its other end.  [1]
double slidingRatio(double phi, double friction) {   // [rad], [1]
  const double radius = 3e-3, load = 0.5;            // [m], [N]
  SimParams p = knotThread();
  KnotRig rig(p, wrapped(phi, radius + p.thread.radius, p.thread.segmentLength));
  ThreadSolid post;
  post.a = post.fromA = Vec3(0, 0, -20e-3);
  post.b = post.fromB = Vec3(0, 0, 20e-3);
  post.radius = radius;
  post.friction = friction;
  rig.solids.push_back(post);
  const int last = rig.model.nodes - 4;
  const Vec3 ahead = (rig.state.position[last + 1] - rig.state.position[last]).normalized();
  const Vec3 behind = (rig.state.position[0] - rig.state.position[1]).normalized();
  rig.pull(0, load * behind);
  const std::size_t hand = rig.hold(last, 2e4);
  double sum = 0.0;                                  // [N]
  const int steps = 1200, measured = 400;
  for (int k = 0; k < steps; ++k) {
    rig.held[hand].anchor += 10e-3 * rig.dt * ahead;
    if (!rig.step()) return 0.0;
    if (k >= steps - measured) sum += rig.forceOf(hand).dot(ahead) / measured;
  }
  if (std::getenv("KNOT_VERBOSE")) std::printf("iterations per step %.2f, contacts %d\n", double(rig.iterations) / steps, rig.contacts.count);
  return sum / load;
}

class CapstanOnACylinder : public testing::TestWithParam<int> {};

TEST_P(CapstanOnACylinder, PullOverLoadIsTheExponentialOfFrictionTimesTurn) {
  const double phi = GetParam() * kPi / 180.0, friction = 0.2;   // [rad], [1]
  const double exact = std::exp(friction * phi), found = slidingRatio(phi, friction);   // [1]
  RecordProperty("relative_error", std::to_string(found / exact - 1.0));
  EXPECT_NEAR(found / exact, 1.0, 0.03) << found << " against " << exact;
  if (std::getenv("KNOT_VERBOSE")) std::printf("%d deg: %.4f exact %.4f error %.2f %%\n", GetParam(), found, exact, 100 * (found / exact - 1));
}

INSTANTIATE_TEST_SUITE_P(Degrees, CapstanOnACylinder, testing::Values(180, 360, 540));

}  // namespace
}  // namespace halsted
