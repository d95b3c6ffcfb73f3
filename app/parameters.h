#pragma once
/// Every parameter of a scene after presets and overrides, as "key=value" lines that `--set` reads back to the same bits. A recording
/// keeps them: a material preset edited later does not change what was recorded.
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace halsted::app {

std::vector<std::string> resolvedParameters(const scenes::SceneFile&);

}  // namespace halsted::app
