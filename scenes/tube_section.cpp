#include "scenes/tube_section.h"

#include <algorithm>
#include <cmath>

#include "sim/portable_math.h"

namespace halsted::scenes {

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

}  // namespace halsted::scenes
