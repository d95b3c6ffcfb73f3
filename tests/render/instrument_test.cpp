// Laws of the instruments and wires: they follow the tool frame, the needle's arc and the thread's nodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/instruments.h"
#include "render/tube.h"

namespace halsted::render {
namespace {

/// Smallest x of the +x jaw minus largest x of the -x jaw, at the tips. [m]
double tipGap(const Instrument& tool, double jaw) {      // [1]
  double inner[2] = {1.0, 1.0};                          // [m]
  for (int half = 0; half < 2; ++half) {
    const Pose pose = halfPose(tool, half, jaw, Pose{});
    for (const ShapeVertex& v : tool.halves[half].vertices) {
      if (v.position[2] > 1e-3f) continue;
      const Vec3 p = pose.apply(Vec3(v.position[0], v.position[1], v.position[2]));
      inner[half] = std::min(inner[half], half ? -p.x() : p.x());
    }
  }
  return inner[0] + inner[1];
}

class EveryInstrument : public testing::TestWithParam<ToolKind> {};

TEST_P(EveryInstrument, ClosesItsJawsOnEachOther) { EXPECT_NEAR(tipGap(makeInstrument(GetParam()), 0.0), 0.0, 0.2e-3); }

TEST_P(EveryInstrument, OpensAsFarAsTheSimulatedJaws) {
  EXPECT_NEAR(tipGap(makeInstrument(GetParam()), 1.0), 5.2e-3, 0.5e-3);
}

TEST_P(EveryInstrument, HasTheJawsOfTheScene) {
  const double angle = 40.0 * std::numbers::pi / 180.0;  // [rad]
  const Instrument plain = makeInstrument(GetParam()), longer = makeInstrument(GetParam(), {18e-3, 1.8e-3, angle});
  EXPECT_NEAR(tipGap(longer, 1.0), 2.0 * 18e-3 * std::sin(0.5 * angle), 0.6e-3);
  EXPECT_NEAR(tipGap(longer, 0.0), 0.0, 0.2e-3);
  EXPECT_NEAR(longer.hinge - plain.hinge, 6e-3, 1e-9);
  const auto end = [](const Instrument& tool) {          // [m] how far it reaches up the shaft
    float high = 0.0f;                                   // [m]
    for (const ShapeVertex& v : tool.halves[0].vertices) high = std::max(high, v.position[2]);
    return high;
  };
  EXPECT_NEAR(end(longer) - end(plain), 6e-3f, 1e-5f);
}

TEST_P(EveryInstrument, OpensMonotonically) {
  const Instrument tool = makeInstrument(GetParam());
  for (double jaw = 0.1; jaw <= 1.0; jaw += 0.1) EXPECT_GT(tipGap(tool, jaw), tipGap(tool, jaw - 0.1));
}

TEST_P(EveryInstrument, ExtendsFromTheTipTowardTheHand) {
  for (const Shape& half : makeInstrument(GetParam()).halves) {
    float low = 1.0f, high = -1.0f;                      // [m]
    for (const ShapeVertex& v : half.vertices) { low = std::min(low, v.position[2]); high = std::max(high, v.position[2]); }
    EXPECT_NEAR(low, 0.0f, 1e-4f);
    EXPECT_GT(high, 0.09f);
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryInstrument, testing::Values(ToolKind::kNeedleDriver, ToolKind::kForceps),
                         [](const auto& kind) { return kind.param == ToolKind::kForceps ? "Forceps" : "NeedleDriver"; });

TEST(Needle, LiesOnItsArcAndTapersToAPoint) {
  const NeedleShape shape{8.3e-3, std::numbers::pi, 0.33e-3};
  const Tube tube = makeNeedle(shape);
  for (const TubeVertex& v : tube.vertices) ASSERT_NEAR(std::hypot(v.centre[0], v.centre[1]), shape.radius, 1e-6);
  EXPECT_NEAR(tube.vertices.front().centre[0], shape.radius, 1e-6);
  EXPECT_NEAR(tube.vertices.back().centre[0], -shape.radius, 1e-6);
  EXPECT_LT(tube.vertices.back().radius, 0.1 * shape.wireRadius);
}

std::vector<Vec3> helix(int count) {
  std::vector<Vec3> nodes;
  for (int i = 0; i < count; ++i) nodes.emplace_back(0.01 * std::cos(0.2 * i), 0.01 * std::sin(0.2 * i), 1e-3 * i);
  return nodes;
}

TEST(Thread, PassesThroughEveryNode) {
  const std::vector<Vec3> nodes = helix(40);
  Tube tube = makeThread(40);
  updateThread(nodes, {}, 0.16e-3, tube);
  for (const Vec3& node : nodes) {
    double nearest = 1.0;                                // [m]
    for (const TubeVertex& v : tube.vertices) nearest = std::min(nearest, (Vec3(v.centre[0], v.centre[1], v.centre[2]) - node).norm());
    ASSERT_LT(nearest, 1e-7);
  }
}

/// The piece that was cut off has fallen away: no thread is drawn from the one end to the other.
TEST(Thread, IsNotDrawnAcrossACut) {
  constexpr std::size_t kLast = 20;                      // node before the cut
  std::vector<Vec3> nodes = helix(40);
  for (std::size_t i = kLast + 1; i < nodes.size(); ++i) nodes[i].z() -= 0.3;
  Tube tube = makeThread(40);
  updateThread(nodes, {}, 0.16e-3, tube);
  const auto distance = [&](const TubeVertex& v) {       // [m] from the nearest node
    double nearest = 1.0;                                // [m]
    for (const Vec3& node : nodes) nearest = std::min(nearest, (Vec3(v.centre[0], v.centre[1], v.centre[2]) - node).norm());
    return nearest;
  };
  int collapsed = 0;
  for (const TubeVertex& v : tube.vertices) {
    ASSERT_LT(distance(v), 2e-3);
    collapsed += v.radius == 0.0F ? 1 : 0;
  }
  EXPECT_GT(collapsed, 0);
}

TEST(Thread, TurnsItsPatternByTheTwist) {
  const std::vector<Vec3> nodes = helix(40);
  Tube plain = makeThread(40), twisted = makeThread(40);
  updateThread(nodes, {}, 0.16e-3, plain);
  updateThread(nodes, std::vector<double>(40, 0.7), 0.16e-3, twisted);
  for (std::size_t i = 0; i < plain.vertices.size(); ++i) {
    const float *a = plain.vertices[i].normal, *b = twisted.vertices[i].normal;   // [1]
    ASSERT_NEAR(a[0] * b[0] + a[1] * b[1] + a[2] * b[2], std::cos(0.7), 1e-5);
  }
}

}  // namespace
}  // namespace halsted::render
