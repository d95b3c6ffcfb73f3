// Laws of the picture of a needled body, and what it looked like when a person last looked at it (tests/golden).
#include <gtest/gtest.h>

#include <cmath>

#include "render/magnifier.h"
#include "render/renderer.h"
#include "tests/render/golden_picture.h"
#include "tests/render/synthetic_body.h"

namespace halsted::render {
namespace {

HudInput bare(bool otherView = false) {
  HudInput hud;
  hud.visible = false;
  hud.otherView = otherView;
  return hud;
}

struct Rows { int from, to; };

/// Colour values of these rows that differ, outside the magnifier.
int changed(const Frame& a, const Frame& b, const Rows& rows) {
  const Glass glass = magnifier(kWidth, kHeight);
  int count = 0;
  for (int y = rows.from; y < rows.to; ++y)
    for (int x = 0; x < kWidth; ++x) {
      if (x >= glass.x && x < glass.x + glass.width && y >= glass.y && y < glass.y + glass.height) continue;
      for (int k = 0; k < 3; ++k) count += std::abs(a.rgba[4u * (y * kWidth + x) + k] - b.rgba[4u * (y * kWidth + x) + k]) > 6;
    }
  return count;
}

class BodyScene : public testing::Test {
 protected:
  RenderScene scene = syntheticBody();
  Renderer renderer{scene, kWidth, kHeight};
  Frame draw(const RenderSnapshot& s, const HudInput& hud = bare()) { return renderer.draw(s, hud, scene.camera); }
};

TEST_F(BodyScene, LooksAsItDidWhole) { expectGolden(draw(syntheticNeedling(scene, 0.6e-3, 0.6e-3)), "render_body"); }
TEST_F(BodyScene, LooksAsItDidCutOpen) { expectGolden(draw(syntheticNeedling(scene, 18e-3, 0.3e-3), bare(true)), "render_body_cutaway"); }

TEST_F(BodyScene, IsTheSameForTheSameInput) {
  const RenderSnapshot snapshot = syntheticNeedling(scene, 10e-3, 0.0);
  const Frame a = draw(snapshot, HudInput{});
  draw(syntheticNeedling(scene, -20e-3, 0.0), bare(true));       // what was drawn before must not matter
  EXPECT_EQ(a.rgba, draw(snapshot, HudInput{}).rgba);
  Renderer second(scene, kWidth, kHeight);
  EXPECT_EQ(a.rgba, second.draw(snapshot, HudInput{}, scene.camera).rgba);
}

TEST_F(BodyScene, TheNeedleBelowTheSkinIsSeenInTheCutawayOnly) {
  const RenderSnapshot shallow = syntheticNeedling(scene, 4e-3, 0.0), deep = syntheticNeedling(scene, 14e-3, 0.0);
  const Rows below{kHeight / 2 + 4, kHeight};                    // of the picture, under the place where the needle goes in
  EXPECT_EQ(changed(draw(shallow), draw(deep), below), 0);
  EXPECT_GT(changed(draw(shallow, bare(true)), draw(deep, bare(true)), below), 20);
}

TEST_F(BodyScene, OpensAsTheSceneSays) {
  const RenderSnapshot snapshot = syntheticNeedling(scene, 10e-3, 0.0);
  const Frame cut = draw(snapshot, bare(true));
  scene.cutaway = true;
  Renderer open(scene, kWidth, kHeight);
  EXPECT_EQ(cut.rgba, open.draw(snapshot, bare(), scene.camera).rgba);
}

TEST_F(BodyScene, ADimpleIsSeen) {
  const RenderSnapshot flat = syntheticNeedling(scene, 0.0, 0.0), dented = syntheticNeedling(scene, 0.0, 0.8e-3);
  const Frame a = draw(flat), b = draw(dented);
  EXPECT_GT(changed(a, b, {0, kHeight}), 20);
  const Glass glass = magnifier(kWidth, kHeight);
  int inGlass = 0;
  for (int y = glass.y; y < glass.y + glass.height; ++y)
    for (int x = glass.x; x < glass.x + glass.width; ++x) inGlass += std::abs(a.rgba[4u * (y * kWidth + x)] - b.rgba[4u * (y * kWidth + x)]) > 6;
  EXPECT_GT(inGlass, glass.width * glass.height / 20);
}

TEST_F(BodyScene, ATurnOfTheNeedleIsSeenOnItsHandle) {
  const RenderSnapshot rest = syntheticNeedling(scene, 20e-3, 0.0);
  RenderSnapshot turned = rest;
  turned.tools[kRight].pose.orientation = rest.tools[kRight].pose.orientation * Quat(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5));
  EXPECT_GT(changed(draw(rest), draw(turned), {0, kHeight / 2}), 20);
}

TEST_F(BodyScene, TheFingerIsSeenWhereItPresses) {
  const RenderSnapshot there = syntheticNeedling(scene, -20e-3, 0.0);
  RenderSnapshot away = there;
  away.tools[kLeft].pose.position += Vec3(0.0, 0.5, 0.0);
  EXPECT_GT(changed(draw(there), draw(away), {0, kHeight}), 2000);
}

TEST_F(BodyScene, InkStaysOnSkinThatIsPressedDown) {
  RenderSnapshot snapshot = syntheticNeedling(scene, -20e-3, 0.0);
  const Frame rest = draw(snapshot);
  for (Vec3& p : snapshot.tissue) p.y() -= 2e-3;                 // all of it: only what stays behind would not move along
  const Frame lower = draw(snapshot);
  const auto inkRow = [&](const Frame& f) {                      // mean row of violet pixels
    double sum = 0.0, count = 0.0;                               // [1]
    for (int y = 0; y < kHeight; ++y)
      for (int x = kWidth / 2 - 30; x < kWidth / 2 + 30; ++x) {
        const std::uint8_t* p = &f.rgba[4u * (y * kWidth + x)];
        if (p[2] > p[1] + 12) { sum += y; count += 1.0; }
      }
    return count > 0.0 ? sum / count : 0.0;
  };
  EXPECT_GT(inkRow(rest), 0.0);
  EXPECT_GT(inkRow(lower), inkRow(rest) + 1.0);
}

TEST_F(BodyScene, ReadingsChangeThePanels) {
  RenderSnapshot snapshot = syntheticNeedling(scene, 10e-3, 0.0);
  const Frame a = draw(snapshot, HudInput{});
  snapshot.needling.grasp = 1.7;
  const Frame b = draw(snapshot, HudInput{});
  EXPECT_NE(a.rgba, b.rgba);
  snapshot.needling.turned = 2.0;
  EXPECT_NE(b.rgba, draw(snapshot, HudInput{}).rgba);
}

TEST_F(BodyScene, SurvivesASnapshotThatDoesNotFitTheScene) {
  RenderSnapshot odd;
  odd.tissue.resize(3);
  odd.needling.depth = std::nan("");
  odd.needling.punctured = 99;
  odd.needling.contact.setConstant(std::nan(""));
  EXPECT_EQ(draw(odd, HudInput{}).rgba.size(), 4u * kWidth * kHeight);
  RenderSnapshot wild = syntheticNeedling(scene, 1e-3, 0.0);
  for (Vec3& p : wild.tissue) p.setConstant(std::nan(""));
  wild.needling.contact = scene.camera.eye;
  EXPECT_EQ(draw(wild, HudInput{}).rgba.size(), 4u * kWidth * kHeight);
}

}  // namespace
}  // namespace halsted::render
