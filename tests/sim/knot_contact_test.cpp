/// Thread against thread: nothing passes through, no energy comes from nowhere, friction obeys Coulomb, thread breaks.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "sim/strand/knot_diagram.h"
#include "tests/sim/knot_tie.h"

namespace halsted {
namespace {

/// One thread whose second arm lies a millimetre above its first, at right angles.
struct CrossedArms {
  KnotRig rig;
  std::vector<int> lower, upper;               // nodes of the arms
  std::array<std::size_t, 2> hands{};

  explicit CrossedArms(double dt, double shift) : rig(knotThread(), curve(shift)) {   // [s], [m]
    rig.dt = dt;
    for (int i = 0; i < rig.model.nodes; ++i) {
      const Vec3& x = rig.state.position[i];
      if (std::fabs(x.z()) < 1e-9 && std::fabs(x.y()) < 1e-9) lower.push_back(i);
      if (std::fabs(x.x() - shift) < 1e-9 && std::fabs(x.y() - 1e-3) < 1e-9) upper.push_back(i);
    }
    rig.hold(lower[2], 1e4);
    rig.hold(lower[lower.size() - 3], 1e4);
    hands = {rig.hold(upper[2], 1e4), rig.hold(upper[upper.size() - 3], 1e4)};
  }
  static std::vector<Vec3> curve(double shift) {   // [m]
    const double s = shift * 1e3;              // [mm]
    std::vector<Vec3> x;
    for (const Vec3& p : {Vec3(-9, 0, 0), Vec3(9, 0, 0), Vec3(14, 0.5, -8), Vec3(8, 1, -14), Vec3(s, 1, -9), Vec3(s, 1, 9)}) x.push_back(1e-3 * p);
    return evenlySpaced(x, knotThread().thread.segmentLength);
  }
  void lowerHands(double speed) {              // [m/s]
    for (std::size_t h : hands) rig.held[h].anchor.y() -= speed * rig.dt;
  }
  /// The first arm passes below the second where they cross, seen from above.
  bool firstIsBelow() const {
    std::vector<Vec3> arms;
    for (int i : lower) arms.push_back(rig.state.position[i]);
    for (int i : upper) arms.push_back(rig.state.position[i]);
    const KnotDiagram d = projectThread(arms, Vec3(1e-4, 1.0, 2e-4));
    return d.crossings() == 1 && !d.code[0].over;
  }
};

class ThreadMeetsThread : public testing::TestWithParam<double> {};   // [s] step

TEST_P(ThreadMeetsThread, AtHalfAMetreASecondItDoesNotPassThrough) {
  for (double shift : {0.0, 0.07e-3, 0.15e-3, 0.21e-3}) {             // [m] nodes, joints and between
    CrossedArms arms(GetParam(), shift);
    double most = 0.0;                                                // [N]
    for (int k = 0; k * arms.rig.dt < 9e-3; ++k) {
      arms.lowerHands(0.5);
      ASSERT_TRUE(arms.rig.step());
      ASSERT_TRUE(arms.firstIsBelow()) << "after " << k * arms.rig.dt << " s, shift " << shift;
      for (double t : arms.rig.state.tension) most = std::max(most, t);
    }
    EXPECT_GT(most, 1.0) << "the arms have met and pull on each other";
    EXPECT_EQ(arms.rig.contacts.dropped, 0);
  }
}
INSTANTIATE_TEST_SUITE_P(Steps, ThreadMeetsThread, testing::Values(1e-3, 0.5e-3, 0.25e-3));

TEST(ThreadContact, AWiderApproachSpeedDoesNotPassEither) {
  CrossedArms arms(0.25e-3, 0.07e-3);
  for (int k = 0; k * arms.rig.dt < 2.5e-3; ++k) {
    arms.lowerHands(2.0);
    ASSERT_TRUE(arms.rig.step());
    ASSERT_TRUE(arms.firstIsBelow()) << "after " << k * arms.rig.dt << " s";
  }
}

double energy(const KnotRig& rig) {            // [J]
  const auto& x = rig.state.position;
  double sum = 0.5 * rig.model.needleMass * rig.state.needleVelocity.squaredNorm();   // [J]
  const Mat3 r = rig.state.needle.orientation.toRotationMatrix();
  sum += 0.5 * rig.state.needleSpin.dot(r * rig.model.needleInertia * r.transpose() * rig.state.needleSpin);
  for (int i = 0; i < rig.model.nodes; ++i) sum += 0.5 * rig.model.mass[i] * rig.state.velocity[i].squaredNorm();
  for (std::size_t i = 0; i < rig.state.tension.size(); ++i) sum += 0.5 * rig.state.tension[i] * rig.state.tension[i] / rig.model.axialOf[i];
  for (int i = 0; i + 2 < rig.model.nodes; ++i) {
    const NodeBend& b = rig.model.bend[i];
    sum += 0.5 * b.stiffness * (b.weight[0] * x[i] + b.weight[1] * x[i + 1] + b.weight[2] * x[i + 2]).squaredNorm();
  }
  const double squeeze = 0.5 * rig.contactWork.params.stiffness * rig.model.segment / rig.contactWork.samples[0];   // [N/m]
  for (int i = 0; i < rig.contacts.count; ++i) {
    const ThreadContact& c = rig.contacts.contacts[i];
    sum += 0.5 * c.normalForce * c.normalForce / squeeze + 0.5 * c.friction.squaredNorm() / (0.7 * squeeze);
  }
  return sum;
}

TEST(ThreadContact, ALooselyTiedKnotLeftToItselfOnlyLosesEnergy) {
  TiedKnot knot(std::vector<int>{3, -3});
  const double start = energy(knot.rig);       // [J] of the bent thread
  double last = start, worst = 0.0;            // [J]
  for (int k = 0; k < 400; ++k) {
    ASSERT_TRUE(knot.rig.step());
    const double now = energy(knot.rig);       // [J]
    worst = std::max(worst, now - last);
    last = now;
  }
  RecordProperty("largest_rise_share", std::to_string(worst / start));
  if (std::getenv("KNOT_VERBOSE")) std::printf("largest rise %.3g of the start, end %.3f\n", worst / start, last / start);
  EXPECT_LT(worst, 0.01 * start);
  EXPECT_LT(last, start);
}

TEST(ThreadContact, FrictionNeverExceedsCoulomb) {
  TiedKnot knot(std::vector<int>{3, -3});
  knot.tighten(2.0, 0.03);
  const double mu = knot.rig.contactWork.params.friction;   // [1]
  EXPECT_GT(knot.rig.contacts.count, 20);
  for (int i = 0; i < knot.rig.contacts.count; ++i) {
    const ThreadContact& c = knot.rig.contacts.contacts[i];
    EXPECT_LE(c.friction.norm(), mu * c.normalForce * (1.0 + 1e-9));
  }
}

TEST(ThreadContact, TheSameRunTwiceGivesTheSameBits) {
  TiedKnot a(std::vector<int>{3, 3}), b(std::vector<int>{3, 3});
  a.tighten(2.0, 0.02);
  b.tighten(2.0, 0.02);
  for (int i = 0; i < a.rig.model.nodes; ++i) EXPECT_EQ(a.rig.state.position[i], b.rig.state.position[i]);
}

constexpr double kHand = 1000.0;               // [N/m]

/// Two posts, 1 mm in radius, close on a thread from either side at 0.1 m/s and meet in it, 1 mm deep: the force with which it parts them [N], at most,
/// and the most that lay on one sample [N].
struct Pinch { double post = 0.0, sample = 0.0; };
Pinch pinched(int left, int right) {           // who moves each
  std::vector<Vec3> straight;
  for (int i = 0; i < 60; ++i) straight.push_back(Vec3(0.0, 0.3e-3 * (i - 30), 0.0));
  SimParams p = knotThread();
  KnotRig rig(p, straight);
  rig.hold(0, 1e3);
  rig.hold(55, 1e3);
  for (int owner : {left, right}) {
    ThreadSolid post;
    post.owner = owner;
    post.radius = 1e-3;
    rig.solids.push_back(post);
  }
  for (GivingTool& hand : rig.contactWork.hands.tool) hand.spring = kHand;
  Pinch most;
  for (int k = 0; k <= 40; ++k) {
    const double speed = 0.1, apart = 1.3e-3 - k * speed * rig.dt;   // [m/s] [m] from the thread to either post's axis
    for (int i = 0; i < 2; ++i) {
      const Vec3 at((i ? 1.0 : -1.0) * apart, 0.0, 0.0), before = at * ((apart + speed * rig.dt) / apart), up(0.0, 0.0, 10e-3);
      const int owner = rig.solids[i].owner;
      const Vec3 given = owner < 0 ? Vec3(Vec3::Zero()) : rig.contactWork.hands.tool[owner].offset;   // [m]
      rig.solids[i].a = at + given - up, rig.solids[i].b = at + given + up;
      rig.solids[i].fromA = before + given - up, rig.solids[i].fromB = before + given + up;
    }
    if (!rig.step()) return {};
    for (int i = 0; i < 2; ++i) most.post = std::max(most.post, forceOnSolid(rig.contactWork, i).norm());
    for (const TouchingPoint& c : rig.contactWork.points) most.sample = std::max(most.sample, c.normalForce);
  }
  return most;
}

/// Hands give way before the thread between them does: each is a spring that has been closed by not much more than a post's radius. Two posts
/// that stand for ever do not.
TEST(ThreadContact, BetweenTheToolsOfTwoHandsItPressesThemLikeTheirSprings) {
  const Pinch hands = pinched(0, 1), posts = pinched(-1, -1);
  std::printf("two hands: %.2f N, %.2f N a sample; two posts: %.1f N, %.1f N a sample\n", hands.post, hands.sample, posts.post, posts.sample);
  EXPECT_GT(hands.post, 0.5);
  EXPECT_LT(hands.post, kHand * 1e-3);
  EXPECT_GT(posts.post, 60.0) << "what it is where nothing gives";
}

/// A hand sent across a string that is held at both ends: two springs in series, whose balance is found in one step and stays.
TEST(ThreadContact, AHandSentAcrossATautThreadStopsWhereTheirForcesBalance) {
  constexpr double kHalf = 8.1e-3, kSent = 2e-3;   // [m]
  std::vector<Vec3> straight;
  for (int i = 0; i < 60; ++i) straight.push_back(Vec3(0.0, 0.3e-3 * (i - 27), 0.0));
  const SimParams p = knotThread();
  KnotRig rig(p, straight);
  rig.hold(0, 1e7);
  rig.hold(54, 1e7);
  rig.contactWork.hands.tool[0].spring = kHand;
  ThreadSolid post;
  post.owner = 0;
  post.radius = 1e-3;
  const double touching = post.radius + p.thread.radius;   // [m] from the post's axis to the thread's
  double least = 1e9, most = 0.0, given = 0.0;   // [N], [N], [m] over the last hundred steps
  for (int k = 0; k < 300; ++k) {
    const Vec3 at = (k == 0 ? 0.0 : kSent) * Vec3::UnitX() - touching * Vec3::UnitX() + rig.contactWork.hands.tool[0].offset;
    const Vec3 before = k == 1 ? Vec3(at - kSent * Vec3::UnitX()) : at, up(0.0, 0.0, 10e-3);
    post.a = at - up, post.b = at + up, post.fromA = before - up, post.fromB = before + up;
    rig.solids.assign(1, post);
    ASSERT_TRUE(rig.step());
    const double push = forceOnSolid(rig.contactWork, 0).norm();
    given = rig.contactWork.hands.tool[0].offset.norm();
    if (k == 1) continue;                      // 2 mm in a step take more iterations than there are
    EXPECT_NEAR(push, kHand * given, 1e-2 * push + 1e-6) << k;   // the solve ends within 5 mN on a sample
    if (k < 200) continue;
    least = std::min(least, push);
    most = std::max(most, push);
  }
  // The string drawn aside by x at its middle, about a post: 2 EA (1 / cos - 1) sin, its two halves a little shorter by what lies on the post.
  const double x = kSent - given, angle = std::atan2(x, kHalf);   // [m], [rad]
  const double closed = 2.0 * p.thread.axialStiffness * (1.0 / std::cos(angle) - 1.0) * std::sin(angle);   // [N]
  std::printf("hand sent 2 mm stops at %.3f mm with %.4f N (closed form there %.4f N), last hundred steps %.4f to %.4f N\n", 1e3 * x, kHand * given, closed, least, most);
  EXPECT_NEAR(kHand * given, closed, 0.1 * closed);
  EXPECT_LT(most - least, 0.01 * most) << "thread and hand throw each other to and fro";
}

/// USP knot-pull minimum of a 3-0 absorbable synthetic thread.
TEST(ThreadStrength, BreaksAtItsKnotPullStrengthAndNotBelow) {
  std::vector<Vec3> straight;
  for (int i = 0; i < 60; ++i) straight.push_back(Vec3(0.3e-3 * i, 0.0, 0.0));
  const double strength = ThreadContactParams{}.breakingTension;   // [N]
  for (double share : {0.98, 1.02}) {          // [1]
    KnotRig rig(knotThread(), straight);
    rig.hold(0, 1e6);
    rig.pull(55, Vec3(share * strength, 0.0, 0.0));
    ASSERT_TRUE(rig.run(200));
    EXPECT_EQ(overloadedSegment(rig.state, strength) >= 0, share > 1.0) << share;
  }
}

}  // namespace
}  // namespace halsted
