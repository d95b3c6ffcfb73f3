#pragma once
/// The body of a needling scene: its skin fitted by harmonics, the layers under it, and its acupoints.
#include "scenes/scene.h"

namespace halsted::scenes {

/// Throws InputError naming file, line and key for a surface that cannot be fitted, a layer that folds, or a point that is not there.
Body buildBody(const SceneFile&);

}  // namespace halsted::scenes
