/// buildAnatomy: procedural, or from a surface file.
#include "scenes/input_text.h"
#include "scenes/mesh_readers/surface.h"
#include "scenes/procedural_colon.h"
#include "scenes/scene.h"
#include "scenes/tube.h"

namespace halsted::scenes {

TetMesh buildAnatomy(const SceneFile& scene) {
  const AnatomyParams& anatomy = scene.params.anatomy;
  const bool real = !anatomy.mesh.empty();
  const Surface surface = real ? readSurface(anatomy.mesh, anatomy.scale) : Surface{};
  try {
    return real ? tubeSegment(surface, anatomy) : proceduralColon(anatomy);
  } catch (const InputError& error) {
    throw InputError((real ? quoted(anatomy.mesh) : quoted(scene.folder) + "/scene.toml") + ": anatomy: " + error.what());
  }
}

}  // namespace halsted::scenes
