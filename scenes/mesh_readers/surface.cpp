#include "scenes/mesh_readers/surface.h"

#include <filesystem>
#include <fstream>

#include "scenes/input_text.h"

namespace halsted::scenes {

Surface readSurface(const std::string& path, double scale) {
  using Reader = Surface (*)(std::istream&, const std::string&, double);
  constexpr std::pair<const char*, Reader> kReaders[] = {{".obj", readObj}, {".stl", readStl}, {".ply", readPly}, {".vtk", readVtk}};
  const std::string origin = quoted(path);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) throw InputError(origin + ": no such file");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InputError(origin + ": cannot be opened");
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const auto& [known, reader] : kReaders)
    if (extension == known) return reader(in, origin, scale);
  throw InputError(origin + ": unknown kind of mesh file, known are .obj, .stl, .ply and .vtk");
}

}  // namespace halsted::scenes
