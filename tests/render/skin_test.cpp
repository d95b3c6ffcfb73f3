// Laws of the visible surface: an affine, rigid-exact function of the particles that passes near them.
#include <gtest/gtest.h>

#include <cmath>

#include "render/skin.h"
#include "tests/render/synthetic_scene.h"

namespace halsted::render {
namespace {

constexpr std::size_t kBudget = 16000;

Skin skinOf(const RenderScene& scene, std::size_t budget = kBudget) {
  return buildSkin(scene.surface, scene.triangleLayer, scene.surfaceUv, scene.tissueRest.size(), budget);
}

Vec3 pointOf(const SkinPose& pose, std::uint32_t row) { return Vec3(pose.point(row)[0], pose.point(row)[1], pose.point(row)[2]); }

TEST(Skin, WeightsOfEveryPointAddUpToOne) {
  const Skin skin = skinOf(syntheticScene());
  for (std::size_t r = 0; r + 1 < skin.weights.start.size(); ++r) {
    double sum = 0.0;                                    // [1]
    for (std::uint32_t j = skin.weights.start[r]; j < skin.weights.start[r + 1]; ++j) sum += skin.weights.weight[j];
    ASSERT_NEAR(sum, 1.0, 2e-6) << "point " << r;
  }
}

TEST(Skin, FollowsARigidMotionExactly) {
  const RenderScene scene = syntheticScene();
  const Skin skin = skinOf(scene);
  SkinPose rest(skin), moved(skin);
  rest.update(skin, scene.tissueRest);
  const Pose motion{Vec3(0.03, -0.02, 0.05), Quat(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()))};
  std::vector<Vec3> particles;
  for (const Vec3& p : scene.tissueRest) particles.push_back(motion.apply(p));
  moved.update(skin, particles);
  for (std::uint32_t r = 0; r + 1 < skin.weights.start.size(); ++r)
    ASSERT_LT((pointOf(moved, r) - motion.apply(pointOf(rest, r))).norm(), 5e-7) << "point " << r;   // [m] float rounding
}

TEST(Skin, IsFinerThanThePhysicsMesh) {
  const RenderScene scene = syntheticScene();
  const Skin skin = skinOf(scene);
  EXPECT_GE(skin.triangles.size(), 4 * scene.surface.size());
  EXPECT_LE(skin.triangles.size(), kBudget);
}

TEST(Skin, StaysWithinATenthOfAMillimetreOfTheParticles) {
  const RenderScene scene = syntheticScene();
  const Skin skin = skinOf(scene);
  SkinPose pose(skin);
  pose.update(skin, scene.tissueRest);
  double worst = 0.0;                                    // [m] the first points of the skin are the particles'
  for (std::uint32_t v = 0; v < scene.tissueRest.size(); ++v) worst = std::max(worst, (pointOf(pose, v) - scene.tissueRest[v]).norm());
  EXPECT_LT(worst, 1e-4);
}

TEST(Skin, NormalsOfTheOutsidePointAwayFromTheAxis) {
  const RenderScene scene = syntheticScene();
  const Skin skin = skinOf(scene);
  SkinPose pose(skin);
  pose.update(skin, scene.tissueRest);
  for (const SkinCorner& c : skin.corners) {
    if (c.layer == 2) continue;
    const Vec3 p = pointOf(pose, c.point);
    const float* n = pose.normal(c.normalSlot);          // [1]
    const double outward = p.x() * n[0] + p.y() * n[1];  // [m]
    ASSERT_GT(c.layer == 0 ? outward : -outward, 0.0);
  }
}

TEST(Skin, KeepsTextureCoordinatesContinuousAcrossTheSeam) {
  const Skin skin = skinOf(syntheticScene());
  for (const auto& t : skin.triangles) {
    const float a = skin.corners[t[0]].uv[0], b = skin.corners[t[1]].uv[0], c = skin.corners[t[2]].uv[0];   // [1]
    ASSERT_LT(std::max({a, b, c}) - std::min({a, b, c}), 0.1f);
  }
}

/// The organ without what lies above a height, and what is above carried 80 mm away.
struct TornSkin {
  explicit TornSkin(double height) : shown(scene.surface.size(), 1), seen(scene.tissueRest.size(), 0), particles(scene.tissueRest) {   // [m]
    for (std::size_t t = 0; t < scene.surface.size(); ++t) {
      for (int v : scene.surface[t])
        if (scene.tissueRest[v].z() > height) shown[t] = 0;
      for (int v : scene.surface[t]) seen[v] |= shown[t];
    }
    for (std::size_t v = 0; v < particles.size(); ++v)
      if (!seen[v]) particles[v].x() += 80e-3;
    allowCuts(scene.surface, particles.size(), skin);
    SkinPose rest(skin);
    rest.update(skin, scene.tissueRest);
    pose.update(skin, scene.tissueRest);
    pose.tear(skin, scene.surface, shown);
    pose.update(skin, particles);
    for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
      if (!shown[skin.surfaceTriangleOf(t)]) continue;
      ++drawn;
      for (std::uint32_t c : skin.triangles[t]) farthest = std::max(farthest, (pointOf(pose, skin.corners[c].point) - pointOf(rest, skin.corners[c].point)).norm());
    }
  }
  RenderScene scene = syntheticScene();
  Skin skin = skinOf(scene);
  SkinPose pose{skin};
  std::vector<std::uint8_t> shown, seen;
  std::vector<Vec3> particles;                           // [m]
  double farthest = 0.0;                                 // [m] that a drawn point has gone from where it was
  int drawn = 0;
};

double middleHeight() {                                  // [m]
  double sum = 0.0;
  const RenderScene scene = syntheticScene();
  for (const Vec3& p : scene.tissueRest) sum += p.z() / static_cast<double>(scene.tissueRest.size());
  return sum;
}

TEST(Skin, ACutEdgeDoesNotFollowWhatIsCarriedAway) {
  const TornSkin torn(middleHeight());
  ASSERT_GT(torn.drawn, 100);
  ASSERT_LT(torn.drawn, static_cast<int>(torn.skin.triangles.size()) - 100);
  EXPECT_LT(torn.farthest, 1e-3);                        // [m] from the smooth surface to the flat triangles
}

TEST(Skin, MeetsTheFacesOfACutAtTheParticles) {
  const TornSkin torn(middleHeight());
  int edge = 0;
  for (std::size_t t = 0; t < torn.shown.size(); ++t)
    for (int v : torn.scene.surface[t]) {
      if (torn.shown[t] || !torn.seen[v]) continue;      // on the edge between what is gone and what is left
      ++edge;
      ASSERT_LT((pointOf(torn.pose, static_cast<std::uint32_t>(v)) - torn.particles[v]).norm(), 1e-7);   // [m] rounding
    }
  EXPECT_GT(edge, 20);
}

TEST(Skin, RefusesATriangleOfAParticleThatDoesNotExist) {
  RenderScene scene = syntheticScene();
  scene.surface.front()[1] = static_cast<int>(scene.tissueRest.size());
  EXPECT_THROW(skinOf(scene), std::invalid_argument);
}

}  // namespace
}  // namespace halsted::render
