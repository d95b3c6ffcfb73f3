#include "app/output_files.h"

#include <filesystem>

#include "scenes/scene.h"

namespace fs = std::filesystem;

namespace halsted::app {
namespace {

bool sameFile(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code ignored, missing;
  if (fs::exists(a, ignored) && !fs::is_regular_file(a, ignored)) return false;
  if (fs::equivalent(a, b, missing)) return true;                // also by a link
  const fs::path first = fs::weakly_canonical(fs::absolute(a, ignored), ignored);
  return !first.empty() && first == fs::weakly_canonical(fs::absolute(b, ignored), ignored);
}

}  // namespace

void checkOutputs(const std::string& input, const std::vector<std::pair<std::string, std::string>>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto& [option, path] = outputs[i];
    if (sameFile(path, input)) throw scenes::InputError(path + ": " + option + " would overwrite the file that is replayed");
    for (std::size_t j = i + 1; j < outputs.size(); ++j)
      if (sameFile(path, outputs[j].second)) throw scenes::InputError(path + ": " + option + " and " + outputs[j].first + " name the same file");
  }
}

}  // namespace halsted::app
