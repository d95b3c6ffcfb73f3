// Laws of the picture, and what it looked like when a person last looked at it (tests/golden).
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>

#include "render/renderer.h"
#include "tests/render/golden_picture.h"
#include "tests/render/synthetic_scene.h"

namespace halsted::render {
namespace {

class Picture : public testing::Test {
 protected:
  RenderScene scene = syntheticScene();
  RenderSnapshot snapshot = syntheticSnapshot(scene, 1.0, 4);
};

TEST_F(Picture, LooksAsItDidOpen) {
  Renderer renderer(scene, kWidth, kHeight);
  expectGolden(renderer.draw(snapshot, noHud(), scene.camera), "render_open");
}

TEST_F(Picture, LooksAsItDidGathered) {
  Renderer renderer(scene, kWidth, kHeight);
  expectGolden(renderer.draw(syntheticSnapshot(scene, 0.4, 8), noHud(), closeCamera()), "render_gathered");
}

TEST_F(Picture, IsTheSameForTheSameInput) {
  Renderer first(scene, kWidth, kHeight), second(scene, kWidth, kHeight);
  const Frame a = first.draw(snapshot, HudInput{}, scene.camera);
  first.draw(syntheticSnapshot(scene, 0.5, 8), HudInput{}, closeCamera());       // what was drawn before must not matter
  EXPECT_EQ(a.rgba, first.draw(snapshot, HudInput{}, scene.camera).rgba);
  EXPECT_EQ(a.rgba, second.draw(snapshot, HudInput{}, scene.camera).rgba);
}

TEST_F(Picture, HasManyColoursAndIsOpaque) {
  Renderer renderer(scene, kWidth, kHeight);
  const Frame& f = renderer.draw(snapshot, noHud(), scene.camera);
  std::vector<bool> seen(1 << 12);
  for (std::size_t i = 0; i < f.rgba.size(); i += 4) {
    ASSERT_EQ(f.rgba[i + 3], 255);
    seen[(f.rgba[i] >> 4) << 8 | (f.rgba[i + 1] >> 4) << 4 | f.rgba[i + 2] >> 4] = true;
  }
  EXPECT_GT(std::count(seen.begin(), seen.end(), true), 100);
}

TEST_F(Picture, ShowsTheSurgeonsUpAtTheTop) {
  Renderer renderer(scene, kWidth, kHeight);
  RenderSnapshot bare = snapshot, raised = snapshot;
  raised.tools[kRight].pose.position = Vec3(0.01, 0.028, 0.02);
  bare.tools[kRight].pose.position = Vec3(0, 0, 5);                              // out of sight
  const Frame a = renderer.draw(bare, noHud(), scene.camera);
  const Frame& b = renderer.draw(raised, noHud(), scene.camera);
  std::size_t top = 0, bottom = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) (i < a.rgba.size() / 3 ? top : bottom) += std::abs(a.rgba[i] - b.rgba[i]) > 90;
  EXPECT_GT(top, 2 * bottom);
}

TEST_F(Picture, ChangesWhenTheTissueMoves) {
  Renderer renderer(scene, kWidth, kHeight);
  const Frame a = renderer.draw(snapshot, noHud(), scene.camera);
  for (Vec3& p : snapshot.tissue) p.x() += 1e-3;
  EXPECT_GT(difference(a, renderer.draw(snapshot, noHud(), scene.camera), 8), 0.01);
}

TEST_F(Picture, ChangesWithEachThingThatMoves) {
  Renderer renderer(scene, kWidth, kHeight);
  const Frame a = renderer.draw(snapshot, noHud(), scene.camera);
  const auto changes = [&](auto change) {
    RenderSnapshot s = snapshot;
    change(s);
    return difference(a, renderer.draw(s, noHud(), scene.camera), 4) > 0.0;
  };
  EXPECT_TRUE(changes([](RenderSnapshot& s) { for (Vec3& p : s.thread) p.y() -= 2e-3; }));
  EXPECT_TRUE(changes([](RenderSnapshot& s) { s.needle.position.x() += 2e-3; }));
  EXPECT_TRUE(changes([](RenderSnapshot& s) { s.tools[kLeft].jaw = 1.0; }));
  EXPECT_TRUE(changes([](RenderSnapshot& s) { s.tools[kRight].pose.position.y() -= 2e-3; }));
  EXPECT_TRUE(changes([](RenderSnapshot& s) { s.punctureCount = 0; }));
  EXPECT_TRUE(changes([](RenderSnapshot& s) { s.openingArea = 0.0; }));          // a shut lumen is darker
}

TEST_F(Picture, ShowsEveryHoleThatThereCanBe) {
  constexpr int kMost = kMostPunctures;
  Renderer renderer(scene, kWidth, kHeight);
  const int inView = snapshot.punctureCount;
  snapshot.punctures.insert(snapshot.punctures.begin(), kMost - inView, Vec3(0.0, 0.0, 1.0));   // behind the camera
  snapshot.punctureCount = kMost - inView;
  const Frame without = renderer.draw(snapshot, noHud(), scene.camera);
  snapshot.punctureCount = kMost;
  EXPECT_GT(difference(without, renderer.draw(snapshot, noHud(), scene.camera), 8), 0.0);
}

TEST_F(Picture, DrawsTheHeadUpDisplayOnlyWhenAsked) {
  Renderer renderer(scene, kWidth, kHeight);
  const Frame a = renderer.draw(snapshot, noHud(), scene.camera);
  HudInput hud;
  const Frame b = renderer.draw(snapshot, hud, scene.camera);
  EXPECT_GT(difference(a, b, 8), 0.02);
  const auto differs = [&] { return difference(b, renderer.draw(snapshot, hud, scene.camera), 8) > 0.0; };
  hud.message = "stitch crosses the opening";
  EXPECT_TRUE(differs());
  hud = {};
  hud.stale = true;
  EXPECT_TRUE(differs());
  hud = {};
  snapshot.bites = 7;
  EXPECT_TRUE(differs());
}

TEST_F(Picture, ALongMessageGoesOnInTheNextLineBeforeTheTiming) {
  constexpr int kWide = 1280, kHigh = 720, kTiming = 252, kLineEnd = 46;   // pixels
  Renderer renderer(scene, kWide, kHigh);
  HudInput hud;
  const Frame without = renderer.draw(snapshot, hud, scene.camera);
  for (int i = 0; i < 12; ++i) hud.message += "left button: close ";
  const Frame with = renderer.draw(snapshot, hud, scene.camera);
  int right = 0, below = 0;                              // pixels that the message has changed beside the timing, under its first line
  for (int y = 0; y < kHigh; ++y)
    for (int x = 0; x < kWide; ++x) {
      const std::size_t at = 4 * (static_cast<std::size_t>(y) * kWide + static_cast<std::size_t>(x));
      if (std::equal(&with.rgba[at], &with.rgba[at] + 4, &without.rgba[at])) continue;
      right += x >= kWide - kTiming;
      below += y > kLineEnd;
    }
  EXPECT_EQ(right, 0);
  EXPECT_GT(below, 1000);
}

/// Two frames that differ in the instruction alone, and two that differ in a step's name alone, differ in lines of their own: three lines of an
/// instruction ran over the list of steps.
TEST_F(Picture, ALongInstructionDoesNotRunOverTheListOfSteps) {
  constexpr int kWide = 1280, kHigh = 720;
  const auto drawn = [&](const char* word, const char* step) {
    RenderScene told = scene;
    told.instructions.assign(told.stepIds.size(), "");
    for (std::string& words : told.instructions)
      for (int i = 0; i < 30; ++i) words += word;
    for (std::string& id : told.stepIds) id = "same";
    told.stepIds.front() = step;               // done, so only the list shows it
    snapshot.procedureStep = 1;
    Renderer renderer(told, kWide, kHigh);
    return renderer.draw(snapshot, HudInput{}, scene.camera);
  };
  // b and d are as wide as each other
  const Frame a = drawn("bdbd ", "take"), b = drawn("dbdb ", "take"), c = drawn("bdbd ", "bite");
  const auto differs = [&](const Frame& other, int line) {
    const std::size_t from = 4 * static_cast<std::size_t>(kWide) * line, to = from + 4 * kWide;
    return !std::equal(a.rgba.begin() + from, a.rgba.begin() + to, other.rgba.begin() + from);
  };
  int told = 0, listed = 0;                    // lines
  for (int line = 0; line < kHigh; ++line) {
    told += differs(b, line);
    listed += differs(c, line);
    EXPECT_FALSE(differs(b, line) && differs(c, line)) << "line " << line;
  }
  EXPECT_GT(told, 20);                         // three lines of letters
  EXPECT_GT(listed, 5);
}

TEST_F(Picture, GrowsNoMemoryOnceWarm) {
  Renderer renderer(scene, kWidth, kHeight);
  const auto heldAfter = [&](int frames) {
    for (int i = 0; i < frames; ++i) {
      for (Vec3& p : snapshot.tissue) p.x() += i % 2 ? 1e-4 : -1e-4;
      renderer.draw(snapshot, HudInput{}, scene.camera);
    }
    return mallinfo2().uordblks;                         // bytes in use; 0 under a sanitizer's allocator
  };
  const std::size_t warm = heldAfter(20), later = heldAfter(60);
  EXPECT_LE(later, warm + 65536);
}

TEST_F(Picture, SurvivesASnapshotThatDoesNotFitTheScene) {
  Renderer renderer(scene, kWidth, kHeight);
  RenderSnapshot odd;
  odd.procedureStep = 99;
  odd.punctureCount = 1000;
  odd.tissue.resize(3);
  odd.thread.resize(1);
  EXPECT_EQ(renderer.draw(odd, HudInput{}, scene.camera).rgba.size(), 4u * kWidth * kHeight);
  for (Vec3& p : snapshot.tissue) p.setConstant(std::nan(""));
  EXPECT_EQ(renderer.draw(snapshot, HudInput{}, scene.camera).rgba.size(), 4u * kWidth * kHeight);
}

TEST(Renderer, DrawsASceneWithNothingInIt) {
  Renderer renderer(RenderScene{}, kWidth, kHeight);
  EXPECT_EQ(renderer.draw(RenderSnapshot{}, HudInput{}, CameraView{}).rgba.size(), 4u * kWidth * kHeight);
}

TEST(Renderer, RefusesAnImpossibleSize) {
  EXPECT_THROW(Renderer(RenderScene{}, 0, 100), std::runtime_error);
  EXPECT_THROW(Renderer(RenderScene{}, 100, 100000), std::runtime_error);
}

}  // namespace
}  // namespace halsted::render
