/// TubeSlicer: planes through a surface of up to millions of triangles, a few thousand times.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "scenes/tube_section.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::size_t kClusterSize = 64;
constexpr int kCurveBits = 10;     // cells of the space-filling curve per axis: 1024
constexpr double kGapShare = 0.3;  // [1] of the first wall's distance: keeps the wall gap sensible when the scale is wrong

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Morton 1966: interleaved bits of the cell, so that neighbours on the curve are neighbours in space.
std::uint32_t curvePlace(const Vec3& share) {  // [1] of the bounding box
  std::uint32_t place = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto cell = static_cast<std::uint32_t>(std::clamp(share[axis], 0.0, 1.0) * ((1 << kCurveBits) - 1));
    for (int bit = 0; bit < kCurveBits; ++bit) place |= (cell >> bit & 1u) << (3 * bit + axis);
  }
  return place;
}

/// Triangles sorted along the curve; ties by index.
std::vector<int> curveOrder(const Surface& surface) {
  Vec3 low = surface.vertices.front(), high = low;
  for (const Vec3& v : surface.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const Vec3 size = (high - low).cwiseMax(1e-12);
  std::vector<std::pair<std::uint32_t, int>> places;
  places.reserve(surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    places.emplace_back(curvePlace((surface.vertices[surface.triangles[t][0]] - low).cwiseQuotient(size)), static_cast<int>(t));
  std::sort(places.begin(), places.end());
  std::vector<int> order;
  order.reserve(places.size());
  for (const auto& [place, triangle] : places) order.push_back(triangle);
  return order;
}

/// The outermost hit of the first wall: hits within the gap behind one another are folds or the two faces of one wall.
double firstWall(std::vector<double>& hits, double gap) {  // hits, gap [m]
  if (hits.empty()) return Section::kMissing;
  std::sort(hits.begin(), hits.end());
  const double reach = std::min(gap, kGapShare * hits.front());  // [m]
  double wall = hits.front();  // [m]
  for (double hit : hits) {
    if (hit - wall > reach) break;
    wall = hit;
  }
  return wall;
}

}  // namespace

TubeSlicer::TubeSlicer(const Surface& surface, double wallGap)
    : surface_(surface), wallGap_(wallGap), order_(curveOrder(surface)) {
  for (std::size_t begin = 0; begin < order_.size(); begin += kClusterSize) {
    const std::size_t end = std::min(begin + kClusterSize, order_.size());
    Vec3 low = surface.vertices[surface.triangles[order_[begin]][0]], high = low;
    for (std::size_t i = begin; i < end; ++i)
      for (int corner : surface.triangles[order_[i]]) {
        low = low.cwiseMin(surface.vertices[corner]);
        high = high.cwiseMax(surface.vertices[corner]);
      }
    // A hair wider, so that rounding never leaves out a triangle that touches the plane.
    clusters_.push_back({static_cast<int>(begin), static_cast<int>(end), 0.5 * (low + high),
                         0.5 * (high - low) + Vec3::Constant(1e-9)});
  }
}

std::vector<TubeSlicer::Piece> TubeSlicer::slice(const SectionFrame& frame) const {
  std::vector<Piece> pieces;
  const Vec3 reach = frame.normal.cwiseAbs();
  for (const Cluster& cluster : clusters_) {
    if (std::abs((cluster.centre - frame.centre).dot(frame.normal)) > cluster.half.dot(reach)) continue;
    for (int i = cluster.begin; i < cluster.end; ++i) {
      const auto& triangle = surface_.triangles[order_[i]];
      std::array<double, 3> height;  // [m] above the plane
      for (int k = 0; k < 3; ++k) height[k] = (surface_.vertices[triangle[k]] - frame.centre).dot(frame.normal);
      Piece piece;
      int count = 0;
      for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        if ((height[k] < 0.0) == (height[next] < 0.0)) continue;
        const Vec3 &a = surface_.vertices[triangle[k]], &b = surface_.vertices[triangle[next]];
        const Vec3 at = a + height[k] / (height[k] - height[next]) * (b - a) - frame.centre;
        piece[count++] = Vec2(at.dot(frame.right), at.dot(frame.up));
      }
      if (count == 2) pieces.push_back(piece);
    }
  }
  return pieces;
}

Section TubeSlicer::cut(const SectionFrame& frame, int rays) const {
  const std::vector<Piece> pieces = slice(frame);
  Section section;
  std::vector<double> hits;  // [m]
  for (int i = 0; i < rays; ++i) {
    const double angle = 2.0 * kPi * i / rays;  // [rad]
    const Vec2 ray(cosine(angle), sine(angle));
    hits.clear();
    for (const auto& [a, b] : pieces) {
      const double sideA = cross(ray, a), sideB = cross(ray, b);  // [m]
      if ((sideA < 0.0) == (sideB < 0.0)) continue;
      const double hit = ray.dot(a + sideA / (sideA - sideB) * (b - a));  // [m]
      if (hit > 0.0) hits.push_back(hit);
    }
    section.radius.push_back(firstWall(hits, wallGap_));
  }
  return section;
}

}  // namespace halsted::scenes
