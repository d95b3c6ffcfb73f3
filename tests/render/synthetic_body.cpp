#include "tests/render/synthetic_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halsted::render {
namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;         // [rad]
constexpr int kSectors = 32, kRings = 34, kPerSheet = 1 + kSectors * kRings;
constexpr double kBall = 0.15, kFinest = 0.1e-3, kGrowth = 1.22;   // [m] [m] [1]
constexpr double kBelow[4] = {0.0, 0.8e-3, 9.2e-3, 24e-3};         // [m] tops of skin, fat, muscle; floor of the cut
constexpr int kCut[3] = {28, 26, 23};                    // rings to which each layer is cut away

/// World: y up, the target at the origin on top of a ball.
Vec3 placeOn(int sheet, int ring, int sector) {
  const double r = ring < 0 ? 0.0 : kFinest * std::pow(kGrowth, ring), a = kFullTurn * sector / kSectors;   // [m] [rad]
  const double tilt = r / kBall, radius = kBall - kBelow[sheet];                                        // [rad] [m]
  return Vec3(-radius * std::sin(tilt) * std::cos(a), radius * std::cos(tilt) - kBall, radius * std::sin(tilt) * std::sin(a));
}

int at(int sheet, int ring, int sector) { return sheet * kPerSheet + (ring < 0 ? 0 : 1 + ring * kSectors + sector % kSectors); }

struct Part { TissueLook look; Shown shown; };

void addQuad(RenderScene& scene, const std::array<int, 4>& v, const Part& part) {
  for (const std::array<int, 3>& t : {std::array<int, 3>{v[0], v[1], v[2]}, std::array<int, 3>{v[0], v[2], v[3]}}) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    scene.surface.push_back(t);
    scene.triangleLayer.push_back(static_cast<int>(part.look));
    scene.body.shown.push_back(static_cast<std::uint8_t>(part.shown));
  }
}

void addSheet(RenderScene& scene, int sheet, std::array<int, 2> rings, std::array<int, 2> sectors, const Part& part) {
  for (int r = rings[0]; r < rings[1]; ++r)
    for (int s = sectors[0]; s < sectors[1]; ++s)
      addQuad(scene, {at(sheet, r, s), at(sheet, r + 1, s), at(sheet, r + 1, s + 1), at(sheet, r, s + 1)}, part);
}

void addWalls(RenderScene& scene, int sheet, const Part& part) {
  constexpr int h = kSectors / 2;
  const int ring = kCut[sheet];
  for (int r = -1; r < ring; ++r) {
    addQuad(scene, {at(sheet, r, 0), at(sheet, r + 1, 0), at(sheet + 1, r + 1, 0), at(sheet + 1, r, 0)}, part);
    addQuad(scene, {at(sheet, r, h), at(sheet + 1, r, h), at(sheet + 1, r + 1, h), at(sheet, r + 1, h)}, part);
  }
  for (int s = 0; s < h; ++s)
    addQuad(scene, {at(sheet, ring, s), at(sheet, ring, s + 1), at(sheet + 1, ring, s + 1), at(sheet + 1, ring, s)}, part);
}

}  // namespace

RenderScene syntheticBody() {
  RenderScene scene;
  scene.name = "body";
  scene.title = "Acupuncture";
  for (int sheet = 0; sheet < 4; ++sheet) {
    scene.tissueRest.push_back(placeOn(sheet, -1, 0));
    for (int ring = 0; ring < kRings; ++ring)
      for (int s = 0; s < kSectors; ++s) scene.tissueRest.push_back(placeOn(sheet, ring, s));
  }
  scene.surfaceUv.assign(scene.tissueRest.size(), Eigen::Vector2d::Zero());
  constexpr int h = kSectors / 2;
  addSheet(scene, 0, {-1, kCut[0]}, {0, h}, {TissueLook::kSkin, Shown::kWhole});
  addSheet(scene, 0, {-1, kCut[0]}, {h, kSectors}, {TissueLook::kSkin, Shown::kAlways});
  addSheet(scene, 0, {kCut[0], kRings - 1}, {0, kSectors}, {TissueLook::kSkin, Shown::kAlways});
  addSheet(scene, 1, {kCut[1], kCut[0]}, {0, h}, {TissueLook::kFat, Shown::kCutaway});
  addSheet(scene, 2, {kCut[2], kCut[1]}, {0, h}, {TissueLook::kMuscle, Shown::kCutaway});
  addSheet(scene, 3, {-1, kCut[2]}, {0, h}, {TissueLook::kMuscleSection, Shown::kCutaway});
  addWalls(scene, 0, {TissueLook::kSkinSection, Shown::kCutaway});
  addWalls(scene, 1, {TissueLook::kFatSection, Shown::kCutaway});
  addWalls(scene, 2, {TissueLook::kMuscleSection, Shown::kCutaway});
  scene.body.layers = 3;
  scene.body.target = 0;
  scene.body.points = {{"P1", "top", Vec3::Zero(), Vec3::UnitY(), 20e-3, 0.25 * kFullTurn}, {"P2", "aside", placeOn(0, 28, 24), Vec3(0, 1, 0), 10e-3, 0.25 * kFullTurn}};
  scene.straightNeedle = {40e-3, 0.125e-3, 25e-3, 0.5e-3};
  scene.fingerRadius = 8e-3;
  scene.tools = {ToolKind::kFinger, ToolKind::kAcupunctureNeedle};
  scene.camera = {Vec3(0.03, 0.09, 0.12), Vec3(0, -4e-3, 0), Vec3::UnitY(), 32.0};
  return scene;
}

RenderSnapshot syntheticNeedling(const RenderScene& scene, double depth, double dimple) {
  RenderSnapshot s;
  s.tissue = scene.tissueRest;
  constexpr double kCore = 0.5e-3;                       // [m] half width of the dent
  for (Vec3& p : s.tissue) p.y() -= dimple * kCore / std::max(kCore, std::hypot(p.x(), p.z()));
  const Quat up = turnOnto(Vec3::UnitZ(), Vec3::UnitY());
  s.tools[kLeft].pose = {placeOn(0, 27, 1), up};
  s.tools[kRight].pose = {Vec3(0, -depth, 0), up};
  s.needling.depth = depth;
  s.needling.angle = 0.25 * kFullTurn;
  s.needling.dimple = {dimple, dimple, dimple};
  for (int k = 0; k < 3; ++k) {
    s.needling.inside[k] = std::clamp(depth - kBelow[k], 0.0, kBelow[k + 1] - kBelow[k]);
    s.needling.punctured += s.needling.inside[k] > 0.0;
  }
  return s;
}

}  // namespace halsted::render
