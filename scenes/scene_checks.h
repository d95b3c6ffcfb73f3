#pragma once
/// Checks that need more than one value of a scene, after the file and all overrides were read.
#include <map>
#include <string>

#include "scenes/scene.h"

namespace halsted::scenes {

/// Where each key was set last: "file:line: key" or "--set key=value".
using SettingOrigins = std::map<std::string, std::string>;

/// A recorded anatomy was checked when it was built, with a mesh that may be gone.
enum class AnatomyIs { kToBeBuilt, kRecorded };

/// Throws InputError naming the place of the value that was set last among those that do not fit together.
void checkScene(const SceneFile&, const std::string& origin, const SettingOrigins&, AnatomyIs);

}  // namespace halsted::scenes
