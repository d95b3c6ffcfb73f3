// Smoke rises where a pen burns tissue, without a jump, and does not depend on what was drawn before.
#include "render/smoke.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/renderer.h"
#include "tests/render/golden_picture.h"
#include "tests/render/synthetic_scene.h"

namespace halsted::render {
namespace {

constexpr double kFrame = 1.0 / 60.0;          // [s]

TEST(Smoke, NeitherComesNorGoesAllAtOnce) {
  const Vec3 electrode(0.01, -0.02, 0.03), up = Vec3::UnitY();   // [m], [1]
  for (int n = 0; n < 600; ++n) {
    const auto before = plumeOver(electrode, up, n * kFrame), after = plumeOver(electrode, up, (n + 1) * kFrame);
    for (int k = 0; k < kPuffs; ++k) {
      EXPECT_LT(std::abs(after[k].strength - before[k].strength), 0.06) << n << ", " << k;
      const bool seen = before[k].strength > 0.01 && after[k].strength > 0.01;
      if (!seen) continue;
      EXPECT_LT((after[k].centre - before[k].centre).norm(), 1e-3) << n << ", " << k;
    }
  }
}

TEST(Smoke, RisesFromTheElectrodeAndThinsOut) {
  const Vec3 electrode(0.01, -0.02, 0.03), up = Vec3(0.0, 3.0, 4.0) / 5.0;   // [m], [1]
  for (int n = 0; n < 100; ++n)
    for (const Puff& p : plumeOver(electrode, up, 0.13 * n)) {
      const double height = up.dot(p.centre - electrode);   // [m]
      EXPECT_GE(height, 0.0);
      EXPECT_LT((p.centre - electrode - height * up).norm(), 8e-3);
      EXPECT_LT(p.strength, height > 25e-3 ? 0.1 : 0.5);
    }
}

class SmokePicture : public testing::Test {
 protected:
  SmokePicture() {
    scene.tools[1] = ToolKind::kElectrocautery;
    snapshot = syntheticSnapshot(scene, 1.0, 0);
    snapshot.time = 3.0;
    snapshot.tools[1].smokes = true;
  }
  RenderScene scene = syntheticScene();
  RenderSnapshot snapshot;
};

TEST_F(SmokePicture, IsSeenWhileThePenSmokesAndOnlyThen) {
  Renderer renderer(scene, kWidth, kHeight);
  const Frame smoking = renderer.draw(snapshot, noHud(), closeCamera());
  snapshot.tools[1].smokes = false;
  const Frame clear = renderer.draw(snapshot, noHud(), closeCamera());
  EXPECT_GT(difference(smoking, clear, 12), 0.005);
  snapshot.time = 4.1;
  EXPECT_EQ(clear.rgba, renderer.draw(snapshot, noHud(), closeCamera()).rgba);
}

TEST_F(SmokePicture, DoesNotDependOnWhatWasDrawnBefore) {
  Renderer watched(scene, kWidth, kHeight), fresh(scene, kWidth, kHeight);
  RenderSnapshot earlier = snapshot;
  for (earlier.time = 2.0; earlier.time < 3.0; earlier.time += 0.1) watched.draw(earlier, noHud(), closeCamera());
  EXPECT_EQ(watched.draw(snapshot, noHud(), closeCamera()).rgba, fresh.draw(snapshot, noHud(), closeCamera()).rgba);
}

}  // namespace
}  // namespace halsted::render
