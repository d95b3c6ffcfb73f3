#include "render/shadow_cells.h"

#include <algorithm>
#include <cmath>

#include "render/light.h"

namespace halsted::render {
namespace {

constexpr double kMaskHalf = 0.24, kMaskCell = 1.5e-3;   // [m] reaches past the corners of the ground
constexpr int kMaskCells = static_cast<int>(2.0 * kMaskHalf / kMaskCell);
constexpr double kSoft = 0.4e-3;                         // [m] what filtering adds to a shadow: two texels of the map

int cellAt(double x) {                                   // [m]
  return static_cast<int>(std::clamp((x + kMaskHalf) / kMaskCell, 0.0, kMaskCells - 1.0));
}

}  // namespace

ShadowCells::ShadowCells(const Shape& ground)
    : first_(Vec3::UnitX().cross(lightDirection()).normalized()), second_(lightDirection().cross(first_)), triangles_(ground.indices),
      mask_(static_cast<std::size_t>(kMaskCells) * kMaskCells) {
  indices_.reserve(triangles_.size());
  for (std::size_t i = 0; i + 5 < triangles_.size(); i += 6) {
    Vec3 low = Vec3::Constant(1e9), high = -low;         // [m]
    for (std::size_t k = i; k < i + 6; ++k) {
      const float* p = ground.vertices[triangles_[k]].position;       // [m]
      const Vec3 at = alongLight(Vec3(p[0], p[1], p[2]));
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    patches_.push_back(boxOf(low, high));
  }
}

Vec3 ShadowCells::alongLight(const Vec3& p) const { return Vec3(p.dot(first_), p.dot(second_), 0.0); }

ShadowCells::Box ShadowCells::boxOf(const Vec3& low, const Vec3& high) {
  return {cellAt(low.x()), cellAt(low.y()), cellAt(high.x()), cellAt(high.y())};
}

void ShadowCells::clear() { std::fill(mask_.begin(), mask_.end(), std::uint8_t{0}); }

void ShadowCells::mark(const Vec3& low, const Vec3& high) {
  const bool inside = low.x() > -kMaskHalf && low.y() > -kMaskHalf && high.x() < kMaskHalf && high.y() < kMaskHalf;
  if (!inside) return;                                   // far off, or not a number
  const Box box = boxOf(low, high);
  for (int v = box.v0; v <= box.v1; ++v)
    std::fill_n(&mask_[static_cast<std::size_t>(v) * kMaskCells + box.u0], box.u1 - box.u0 + 1, std::uint8_t{1});
}

void ShadowCells::add(const Vec3& caster, double radius) {
  const Vec3 at = alongLight(caster), reach = Vec3::Constant(radius + kSoft);  // [m]
  mark(at - reach, at + reach);
}

void ShadowCells::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 p = alongLight(a), q = alongLight(b), r = alongLight(c), soft = Vec3::Constant(kSoft);   // [m]
  mark(p.cwiseMin(q).cwiseMin(r) - soft, p.cwiseMax(q).cwiseMax(r) + soft);
}

void ShadowCells::add(const std::vector<Vec3>& corners, const Eigen::Matrix4d& stand) {
  const Mat3 turn = stand.topLeftCorner<3, 3>();                               // [1]
  const Vec3 u = turn.transpose() * first_, v = turn.transpose() * second_;    // [1] across the light, as the thing sees it
  const Vec3 origin = alongLight(stand.topRightCorner<3, 1>()), soft(kSoft, kSoft, 0.0);   // [m]
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    Vec3 low = Vec3::Constant(1e9), high = -low;         // [m]
    for (std::size_t k = i; k < i + 3; ++k) {
      const Vec3 at = origin + Vec3(corners[k].dot(u), corners[k].dot(v), 0.0);
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    mark(low - soft, high + soft);
  }
}

bool ShadowCells::covered(const Box& box) const {
  for (int v = box.v0; v <= box.v1; ++v)
    for (int u = box.u0; u <= box.u1; ++u)
      if (mask_[static_cast<std::size_t>(v) * kMaskCells + u]) return true;
  return false;
}

const std::vector<std::uint32_t>& ShadowCells::indices() {
  indices_.clear();
  for (std::size_t i = 0; i < patches_.size(); ++i)
    if (covered(patches_[i])) indices_.insert(indices_.end(), &triangles_[6 * i], &triangles_[6 * i] + 6);
  return indices_;
}

}  // namespace halsted::render
