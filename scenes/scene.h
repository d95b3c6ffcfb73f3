#pragma once
/// A scene folder read from disk: `scene.toml` (anatomy, materials, tools, procedure, camera) and the anatomy built from it.
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/exchange.h"
#include "sim/params.h"
#include "sim/procedure.h"
#include "sim/anatomy.h"

namespace halsted::scenes {

/// Bad input: `what()` is one line "file:line: key: what is wrong". Exit code 2.
struct InputError : std::runtime_error { using std::runtime_error::runtime_error; };

/// What `scene.toml` says, checked, with overrides applied; nothing simulated yet.
struct SceneFile {
  std::string name;                            // folder name, e.g. "purse_string"
  std::string title, technique;
  std::string folder;                          // where it was read
  SimParams params;
  std::vector<ProcedureStep> procedure;
  CameraView camera;
  std::map<std::string, std::vector<std::string>> presets;   // [preset] NAME = ["key=value", ...]: settings that belong together
  std::string trainPreset;                     // train_preset: the one that `train` takes when none is named; empty: the scene as it is
  bool cutaway = false;                        // camera.cutaway: the picture opens with the layers cut open
  std::map<std::string, std::string> origins;  // "file:line: key" or "--set ..." of every key that was set, for messages
  std::string text;                            // the file as read, kept for the session record
  std::vector<std::string> overrides;          // "key=value" as given, kept for the session record
};

/// `overrides` are "key=value" with the dotted TOML keys, or "preset=NAME" for the settings that the scene keeps under that name ("default": none); unknown keys, wrong types and out-of-range values throw InputError.
SceneFile readScene(const std::string& folder, const std::vector<std::string>& overrides);
/// Whose word a path in an override is: typed by the user, or read from a file (then it stays inside the folder or HALSTED_DATA).
enum class PathTrust { kUser, kFile };

/// The same from text already in memory (a recorded session): `origin` stands for the file name in messages.
SceneFile parseScene(const std::string& text, const std::string& origin, const std::string& folder,
                     const std::vector<std::string>& overrides, PathTrust overridePaths = PathTrust::kUser);

/// Folders below the scenes directory that hold a scene.toml, sorted. The directory is HALSTED_SCENES, else where the build put it.
std::vector<std::string> sceneFolders();
std::string scenesDirectory();

/// The scene's anatomy: procedural, or built from `params.anatomy.mesh`. Throws InputError when the mesh is not usable.
/// A suture's: wall tetrahedra, rim centred at the origin, its plane facing +z, tube running to -z.
/// A body: the acupoint to be needled at the origin, the skin's normal there +y, the head to the surgeon's left (-x).
Anatomy buildAnatomy(const SceneFile&);
/// Where a key was set, else the scene file and the key.
std::string placeOf(const SceneFile&, const std::string& key);

}  // namespace halsted::scenes
