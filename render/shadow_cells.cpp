#include "render/shadow_cells.h"

#include <algorithm>
#include <cmath>

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
    : triangles_(ground.indices), mask_(static_cast<std::size_t>(kMaskCells) * kMaskCells) {
  indices_.reserve(triangles_.size());
  for (std::size_t i = 0; i + 5 < triangles_.size(); i += 6) {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;   // [m]
    for (std::size_t k = i; k < i + 6; ++k) {
      const float* p = ground.vertices[triangles_[k]].position;       // [m]
      const Eigen::Vector2d at = plane_.at(Vec3(p[0], p[1], p[2]));
      low = low.cwiseMin(at);
      high = high.cwiseMax(at);
    }
    patches_.push_back(boxOf(low, high));
  }
}

ShadowCells::Box ShadowCells::boxOf(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  return {cellAt(low.x()), cellAt(low.y()), cellAt(high.x()), cellAt(high.y())};
}

void ShadowCells::clear() { std::fill(mask_.begin(), mask_.end(), std::uint8_t{0}); }

void ShadowCells::mark(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  const bool inside = low.x() > -kMaskHalf && low.y() > -kMaskHalf && high.x() < kMaskHalf && high.y() < kMaskHalf;
  if (!inside) return;                                   // far off, or not a number
  const Box box = boxOf(low, high);
  for (int v = box.v0; v <= box.v1; ++v)
    std::fill_n(&mask_[static_cast<std::size_t>(v) * kMaskCells + box.u0], box.u1 - box.u0 + 1, std::uint8_t{1});
}

void ShadowCells::add(const Vec3& caster, double radius) {
  const Eigen::Vector2d at = plane_.at(caster), reach = Eigen::Vector2d::Constant(radius + kSoft);   // [m]
  mark(at - reach, at + reach);
}

void ShadowCells::add(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Eigen::Vector2d p = plane_.at(a), q = plane_.at(b), r = plane_.at(c), soft(kSoft, kSoft);      // [m]
  mark(p.cwiseMin(q).cwiseMin(r) - soft, p.cwiseMax(q).cwiseMax(r) + soft);
}

void ShadowCells::add(const std::vector<Vec3>& corners, const Eigen::Matrix4d& stand) {
  const Mat3 turn = stand.topLeftCorner<3, 3>();                               // [1]
  const Vec3 u = turn.transpose() * plane_.first, v = turn.transpose() * plane_.second;    // [1] across the light, as the thing sees it
  const Eigen::Vector2d origin = plane_.at(stand.topRightCorner<3, 1>()), soft(kSoft, kSoft);   // [m]
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9), high = -low;   // [m]
    for (std::size_t k = i; k < i + 3; ++k) {
      const Eigen::Vector2d at = origin + Eigen::Vector2d(corners[k].dot(u), corners[k].dot(v));
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
