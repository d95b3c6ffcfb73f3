/// readScene and parseScene: text -> TOML -> the field list -> a checked SceneFile.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "scenes/field_value.h"
#include "scenes/procedure_reader.h"
#include "scenes/scene_checks.h"

namespace halsted::scenes {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = 1 << 20;  // [bytes]

/// Every value of a TOML tree by dotted key. A list is a value; an empty table still counts, so that an unknown one is noticed.
using FlatToml = std::map<std::string, const toml::node*>;

void flatten(const toml::table& table, const std::string& prefix, FlatToml& out) {
  for (const auto& [key, node] : table) {
    const std::string dotted = prefix + std::string(key.str());
    const toml::table* inner = node.as_table();
    if (inner && !inner->empty()) flatten(*inner, dotted + ".", out);
    else out[dotted] = &node;
  }
}

const SceneField* find(const std::vector<SceneField>& fields, const std::string& key) {
  for (const SceneField& field : fields)
    if (field.key == key) return &field;
  return nullptr;
}

bool isTable(const std::vector<SceneField>& fields, const std::string& key) {
  const auto starts = [&](const SceneField& field) { return field.key.rfind(key + ".", 0) == 0; };
  return std::any_of(fields.begin(), fields.end(), starts);
}

/// Names an unknown table as such: "[tisue]" helps more than the first key in it.
std::string unknown(const std::vector<SceneField>& fields, const std::string& key) {
  const std::size_t dot = key.rfind('.');
  if (dot != std::string::npos && !isTable(fields, key.substr(0, dot))) return "unknown table [" + quoted(key.substr(0, dot)) + "]";
  return "unknown key";
}

/// [preset]: lists of settings by name. They are checked when they are used, as overrides are.
void takePresets(const std::string& origin, FlatToml& values, SceneFile& scene) {
  constexpr const char* kTable = "preset.";
  for (auto at = values.lower_bound(kTable); at != values.end() && at->first.rfind(kTable, 0) == 0; at = values.erase(at)) {
    const std::string where = whereIs(origin, *at->second, at->first);
    const toml::array* list = at->second->as_array();
    if (!list) throw InputError(where + ": must be a list of \"key=value\", is " + kindOf(*at->second));
    for (const toml::node& entry : *list) scene.presets[at->first.substr(std::string(kTable).size())].push_back(requireText(entry, where));
  }
}

void applyFile(const toml::table& root, const std::string& origin, SceneFile& scene, SettingOrigins& origins) {
  const std::vector<SceneField> fields = sceneFields(scene);
  FlatToml values;
  flatten(root, "", values);
  if (const auto found = values.find("procedure"); found != values.end()) {
    scene.procedure = readProcedure(*found->second, origin);
    values.erase(found);
  }
  takePresets(origin, values, scene);
  for (const auto& [key, node] : values) {
    const bool emptyKnownTable = node->is_table() && isTable(fields, key);
    if (!find(fields, key) && !emptyKnownTable) throw InputError(whereIs(origin, *node, key) + ": " + unknown(fields, key));
  }
  // In the list's order, so that a material comes before the keys that refine it.
  for (const SceneField& field : fields) {
    const auto found = values.find(field.key);
    if (found == values.end()) continue;
    origins[field.key] = whereIs(origin, *found->second, field.key);
    setField(field, *found->second, {origins[field.key], scene.folder, false});
  }
}

/// The settings of a preset, named once each.
std::vector<std::string> presetOf(const SceneFile& scene, const std::string& name, const std::string& where) {
  const auto found = scene.presets.find(name);
  if (found != scene.presets.end()) return found->second;
  if (name == "default") return {};            // the scene as it is
  std::string known;
  for (const auto& [other, settings] : scene.presets) known += (known.empty() ? "" : ", ") + other;
  throw InputError(where + ": this scene has no such preset; it has " + (known.empty() ? "none" : known));
}

void applyOverride(const std::string& text, PathTrust trust, SceneFile& scene, SettingOrigins& origins) {
  const std::string where = "--set " + quoted(text);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw InputError(where + ": must be key=value");
  const std::vector<SceneField> fields = sceneFields(scene);
  const std::string key = text.substr(0, equals);
  if (key == "preset") {
    for (const std::string& setting : presetOf(scene, text.substr(equals + 1), where)) {
      if (setting.rfind("preset", 0) == 0) throw InputError(where + ": a preset holds settings, not other presets");
      applyOverride(setting, PathTrust::kFile, scene, origins);
    }
    return;
  }
  const SceneField* field = find(fields, key);
  if (!field) throw InputError(where + ": " + unknown(fields, key));
  origins[key] = where;
  setFieldFromText(*field, text.substr(equals + 1), {where, scene.folder, trust == PathTrust::kUser});
}

std::string knownScenes() {
  std::string names;
  for (const std::string& folder : sceneFolders()) names += (names.empty() ? "" : ", ") + fs::path(folder).filename().string();
  return names.empty() ? "none in " + scenesDirectory() : names;
}

}  // namespace

SceneFile parseScene(const std::string& text, const std::string& origin, const std::string& folder,
                     const std::vector<std::string>& overrides, PathTrust trust) {
  if (text.size() > kLargestFile) throw InputError(quoted(origin) + ": larger than " + std::to_string(kLargestFile) + " bytes");
  SceneFile scene;
  scene.folder = folder;
  scene.name = fs::path(folder).lexically_normal().filename().string();
  if (scene.name.empty()) scene.name = fs::path(folder).lexically_normal().parent_path().filename().string();
  scene.text = text;
  scene.overrides = overrides;
  SettingOrigins origins;
  applyFile(parseToml(text, origin), origin, scene, origins);
  for (const std::string& setting : overrides) applyOverride(setting, trust, scene, origins);
  checkScene(scene, origin, origins);
  scene.origins = origins;
  return scene;
}

SceneFile readScene(const std::string& folder, const std::vector<std::string>& overrides) {
  std::error_code ignored;
  std::string place = folder;
  const bool bareName = folder.find('/') == std::string::npos && !folder.empty() && folder != "." && folder != "..";
  if (bareName && !fs::is_regular_file(fs::path(folder) / "scene.toml", ignored)) place = scenesDirectory() + "/" + folder;
  const std::string path = (fs::path(place) / "scene.toml").string();
  if (!fs::is_regular_file(path, ignored))
    throw InputError("unknown scene '" + quoted(folder) + "': no " + quoted(path) + "; known scenes: " + knownScenes());
  return parseScene(readTextFile(path, kLargestFile), path, place, overrides);
}

std::string scenesDirectory() {
  const char* chosen = std::getenv("HALSTED_SCENES");
  return chosen && *chosen ? chosen : HALSTED_SCENES_FOLDER;
}

std::vector<std::string> sceneFolders() {
  std::vector<std::string> folders;
  std::error_code error;
  for (fs::directory_iterator it(scenesDirectory(), error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (fs::is_regular_file(it->path() / "scene.toml", ignored)) folders.push_back(it->path().string());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

}  // namespace halsted::scenes
