/// Any bytes as a surface file. The first byte chooses the reader.
#include <cmath>
#include <cstdint>
#include <sstream>

#include "scenes/mesh_readers/surface.h"
#include "tests/fuzz/accepted.h"

namespace {

void requireSound(const halsted::scenes::Surface& surface) {
  using halsted::fuzz::require;
  require(!surface.triangles.empty() && surface.triangleGroup.size() == surface.triangles.size());
  for (const auto& v : surface.vertices) require(std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()));
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (int corner : surface.triangles[t]) require(corner >= 0 && corner < static_cast<int>(surface.vertices.size()));
    require(surface.triangleGroup[t] >= 0 && surface.triangleGroup[t] < static_cast<int>(surface.groups.size()));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace halsted;
  if (size == 0) return 0;
  using Reader = scenes::Surface (*)(std::istream&, const std::string&, double);
  constexpr Reader kReaders[] = {scenes::readObj, scenes::readStl, scenes::readPly, scenes::readVtk};
  std::istringstream in(std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
  fuzz::accepted([&] { requireSound(kReaders[data[0] % 4](in, "fuzz.mesh", 1e-3)); });
  return 0;
}
