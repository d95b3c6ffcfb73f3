#pragma once
/// The one list of everything a scene file may set: dotted key, where it goes, its range and unit. The reader, `--set` and the
/// messages all work from it; a new parameter is one line in scene_fields.cpp.
#include <string>
#include <variant>
#include <vector>

#include "scenes/scene.h"

namespace halsted::scenes {

struct MaterialName { TissueParams* tissue; };  // tissue.material: a preset's name, applied to several fields at once
struct MeshPath { std::string* path; };         // anatomy.mesh: checked against the folders it may come from

using FieldSlot = std::variant<double*, int*, std::uint64_t*, std::string*, Vec3*, TissueSolver*, ThreadAssist*, ToolKind*, ModelKind*, NetProfile*, bool*, MaterialName, MeshPath>;

struct SceneField {
  std::string key;                // dotted, as in --set
  FieldSlot slot;
  double min = 0.0, max = 0.0;    // [unit] for a vector, of each component; for a string, max is its length
  const char* unit = "";
};

/// [needling] and the [anatomy] of a body.
void addNeedling(SceneFile&, std::vector<SceneField>&);

/// Slots point into `scene`, which must outlive the list. tissue.material comes before the keys it presets.
std::vector<SceneField> sceneFields(SceneFile& scene);

}  // namespace halsted::scenes
