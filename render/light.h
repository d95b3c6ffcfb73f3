#pragma once
/// The one operating lamp, the same for shaders, baked pictures and the shadow map.
#include "sim/types.h"

namespace halsted::render {

/// Unit vector toward the lamp: behind the surgeon's head, above and to the right.
inline Vec3 lightDirection() { return Vec3(0.34, 0.56, 0.756).normalized(); }

/// The plane across the lamp's parallel light, in which a thing lies over its shadow.
struct LampPlane {
  Vec3 first = Vec3::UnitX().cross(lightDirection()).normalized(), second = lightDirection().cross(first);   // [1] its axes
  Eigen::Vector2d at(const Vec3& p) const { return {p.dot(first), p.dot(second)}; }                          // [m]
};

}  // namespace halsted::render
