#pragma once
/// Colours on their way into textures and vertices.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sim/types.h"

namespace halsted::render {

/// 0 to 1 as 0 to 255.
inline std::uint8_t byteOf(double x) { return static_cast<std::uint8_t>(255.0 * std::clamp(x, 0.0, 1.0) + 0.5); }   // [1]
/// Linear light as its square root: a byte then resolves dark colours as finely as the eye does.
inline std::uint8_t rootByteOf(double linear) { return byteOf(std::sqrt(std::max(linear, 0.0))); }                  // [1]
inline Vec3 mixed(const Vec3& a, const Vec3& b, double t) { return (1.0 - t) * a + t * b; }                         // [1]

}  // namespace halsted::render
