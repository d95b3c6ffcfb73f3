#pragma once
/// The one operating lamp, the same for shaders, baked pictures and the shadow map.
#include "sim/types.h"

namespace halsted::render {

/// Unit vector toward the lamp: behind the surgeon's head, above and to the right.
inline Vec3 lightDirection() { return Vec3(0.34, 0.56, 0.756).normalized(); }

}  // namespace halsted::render
