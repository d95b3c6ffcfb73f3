#pragma once
/// Which folder a scene's name means, and a scene as a session file keeps it. Any thread.
#include <string>
#include <vector>

#include "scenes/scene.h"

namespace halsted::scenes {

/// The folder of an installed scene of this name; empty: none.
std::string installedScene(const std::string& name);
/// Names of the installed scenes, for messages.
std::string knownScenes();
/// What the user means by a word: an installed scene's name, whatever folder the user stands in; else a folder that holds a scene.toml.
/// Throws InputError when it is neither.
std::string findScene(const std::string& scene);

/// What a session file says of its scene.
struct RecordedScene {
  std::string name, text;                      // folder name; scene.toml as it was read then
  std::vector<std::string> settings;           // --set as given then
  std::vector<std::string> parameters;         // "key=value", resolved: these hold, whatever the text says
};

/// The scene as it was, with `overrides` of today over it. Opens no file that the text names, a mesh or a material: what came of them is in
/// the session. `otherAnatomy`: the overrides ask for another than was recorded, and buildAnatomy gives it. `origin`: the session file, for
/// messages. Throws InputError, also where another anatomy cannot be built from what the session holds.
SceneFile parseRecordedScene(const RecordedScene&, const std::string& origin, const std::vector<std::string>& overrides, bool& otherAnatomy);

}  // namespace halsted::scenes
