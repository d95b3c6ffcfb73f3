// Tissue that has borne too much: it is seen where it was pressed, and nowhere else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "render/renderer.h"
#include "tests/render/golden_picture.h"
#include "tests/render/synthetic_scene.h"

namespace halsted::render {
namespace {

class BruisePicture : public testing::Test {
 protected:
  BruisePicture() { snapshot.bruised.assign(scene.tissueRest.size(), 0.0); }
  /// All particles within this distance of the one that is nearest to the camera.
  void press(double within, double seconds) {    // [m] [1] of what injures
    const auto away = [&](const Vec3& p) { return (p - scene.camera.eye).norm(); };
    const Vec3 nearest = *std::min_element(snapshot.tissue.begin(), snapshot.tissue.end(), [&](const Vec3& a, const Vec3& b) { return away(a) < away(b); });
    for (std::size_t i = 0; i < snapshot.tissue.size(); ++i)
      if ((snapshot.tissue[i] - nearest).norm() < within) snapshot.bruised[i] = seconds;
  }
  Frame picture() { return renderer.draw(snapshot, noHud(), scene.camera); }

  RenderScene scene = syntheticScene();
  RenderSnapshot snapshot = syntheticSnapshot(scene, 1.0, 4);
  Renderer renderer{scene, kWidth, kHeight};
};

TEST_F(BruisePicture, WhatHasBorneNothingLooksAsBefore) {
  RenderSnapshot untold = snapshot;
  untold.bruised.clear();
  EXPECT_EQ(picture().rgba, renderer.draw(untold, noHud(), scene.camera).rgba);
}

TEST_F(BruisePicture, AnInjuryIsDarkAndItsPlaceAlone) {
  const Frame before = picture();
  press(8e-3, 1.0);
  const Frame after = picture();
  int darker = 0, lighter = 0;                   // pixels
  for (std::size_t i = 0; i + 3 < before.rgba.size(); i += 4) {
    const int change = after.rgba[i] - before.rgba[i];           // of 255, red
    darker += change < -20;
    lighter += change > 4;
  }
  const int all = kWidth * kHeight;
  EXPECT_GT(darker, all / 500);
  EXPECT_LT(darker, all / 8);
  EXPECT_EQ(lighter, 0);
}

TEST_F(BruisePicture, MoreTimeUnderPressureIsDarker) {
  const auto brightness = [&] { const Frame f = picture(); return std::accumulate(f.rgba.begin(), f.rgba.end(), std::uint64_t{0}); };   // [1] of 255, all added up
  const auto none = brightness();
  press(8e-3, 0.3);
  const auto some = brightness();
  press(8e-3, 1.0);
  EXPECT_LT(some, none);
  EXPECT_LT(brightness(), some);
}

}  // namespace
}  // namespace halsted::render
