#include "tests/render/synthetic_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halsted::render {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;         // [rad]
constexpr double kRadius = 18e-3, kWall = 2e-3, kLength = 60e-3;   // [m] of the tube
constexpr double kBiteDepth = 6e-3;                      // [m] from the rim
constexpr int kBites = 8;

/// Haustra: pouches along the tube, parted by three bands.
double bulge(double a, double depth) {                   // [rad], [m] -> [m]
  const double pouch = std::sin(kTurn * depth / 24e-3 + 0.8 * std::sin(a)) * (0.55 - 0.45 * std::cos(3.0 * a));
  return 1.5e-3 * pouch + 0.5e-3 * std::sin(5.0 * a + 90.0 * depth);
}

Vec3 wallPoint(double a, double depth, double inward, double open) {   // [rad], [m], [m], [1]
  const double rim = std::exp(-depth / 11e-3);           // [1] how much of the gathering reaches this depth
  const double gather = 1.0 - (1.0 - open) * rim * (0.86 + 0.14 * std::cos(9.0 * a));   // [1]
  const double r = (kRadius + bulge(a, depth) - inward) * gather;                       // [m]
  const double wave = 0.8e-3 * std::sin(3.0 * a + 1.0) * rim;                           // [m] a cut end is not a plane
  return Vec3(r * std::cos(a), r * std::sin(a), -depth + wave);
}

void addTube(const SyntheticSize& size, RenderScene& scene) {
  const auto at = [&](int layer, int j, int i) { return (layer * size.along + j) * size.around + i % size.around; };
  for (int layer = 0; layer < 2; ++layer)
    for (int j = 0; j < size.along; ++j)
      for (int i = 0; i < size.around; ++i) {
        const double a = kTurn * i / size.around, depth = kLength * j / (size.along - 1);   // [rad], [m]
        scene.tissueRest.push_back(wallPoint(a, depth, layer * kWall, 1.0));
        scene.surfaceUv.emplace_back(static_cast<double>(i) / size.around, depth);
      }
  const auto quad = [&](int p, int q, int r, int s, int layer) {
    scene.surface.push_back({p, q, r});
    scene.surface.push_back({p, r, s});
    scene.triangleLayer.insert(scene.triangleLayer.end(), 2, layer);
  };
  const int last = size.along - 1;
  for (int i = 0; i < size.around; ++i) {
    for (int j = 0; j < last; ++j) {
      quad(at(0, j, i), at(0, j + 1, i), at(0, j + 1, i + 1), at(0, j, i + 1), 0);
      quad(at(1, j, i), at(1, j, i + 1), at(1, j + 1, i + 1), at(1, j + 1, i), 1);
    }
    quad(at(0, 0, i), at(0, 0, i + 1), at(1, 0, i + 1), at(1, 0, i), 2);
    quad(at(0, last, i), at(1, last, i), at(1, last, i + 1), at(0, last, i + 1), 2);
  }
}

/// Outside along the tube, in and out through the wall around the rim.
Vec3 stitch(double turn, double open) {                  // [1], [1]
  const double wave = std::sin(kTurn * kBites * turn);   // [1] > 0 outside, < 0 inside the lumen
  const double inward = wave > 0.0 ? -0.35e-3 - 0.5e-3 * wave : kWall + 0.35e-3;        // [m]
  return wallPoint(kTurn * turn, kBiteDepth, inward, open);
}

double along(const std::vector<Vec3>& line, std::vector<double>& length) {
  length.assign(1, 0.0);
  for (std::size_t i = 1; i < line.size(); ++i) length.push_back(length.back() + (line[i] - line[i - 1]).norm());
  return length.back();
}

/// `count` points at equal distances along a polyline.
std::vector<Vec3> resample(const std::vector<Vec3>& line, int count) {
  std::vector<double> length;                            // [m]
  const double total = along(line, length);              // [m]
  std::vector<Vec3> out;
  std::size_t k = 1;
  for (int i = 0; i < count; ++i) {
    const double s = total * i / (count - 1);            // [m]
    while (k + 1 < line.size() && length[k] < s) ++k;
    const double t = (s - length[k - 1]) / std::max(length[k] - length[k - 1], 1e-12);   // [1]
    out.push_back(line[k - 1] + std::clamp(t, 0.0, 1.0) * (line[k] - line[k - 1]));
  }
  return out;
}

void curve(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, std::vector<Vec3>& line) {   // cubic Bezier [m]
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.0, s = 1.0 - t;              // [1]
    line.push_back(s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
  }
}

}  // namespace

