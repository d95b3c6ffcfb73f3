#include "scenes/tube_section.h"

#include <algorithm>
#include <cmath>

#include "scenes/portable_math.h"

namespace halsted::scenes {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr double kGapShare = 0.3;  // [1] of the first wall's distance: keeps the wall gap sensible when the scale is wrong

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Where the plane cuts the surface, as pieces in the plane's own coordinates [m].
std::vector<std::array<Vec2, 2>> slice(const Surface& surface, const SectionFrame& frame) {
  std::vector<double> height(surface.vertices.size());  // [m] above the plane
  for (std::size_t v = 0; v < height.size(); ++v) height[v] = (surface.vertices[v] - frame.centre).dot(frame.normal);
  std::vector<std::array<Vec2, 2>> pieces;
  for (const auto& t : surface.triangles) {
    const bool above = height[t[0]] < 0.0;
    if ((height[t[1]] < 0.0) == above && (height[t[2]] < 0.0) == above) continue;
    std::array<Vec2, 2> piece;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if ((height[a] < 0.0) == (height[b] < 0.0)) continue;
      const Vec3 at = surface.vertices[a] + height[a] / (height[a] - height[b]) * (surface.vertices[b] - surface.vertices[a]);
      piece[count++] = Vec2((at - frame.centre).dot(frame.right), (at - frame.centre).dot(frame.up));
    }
    pieces.push_back(piece);
  }
  return pieces;
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

SectionFrame transported(const SectionFrame& from, const Vec3& centre, const Vec3& normal) {
  SectionFrame frame;
  frame.centre = centre;
  frame.normal = normal;
  frame.right = (from.right - from.right.dot(normal) * normal).normalized();
  frame.up = normal.cross(frame.right);
  return frame;
}

SectionFrame uprightFrame(const Vec3& centre, const Vec3& normal) {
  constexpr double kAlong = 0.9;  // [1] cosine
  const Vec3 wanted = std::abs(normal.y()) < kAlong ? Vec3::UnitY() : Vec3(-Vec3::UnitZ());
  SectionFrame frame;
  frame.centre = centre;
  frame.normal = normal;
  frame.up = (wanted - wanted.dot(normal) * normal).normalized();
  frame.right = frame.up.cross(normal);
  return frame;
}

int Section::missing() const { return static_cast<int>(std::count(radius.begin(), radius.end(), kMissing)); }

void Section::dropBeyond(double longest) {
  for (double& r : radius)
    if (r > longest) r = kMissing;
}

void Section::fill() {
  const int rays = static_cast<int>(radius.size());
  const std::vector<double> measured = radius;  // [m]
  for (int i = 0; i < rays; ++i) {
    if (measured[i] != kMissing) continue;
    int before = 1, after = 1;
    while (before < rays && measured[(i - before + rays) % rays] == kMissing) ++before;
    while (after < rays && measured[(i + after) % rays] == kMissing) ++after;
    const double share = static_cast<double>(before) / (before + after);  // [1]
    radius[i] = (1.0 - share) * measured[(i - before + rays) % rays] + share * measured[(i + after) % rays];
  }
}

double Section::meanRadius() const {
  double squares = 0.0;  // [m^2]
  for (double r : radius) squares += r * r;
  return std::sqrt(squares / static_cast<double>(radius.size()));
}

Vec3 Section::centroid(const SectionFrame& frame) const {
  double cubesRight = 0.0, cubesUp = 0.0, squares = 0.0;  // [m^3], [m^3], [m^2]
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(radius.size());  // [rad]
    cubesRight += radius[i] * radius[i] * radius[i] * cosine(angle);
    cubesUp += radius[i] * radius[i] * radius[i] * sine(angle);
    squares += radius[i] * radius[i];
  }
  return frame.centre + (2.0 / 3.0) * (cubesRight * frame.right + cubesUp * frame.up) / squares;
}

Section TubeSlicer::cut(const SectionFrame& frame, int rays) const {
  const std::vector<std::array<Vec2, 2>> pieces = slice(surface_, frame);
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
