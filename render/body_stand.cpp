#include "render/body_stand.h"

#include <algorithm>
#include <cmath>

namespace halsted::render {

const AcupointMark* targetOf(const LayeredBody& body) {
  return body.target >= 0 && body.target < static_cast<int>(body.points.size()) ? &body.points[static_cast<std::size_t>(body.target)] : nullptr;
}

Stand::Stand(const RenderScene& scene) {
  Vec3 up = scene.camera.up.normalized();
  if (const AcupointMark* target = targetOf(scene.body)) {
    origin = target->place;
    up = target->normal.normalized();
  }
  Vec3 toViewer = scene.camera.eye - origin;
  toViewer -= toViewer.dot(up) * up;
  if (toViewer.squaredNorm() < 1e-12) toViewer = up.cross(std::abs(up.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY());
  toViewer.normalize();
  turn << toViewer.cross(up).transpose(), toViewer.transpose(), up.transpose();
}

std::vector<Vec3> placed(const Stand& stand, const std::vector<Vec3>& world) {   // [m]
  std::vector<Vec3> out(world.size());
  std::transform(world.begin(), world.end(), out.begin(), [&](const Vec3& p) { return stand.place(p); });
  return out;
}

Shape makeSheet(double height) {                         // [m]
  constexpr float kHalf = 0.9f, kTile = 0.2f;            // [m]
  Shape shape;
  for (int k = 0; k < 4; ++k) {
    const float x = k == 1 || k == 2 ? kHalf : -kHalf, y = k > 1 ? kHalf : -kHalf;   // [m]
    shape.vertices.push_back({{x, y, static_cast<float>(height)}, {0, 0, 1}, {x / kTile, y / kTile}, {255, 255, 255, 255}});
  }
  shape.indices = {0, 1, 2, 0, 2, 3};
  return shape;
}

}  // namespace halsted::render
