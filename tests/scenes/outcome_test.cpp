/// The load of a leak test, and what it does not claim.
#include "sim/outcome.h"

#include <gtest/gtest.h>

#include "scenes/procedural_colon.h"
#include "scenes/two_ends.h"
#include "sim/step.h"

namespace halsted {
namespace {

AnatomyParams straightTube() {
  AnatomyParams params;
  params.haustraDepth = 0.0;
  params.around = 16;
  params.along = 6;
  return params;
}

Model modelOf(const TetMesh& mesh) {
  SimParams params;
  params.anvil.radius = 0.0;
  return buildModel(params, mesh, {});
}

const std::array<Pose, kHands> kAway{Pose{Vec3(-0.06, 0.02, 0.055), Quat::Identity()}, Pose{Vec3(0.06, 0.02, 0.055), Quat::Identity()}};

/// Gauss: the integral of the pressure times the distance from the axis is twice the pressure times the volume.
TEST(LumenPressure, DoesTheWorkOfItsVolume) {
  const Model m = modelOf(scenes::proceduralColon(straightTube()));
  std::vector<Vec3> load(m.mesh.vertices.size(), Vec3::Zero());
  gatherPressure(m, initialState(m, kAway), 1000.0, load);
  Vec3 net = Vec3::Zero();                     // [N]
  double work = 0.0;                           // [J]
  std::vector<int> section;
  for (std::size_t v = 0; v < load.size(); ++v) {
    net += load[v];
    work += load[v].x() * m.mesh.vertices[v].x() + load[v].y() * m.mesh.vertices[v].y();
    if (m.mesh.vertices[v].z() == 0.0 && m.bowels.wallDepth[v] == 1.0) section.push_back(static_cast<int>(v));
  }
  const double lumen = enclosedArea(section, m.mesh.vertices) * straightTube().length;   // [m^3]
  EXPECT_NEAR(work, 2.0 * 1000.0 * lumen, 1e-9);
  EXPECT_LT(net.norm(), 1e-9);
}

TEST(LumenPressure, WidensTheTube) {
  const Model m = modelOf(scenes::proceduralColon(straightTube()));
  State s = initialState(m, kAway);
  StepInput input;
  StepOutput out;
  for (int hand = 0; hand < kHands; ++hand) input.tools[hand].pose = kAway[hand];
  input.lumenPressure = 20.0 * kPascalPerMmhg;
  for (int i = 0; i < 300; ++i) step(m, input, s, out);
  EXPECT_GT(s.metrics.openingArea, 1.02 * m.restOpening);
}

TEST(Outcome, OfOneEndOrOfTwoUnsewnIsNotTested) {
  for (const TetMesh& mesh : {scenes::proceduralColon(straightTube()), scenes::endToEnd(scenes::proceduralColon(straightTube()), 6e-3)}) {
    const Model m = modelOf(mesh);
    EXPECT_FALSE(testOutcome(m, initialState(m, kAway)).tested);
    EXPECT_TRUE(summarise(testOutcome(m, initialState(m, kAway))).empty());
  }
}

}  // namespace
}  // namespace halsted
