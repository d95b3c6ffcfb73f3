/// buildAnatomy: procedural, or from a surface file.
#include "scenes/acupuncture/body.h"
#include "scenes/input_text.h"
#include "scenes/mesh_readers/surface.h"
#include "scenes/procedural_colon.h"
#include "scenes/prolapse.h"
#include "scenes/scene.h"
#include "scenes/tube.h"
#include "scenes/two_ends.h"

namespace halsted::scenes {

namespace {

TetMesh buildWall(const SceneFile& scene) {
  const AnatomyParams& anatomy = scene.params.anatomy;
  const bool real = !anatomy.mesh.empty();
  const Surface surface = real ? readSurface(anatomy.mesh, anatomy.scale) : Surface{};
  try {
    if (anatomy.layout == "prolapse" && !real) return prolapse(anatomy);
    const TetMesh one = real ? tubeSegment(surface, anatomy) : proceduralColon(anatomy);
    if (anatomy.layout == "prolapse") return prolapse(anatomy, crossSection(one, anatomy));
    if (anatomy.layout == "two_ends") return twoEnds(one, anatomy.gap);
    return anatomy.layout == "end_to_end" ? endToEnd(one, anatomy.gap) : one;
  } catch (const InputError& error) {
    throw InputError((real ? quoted(anatomy.mesh) : quoted(scene.folder) + "/scene.toml") + ": anatomy: " + error.what());
  }
}

}  // namespace

std::string placeOf(const SceneFile& scene, const std::string& key) {
  const auto found = scene.origins.find(key);
  return found != scene.origins.end() ? found->second : quoted(scene.folder) + "/scene.toml: " + key;
}

Anatomy buildAnatomy(const SceneFile& scene) {
  Anatomy anatomy;
  switch (scene.params.model) {
    case ModelKind::kSuture: anatomy.mesh = buildWall(scene); break;
    case ModelKind::kNeedling: anatomy.body = buildBody(scene); break;
  }
  return anatomy;
}

}  // namespace halsted::scenes
