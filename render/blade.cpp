#include "render/blade.h"

#include <algorithm>

namespace halsted::render {
namespace {

Section between(const std::vector<Section>& s, double z) {  // [m]
  std::size_t i = 1;
  while (i + 1 < s.size() && s[i].z < z) ++i;
  const double t = std::clamp((z - s[i - 1].z) / (s[i].z - s[i - 1].z), 0.0, 1.0);   // [1]
  const double e = t * t * (3.0 - 2.0 * t);                                         // [1]
  const auto mix = [&](double a, double b) { return a + (b - a) * e; };             // [m]
  return {z, mix(s[i - 1].inner, s[i].inner), mix(s[i - 1].outer, s[i].outer), mix(s[i - 1].width, s[i].width)};
}

/// Seven points around a section: three on the inner face, four on the rounded back. x is mirrored by the sign of `side`.
Vec3 blade(const Section& s, int k, double side) {          // side [1]
  static constexpr double kAlongX[7] = {0.0, 0.0, 0.0, 0.45, 1.0, 1.0, 0.45};   // [1] share of the thickness
  static constexpr double kAlongY[7] = {0.42, 0.0, -0.42, -0.5, -0.26, 0.26, 0.5};
  const double x = s.inner + (s.outer - s.inner) * kAlongX[k];                      // [m]
  return Vec3(side * x, side * kAlongY[k] * s.width, s.z);
}

}  // namespace

void addBlade(Shape& shape, const std::vector<Section>& sections, const Teeth& teeth, double side) {
  std::vector<double> z;                                    // [m]
  for (double at = sections.front().z; at < sections.back().z;
       at += at >= teeth.from && at < teeth.to ? 0.5 * teeth.pitch : at < 14e-3 ? 1.7e-3 : 4.2e-3) z.push_back(at);
  z.push_back(sections.back().z);
  const auto groove = [&](int i) { return z[i] > teeth.from && z[i] < teeth.to && i % 2 == 1; };
  Loft loft{static_cast<int>(z.size()), 7, {}, {}};
  loft.point = [&](int i, int k) {
    Section s = between(sections, z[i]);
    if (groove(i) && k < 3) s.inner += teeth.depth;
    return blade(s, k, side);
  };
  loft.color = [&](int i, int k) {
    if (z[i] < teeth.from || z[i] > teeth.to || k > 2) return kSteel;
    return groove(i) ? kGroove : kCarbide;
  };
  addLoft(shape, loft);
}

}  // namespace halsted::render
