/// Laws S5, S6 and S8: the force net's rings and sums, and the springback.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/needling/springback.h"
#include "tests/sim/needling/needling_rig.h"

namespace halsted {
namespace {

LayerParams paperLayer(double stiffness, double length, int rings, double force) {   // [N/m], [m], [N]
  LayerParams layer;
  layer.springStiffness = stiffness;
  layer.springLength = length;
  layer.rings = rings;
  layer.punctureForce = force;
  return layer;
}

const LayerParams kPaper[] = {paperLayer(160, 2e-3, 8, 0), paperLayer(80, 1e-3, 4, 0), paperLayer(230, 2.5e-3, 10, 0)};

TEST(ForceNet, RingJHasSixTimesJMinusOnePointsAtTheSpringLength) {
  for (const LayerParams& layer : kPaper) {
    NeedlingParams p;
    p.profile = NetProfile::kCone;
    const ForceNet net = forceNet(layer, p);
    std::vector<int> count(layer.rings + 2, 0);
    for (int ring : net.ring) ++count[ring];
    EXPECT_EQ(count[1], 1);
    for (int j = 2; j <= layer.rings + 1; ++j) EXPECT_EQ(count[j], 6 * (j - 1));
    EXPECT_EQ(netPoints(layer.rings), 1 + 3 * layer.rings * (layer.rings - 1));
    for (std::size_t i = 0; i < net.place.size(); ++i) {   // each point's nearest neighbour is one spring length away
      double nearest = 1.0;                    // [m]
      for (std::size_t j = 0; j < net.place.size(); ++j)
        if (j != i) nearest = std::min(nearest, (net.place[i] - net.place[j]).norm());
      EXPECT_NEAR(nearest, layer.springLength, 1e-12);
    }
  }
}

TEST(ForceNet, ConeGivesExactlyKTimesWSquaredTimesDepth) {
  for (const LayerParams& layer : kPaper) {
    NeedlingParams p;
    p.profile = NetProfile::kCone;
    const ForceNet net = forceNet(layer, p);
    const double expected = layer.springStiffness * layer.rings * layer.rings * net.punctureDepth;   // [N]
    EXPECT_NEAR(netForce(net, net.punctureDepth) / expected, 1.0, 1e-13);
    for (int j = 1; j <= layer.rings; ++j)     // the profile is Z_1 (1 - (j - 1) / w), and the foot lies at the outermost ring
      EXPECT_NEAR(ringDepth(net, j, net.punctureDepth), net.punctureDepth * (1.0 - (j - 1.0) / layer.rings), 1e-15);
  }
}

TEST(ForceNet, InverseDistanceIsWhatADeviceCanRender) {   // physics.md A3 d: skin 0.58 N/mm with a 0.25 mm needle
  const ForceNet net = forceNet(paperLayer(160, 2e-3, 8, 0.3), {});
  EXPECT_NEAR(netStiffness(net, 0.0), 580.0, 1.0);
  EXPECT_NEAR(netForce(net, net.punctureDepth), 0.3, 1e-12);
  for (double z : {1e-5, 2e-4}) EXPECT_NEAR((netForce(net, z + 1e-9) - netForce(net, z - 1e-9)) / 2e-9, netStiffness(net, z), 1e-3);
}

TEST(ForceNet, RefusesWhatMakesNoSense) {
  EXPECT_THROW(forceNet(paperLayer(160, 2e-3, 1, 0.3), {}), std::invalid_argument);
  EXPECT_THROW(forceNet(paperLayer(-1, 2e-3, 8, 0.3), {}), std::invalid_argument);
  EXPECT_THROW(forceNet(paperLayer(160, 0, 8, 0.3), {}), std::invalid_argument);
  EXPECT_THROW(forceNet(paperLayer(160, 2e-3, 8, 0), {}), std::invalid_argument);
  NeedlingParams p;
  p.layers[1].thickness = -1e-3;
  EXPECT_THROW(halsted::testing::ballModel(p), std::invalid_argument);
}

TEST(ForceNet, LiesOnTheSurface) {
  const HarmonicSurface s = halsted::testing::ball(0.05);
  const ForceNet net = forceNet(paperLayer(160, 2e-3, 8, 0.3), {});
  std::vector<Vec3> points(net.place.size());
  const SurfaceFrame f = frameAt(s, Vec3(0.6, 0.0, 0.8));
  placeNet(net, f, bendAt(s, f), points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double r = net.place[i].norm();      // [m]
    EXPECT_NEAR(points[i].norm(), 0.05, 0.2 * r * r * r * r / (0.05 * 0.05 * 0.05) + 1e-15);   // the next term of a sphere
  }
}

TEST(Springback, RateReachesTheSamePlaceInAnyNumberOfSteps) {
  const Vec3 goal(0.1, 0.2, 0.3), start(0.4, -0.1, 0.0);
  for (int steps : {7, 80, 1000}) {
    Vec3 p = start;
    double before = 1.0;                       // [1]
    for (int k = 1; k <= steps; ++k) {         // half of the springback time
      const double after = springbackRemaining(0.5 * k / steps, 1.0);   // [1]
      p = springBack(goal, after / before, p);
      before = after;
    }
    EXPECT_LT((p - (goal + 0.25 * (start - goal))).norm(), 1e-13) << steps;
  }
  EXPECT_EQ(springbackRemaining(1.0, 1.0), 0.0);
  EXPECT_EQ(springBack(goal, 0.0, start), goal);   // eta = 0: on the goal
}

TEST(Springback, ThePapersOwnFactorMultipliesUp) {   // x = g + prod(eta) (p0 - g), eq. 9
  const Vec3 goal(0.1, 0.2, 0.3), start(0.4, -0.1, 0.0);
  Vec3 p = start;
  double eta = 1.0, product = 1.0;             // [1]
  for (int k = 0; k < 20; ++k) {
    eta -= 0.04;
    product *= eta;
    p = springBack(goal, eta, p);
  }
  EXPECT_LT((p - (goal + product * (start - goal))).norm(), 1e-15);
}

TEST(Springback, MatchesARigidMotionOfAFlatRing) {
  std::vector<Vec3> rest, now;
  const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const Vec3 shift(0.01, -0.02, 0.005);
  for (int k = 0; k < 48; ++k) {
    rest.push_back(Vec3(0.02 * std::cos(k * 2 * M_PI / 48), 0.02 * std::sin(k * 2 * M_PI / 48), 0.1));
    now.push_back(turn * rest.back() + shift);
  }
  const Match match = matchRing(rest, now);
  EXPECT_LT((match.rotation - turn).norm(), 1e-12);
  EXPECT_LT((match.goal(Vec3(0, 0, 0.1)) - (turn * Vec3(0, 0, 0.1) + shift)).norm(), 1e-13);
  EXPECT_LT((rotationOf(turn * Vec3(3, 0.5, 0.01).asDiagonal() * Mat3::Identity()) - turn).norm(), 1e-6);
  EXPECT_EQ(rotationOf(Mat3::Zero()), Mat3::Identity());
}

}  // namespace
}  // namespace halsted
