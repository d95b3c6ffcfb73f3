/// Any bytes as a scene file: read or refused; what was read can be built.
#include <cstdint>

#include "tests/fuzz/accepted.h"

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  unsetenv("HALSTED_DATA");  // no real mesh: the reader is under test, not the disk
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halsted;
  const std::string text(reinterpret_cast<const char*>(data), size);
  fuzz::accepted([&] {
    const scenes::SceneFile scene = scenes::parseScene(text, "fuzz.toml", "/nonexistent/scene", {});
    const AnatomyParams& anatomy = scene.params.anatomy;
    if (anatomy.around * anatomy.along > 700) return;  // keeps a run short
    const TetMesh mesh = scenes::buildAnatomy(scene).mesh;
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) fuzz::require(volume(mesh, t) > 0.0);
  });
  return 0;
}
