// Tissue that is cut: what is gone is not drawn, what the cut opens is, and heat chars.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "render/renderer.h"
#include "render/skin.h"
#include "tests/render/golden_picture.h"
#include "tests/render/synthetic_scene.h"

namespace halsted::render {
namespace {

/// The open colon end with one face between tets: across the lumen, facing the surgeon.
class CutPicture : public testing::Test {
 protected:
  CutPicture() {
    double top = scene.tissueRest.front().z();                   // [m]
    for (const Vec3& p : scene.tissueRest) top = std::max(top, p.z());
    std::array<int, 3> face{};
    for (int k = 0; k < 3; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / 3.0;     // [rad]
      double farthest = -1e9;                                    // [m] in that direction
      for (std::size_t v = 0; v < scene.tissueRest.size(); ++v) {
        const Vec3& p = scene.tissueRest[v];
        const double out = std::cos(angle) * p.x() + std::sin(angle) * p.y();
        if (p.z() > top - 2e-3 && out > farthest) { farthest = out; face[k] = static_cast<int>(v); }
      }
    }
    const Vec3 &a = scene.tissueRest[face[0]], &b = scene.tissueRest[face[1]], &c = scene.tissueRest[face[2]];
    if ((b - a).cross(c - a).z() < 0.0) std::swap(face[1], face[2]);
    scene.surface.push_back(face);
    scene.triangleLayer.push_back(kCutFaceLayer);
    snapshot = syntheticSnapshot(scene, 1.0, 4);
    snapshot.exposed.assign(scene.surface.size(), 1);
    snapshot.exposed.back() = 0;
    snapshot.charred.assign(scene.surface.size(), 0.0);
  }
  double brightness(const Frame& f) const {                     // [1] of 255
    return static_cast<double>(std::accumulate(f.rgba.begin(), f.rgba.end(), std::uint64_t{0})) / static_cast<double>(f.rgba.size());
  }

  RenderScene scene = syntheticScene();
  RenderSnapshot snapshot;
};

TEST_F(CutPicture, IsTheSameWhileNothingIsCut) {
  const RenderScene plain = syntheticScene();
  Renderer uncut(plain, kWidth, kHeight), renderer(scene, kWidth, kHeight);
  const Frame a = uncut.draw(syntheticSnapshot(plain, 1.0, 4), noHud(), scene.camera);
  EXPECT_EQ(a.rgba, renderer.draw(snapshot, noHud(), scene.camera).rgba);
}

TEST_F(CutPicture, TissueThatIsGoneIsNotDrawn) {
  Renderer renderer(scene, kWidth, kHeight);
  RenderSnapshot none = snapshot;
  none.tissue.clear();                         // a snapshot without tissue
  const Frame a = renderer.draw(none, noHud(), scene.camera);
  std::fill(snapshot.exposed.begin(), snapshot.exposed.end(), std::uint8_t{0});
  EXPECT_EQ(a.rgba, renderer.draw(snapshot, noHud(), scene.camera).rgba);
}

TEST_F(CutPicture, AFaceIsSeenOnceItIsBare) {
  Renderer renderer(scene, kWidth, kHeight);
  const Frame a = renderer.draw(snapshot, noHud(), scene.camera);
  snapshot.exposed.back() = 1;
  snapshot.exposed.front() = 0;                // something has gone
  EXPECT_GT(difference(a, renderer.draw(snapshot, noHud(), scene.camera), 8), 0.01);
}

/// The needle's piece of a cut thread falls out of the picture; a line as thin as a pixel led after it.
TEST_F(CutPicture, NothingIsDrawnBetweenTheEndsOfACutThread) {
  Renderer renderer(scene, kWidth, kHeight);
  const auto partedBy = [&](const Vec3& way) {   // [m]
    RenderSnapshot parted = snapshot;
    for (std::size_t i = parted.thread.size() / 2; i < parted.thread.size(); ++i) parted.thread[i] += way;
    parted.needle.position += way;
    return renderer.draw(parted, noHud(), scene.camera).rgba;
  };
  EXPECT_EQ(partedBy(Vec3(0.0, -5.0, 0.0)), partedBy(Vec3(5.0, 0.0, 0.0)));
}

TEST_F(CutPicture, HeatCharsWhatItTouches) {
  Renderer renderer(scene, kWidth, kHeight);
  const double raw = brightness(renderer.draw(snapshot, noHud(), closeCamera()));
  std::fill(snapshot.charred.begin(), snapshot.charred.end(), 0.95);
  EXPECT_LT(brightness(renderer.draw(snapshot, noHud(), closeCamera())), 0.9 * raw);
}

}  // namespace
}  // namespace halsted::render
