#pragma once
/// What surgical instruments are drawn of: blades swept along their length, and the colours of their metals.
#include <array>
#include <numbers>
#include <vector>

#include "render/shape.h"

namespace halsted::render {

using Color = std::array<double, 3>;
inline constexpr Color kSteel{0.78, 0.80, 0.82};        // linear reflectance [1]
inline constexpr Color kCarbide{0.34, 0.34, 0.36};      // jaw insert
inline constexpr Color kGroove{0.16, 0.16, 0.17};
inline constexpr Color kGold{0.83, 0.62, 0.26};         // gold rings mark tungsten-carbide jaws
inline constexpr double kDegree = std::numbers::pi / 180.0;   // [rad]

/// A cross-section of a blade: a box with rounded outside corners.
struct Section {
  double z = 0.0, inner = 0.0, outer = 0.0, width = 0.0;   // [m] position up the shaft; x of both faces; full size along y
};

/// Serration of the inner face.
struct Teeth { double from = 0.0, to = 0.0, pitch = 1.0, depth = 0.0; };   // [m] along z

/// Along +z through its sections; x is mirrored by the sign of `side`.
void addBlade(Shape&, const std::vector<Section>&, const Teeth&, double side);   // side [1]

}  // namespace halsted::render
