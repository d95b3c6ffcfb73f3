#pragma once
/// A scene folder read from disk: `scene.toml` (anatomy, materials, tools, procedure, camera) and the anatomy built from it.
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/exchange.h"
#include "sim/params.h"
#include "sim/procedure.h"
#include "sim/mesh.h"

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
  std::string text;                            // the file as read, kept for the session record
  std::vector<std::string> overrides;          // "key=value" as given, kept for the session record
};

/// `overrides` are "key=value" with the dotted TOML keys; unknown keys, wrong types and out-of-range values throw InputError.
SceneFile readScene(const std::string& folder, const std::vector<std::string>& overrides);
/// Whose word a path in an override is: typed by the user, or read from a file (then it stays inside the folder or HALSTED_DATA).
enum class PathTrust { kUser, kFile };

/// The same from text already in memory (a recorded session): `origin` stands for the file name in messages.
SceneFile parseScene(const std::string& text, const std::string& origin, const std::string& folder,
                     const std::vector<std::string>& overrides, PathTrust overridePaths = PathTrust::kUser);

/// Folders below the scenes directory that hold a scene.toml, sorted. The directory is HALSTED_SCENES, else where the build put it.
std::vector<std::string> sceneFolders();
std::string scenesDirectory();

/// Wall tetrahedra of the scene's anatomy: procedural, or built from `params.anatomy.mesh`. Rim centred at the origin, its plane
/// facing +z, tube running to -z. Throws InputError when the mesh is not a usable tube.
TetMesh buildAnatomy(const SceneFile&);

}  // namespace halsted::scenes
