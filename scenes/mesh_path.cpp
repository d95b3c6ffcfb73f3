#include "scenes/mesh_path.h"

#include <cstdlib>
#include <filesystem>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDataPrefix = "$HALSTED_DATA/";

/// Both with symbolic links resolved.
bool isInside(const fs::path& path, const fs::path& folder) {
  const fs::path relative = path.lexically_relative(folder);
  return !relative.empty() && *relative.begin() != ".." && relative != ".";
}

/// The file `text` below `base` when it really lies there; empty when there is no such file. `escaped` is set when it lies elsewhere.
fs::path fileBelow(const fs::path& text, const std::string& base, bool& escaped) {
  std::error_code error;
  const fs::path folder = fs::canonical(base, error);
  if (base.empty() || error) return {};
  const fs::path path = fs::weakly_canonical(folder / text, error);
  if (error) return {};
  if (!isInside(path, folder)) {
    escaped = true;
    return {};
  }
  return fs::is_regular_file(path, error) ? path : fs::path();
}

}  // namespace

std::string dataFolder() {
  const char* folder = std::getenv("HALSTED_DATA");
  return folder ? folder : "";
}

std::string meshPathInFile(const std::string& text, const std::string& folder, const std::string& where) {
  const bool fromData = text.rfind(kDataPrefix, 0) == 0;
  const std::string tail = fromData ? text.substr(std::string(kDataPrefix).size()) : text;
  if (fromData && dataFolder().empty()) throw InputError(where + ": HALSTED_DATA is not set");
  bool escaped = false;
  fs::path path;
  if (!fromData) path = fileBelow(tail, folder, escaped);
  if (path.empty()) path = fileBelow(tail, dataFolder(), escaped);
  if (!path.empty()) return path.string();
  if (escaped) throw InputError(where + ": '" + quoted(text) + "' lies outside the scene's folder and HALSTED_DATA");
  throw InputError(where + ": no file '" + quoted(text) + "' in the scene's folder or HALSTED_DATA");
}

std::string meshPathFromUser(const std::string& text, const std::string& where) {
  std::error_code error;
  const fs::path path = fs::absolute(text, error);
  if (error || !fs::is_regular_file(path, error)) throw InputError(where + ": no file '" + quoted(text) + "'");
  return path.lexically_normal().string();
}

}  // namespace halsted::scenes
