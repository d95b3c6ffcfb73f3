/// buildAnatomy: procedural, or from a surface file.
#include "scenes/procedural_colon.h"
#include "scenes/scene.h"

namespace halsted::scenes {

TetMesh buildAnatomy(const SceneFile& scene) {
  const AnatomyParams& anatomy = scene.params.anatomy;
  if (!anatomy.mesh.empty()) throw InputError(anatomy.mesh + ": surface files are not read yet");
  try {
    return proceduralColon(anatomy);
  } catch (const InputError& error) {
    throw InputError(scene.folder + "/scene.toml: anatomy: " + error.what());
  }
}

}  // namespace halsted::scenes