RenderScene syntheticScene(const SyntheticSize& size) {
  RenderScene scene;
  scene.name = "purse_string";
  scene.title = "Purse-string suture on an open colon end";
  addTube(size, scene);
  scene.threadNodes = size.threadNodes;
  scene.threadRadius = 0.16e-3;
  scene.needle = {26e-3 / std::numbers::pi, std::numbers::pi, 0.33e-3};
  scene.rods.push_back({Vec3(0, 0, -30e-3), Vec3(0, 0, 12e-3), 3e-3});
  scene.tools = {ToolKind::kForceps, ToolKind::kNeedleDriver};
  scene.camera = {Vec3(0, 0.05, 0.12), Vec3(0, -0.002, -0.004), Vec3::UnitY(), 40.0};
  scene.stepIds = {"take", "bites", "tails", "tighten", "check"};
  scene.instructions = {"Take the needle in the driver, two thirds from the tip.",
                        "Run the needle in and out around the rim, 5 to 7 mm apart.", "Grasp both tails.",
                        "Draw both tails until the rim lies on the anvil.", "Inspect the closure from all sides."};
  return scene;
}

Pose toolPose(const Vec3& tip, const Vec3& hand, double spin) {
  const Quat up = turnOnto(Vec3::UnitZ(), hand - tip);
  return {tip, up * Quat(Eigen::AngleAxisd(spin, Vec3::UnitZ()))};
}

RenderSnapshot syntheticSnapshot(const RenderScene& scene, double open, int bites) {
  RenderSnapshot s;
  s.step = 41250;
  s.time = 41.25;
  for (std::size_t i = 0; i < scene.tissueRest.size(); ++i) {
    const double a = kTurn * scene.surfaceUv[i].x();     // [rad]
    s.tissue.push_back(wallPoint(a, scene.surfaceUv[i].y(), i < scene.tissueRest.size() / 2 ? 0.0 : kWall, open));
  }
  const double from = 0.80, to = from + bites / static_cast<double>(kBites);             // [1] turns around the rim
  std::vector<Vec3> line;
  const Vec3 entry = stitch(from, open), exit = stitch(to, open);
  curve(Vec3(0.030, -0.062, -0.016), Vec3(0.052, -0.044, 0.0), Vec3(0.020, -0.036, 0.004), entry, line);
  for (double t = from; t <= to; t += 0.002) line.push_back(stitch(t, open));
  const Vec3 outward = Vec3(exit.x(), exit.y(), 0).normalized();
  const Vec3 needleAt = exit + 0.016 * outward + Vec3(0.004, 0.004, 0.014);
  s.needle = {needleAt, Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX())) * Quat(Eigen::AngleAxisd(2.3, Vec3::UnitZ()))};
  const Vec3 swage = s.needle.apply(scene.needle.radius * Vec3::UnitX());
  curve(exit, exit + 0.02 * outward + Vec3(0, 0, 0.006), swage + Vec3(0.03, -0.03, 0.0), swage, line);
  s.thread = resample(line, scene.threadNodes);
  for (int i = 0; i < scene.threadNodes; ++i) s.twist.push_back(0.04 * i);
  for (int b = 0; b < 2 * bites; ++b)
    s.punctures.push_back(wallPoint(kTurn * (from + 0.5 * b / kBites), kBiteDepth, 0.0, open));
  s.punctureCount = static_cast<int>(s.punctures.size());
  const double grip = 0.35 * scene.needle.angle;         // [rad] a third of the arc from the swage
  const Vec3 held = s.needle.apply(scene.needle.radius * Vec3(std::cos(grip), std::sin(grip), 0));
  s.tools[kRight] = {toolPose(held, Vec3(0.13, 0.05, 0.12), 0.4), 0.06, Vec3(0.2, -0.5, 0.1)};
  const Vec3 lip = wallPoint(2.75, 1.5e-3, 0.5 * kWall, open);
  s.tools[kLeft] = {toolPose(lip, Vec3(-0.13, 0.045, 0.10), 1.2), 0.45, Vec3(-0.8, 1.2, 0.3)};
  s.procedureStep = 1;
  s.bites = static_cast<std::uint32_t>(bites);
  s.openingArea = std::numbers::pi * (kRadius - kWall) * (kRadius - kWall) * open * open;
  s.threadTension = 0.42;
  return s;
}

CameraView closeCamera() { return {Vec3(0.018, 0.03, 0.05), Vec3(0.004, 0.0, 0.0), Vec3::UnitY(), 36.0}; }

}  // namespace halsted::render
