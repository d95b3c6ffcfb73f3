/// Any surface (as OBJ text) through the reader of real anatomy. The first byte chooses the segment.
#include <cstdint>
#include <sstream>

#include "scenes/mesh_readers/surface.h"
#include "scenes/tube.h"
#include "tests/fuzz/accepted.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halsted;
  if (size == 0 || size > 40000) return 0;
  constexpr const char* kSegments[] = {"", "start", "end", "0.3", "0.2:0.6", "0.7:0.1"};
  AnatomyParams anatomy;
  anatomy.segment = kSegments[data[0] % 6];
  anatomy.around = 16;
  anatomy.along = 8;
  std::istringstream in(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  fuzz::accepted([&] {
    const TetMesh mesh = scenes::tubeSegment(scenes::readObj(in, "fuzz.obj", 1e-3), anatomy);
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) fuzz::require(volume(mesh, t) > 0.0);
  });
  return 0;
}
