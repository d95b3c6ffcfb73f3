/// readScene, parseScene and parseRecordedScene: text -> TOML -> the field list -> a checked SceneFile.
#include "scenes/scene_reader.h"

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

/// Nothing of it is set yet.
SceneFile unsetScene(const std::string& text, const std::string& origin, const std::string& folder) {
  if (text.size() > kLargestFile) throw InputError(quoted(origin) + ": larger than " + std::to_string(kLargestFile) + " bytes");
  SceneFile scene;
  scene.folder = folder;
  std::error_code ignored;
  const fs::path place = fs::absolute(folder, ignored).lexically_normal();
  scene.name = (place.has_filename() ? place : place.parent_path()).filename().string();
  scene.text = text;
  return scene;
}

bool hasScene(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / "scene.toml", ignored);
}

bool namesFile(const SceneField& field) { return std::holds_alternative<MeshPath>(field.slot) || std::holds_alternative<MaterialName>(field.slot); }

/// Which of the keys that name a mesh did so when the session was recorded.
using NamedMeshes = std::map<std::string, bool>;

/// Takes the files that a recorded text names out of it.
NamedMeshes takeOutFiles(SceneFile& scene, toml::table& root) {
  NamedMeshes named;
  for (const SceneField& field : sceneFields(scene)) {
    const std::size_t dot = field.key.find('.');
    if (std::holds_alternative<MeshPath>(field.slot)) named[field.key] = false;
    toml::table* table = namesFile(field) ? root[field.key.substr(0, dot)].as_table() : nullptr;
    if (!table) continue;
    const std::string key = field.key.substr(dot + 1);
    if (named.count(field.key)) named[field.key] = (*table)[key].value_or(std::string()) != "";
    table->erase(key);
  }
  return named;
}

/// Settings with those of a preset in its place.
std::vector<std::string> withoutPresets(const std::vector<std::string>& settings, const SceneFile& scene) {
  std::vector<std::string> plain;
  for (const std::string& setting : settings) {
    const bool named = setting.rfind("preset=", 0) == 0;
    const auto preset = named ? scene.presets.find(setting.substr(7)) : scene.presets.end();
    if (preset != scene.presets.end()) plain.insert(plain.end(), preset->second.begin(), preset->second.end());
    else if (!named) plain.push_back(setting);
  }
  return plain;
}

/// What was set for the recording, one by one. The values are among its parameters, all but the names of meshes.
void noteSettings(const std::vector<std::string>& settings, const std::string& origin, NamedMeshes& named, SettingOrigins& origins) {
  for (const std::string& setting : settings) {
    const std::size_t equals = std::min(setting.find('='), setting.size());
    const std::string key = setting.substr(0, equals);
    origins[key] = quoted(origin) + ": recorded with --set " + quoted(setting);
    if (named.count(key)) named[key] = equals + 1 < setting.size();
  }
}

void applyParameter(const std::string& row, const std::string& origin, SceneFile& scene) {
  const std::size_t equals = std::min(row.find('='), row.size());
  const std::string key = row.substr(0, equals), where = quoted(origin) + ": parameter " + quoted(key);
  const std::vector<SceneField> fields = sceneFields(scene);
  const SceneField* field = find(fields, key);
  if (!field || namesFile(*field)) throw InputError(where + ": unknown key");
  setFieldFromText(*field, equals < row.size() ? row.substr(equals + 1) : "", {where, scene.folder, false});
}

struct SameValue {
  const FieldSlot& other;
  template <typename T> bool operator()(T* value) const { return *value == *std::get<T*>(other); }
  bool operator()(const MaterialName&) const { return true; }   // its numbers are fields of their own
  bool operator()(const MeshPath& mesh) const { return *mesh.path == *std::get<MeshPath>(other).path; }
};

/// Is it built from this?
bool shapesAnatomy(const std::string& key) {
  const std::string thickness = ".thickness";
  return key == "sim.model" || key.rfind("anatomy.", 0) == 0 || (key.size() > thickness.size() && key.ends_with(thickness));
}

bool sameAnatomy(SceneFile a, SceneFile b) {   // copies: the field list points into a scene that it may write
  const std::vector<SceneField> fields = sceneFields(a), others = sceneFields(b);
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (shapesAnatomy(fields[i].key) && !std::visit(SameValue{others[i].slot}, fields[i].slot)) return false;
  return true;
}

bool setByUser(const SettingOrigins& origins, const std::string& key) {
  const auto found = origins.find(key);
  return found != origins.end() && found->second.rfind("--set ", 0) == 0;
}

/// A clear word is better than another anatomy than the one that was meant.
void checkRebuild(const RecordedScene& recorded, const std::string& origin, const NamedMeshes& named, const SettingOrigins& origins) {
  for (const auto& [key, was] : named)
    if (was && !setByUser(origins, key))
      throw InputError(quoted(origin) + ": another anatomy: the recorded one was built from a file that the session does not hold; name it with --set " + key + "=FILE");
  const auto starts = [](const char* word) { return [word](const std::string& line) { return line.rfind(word, 0) == 0; }; };
  const auto any = [&](const std::vector<std::string>& list, const char* word) { return std::any_of(list.begin(), list.end(), starts(word)); };
  if (!any(recorded.parameters, "anatomy.layout=") && (any(recorded.settings, "anatomy.") || any(recorded.settings, "preset=")))
    throw InputError(quoted(origin) + ": another anatomy: recorded by an earlier Halsted with settings of its own, which the session holds in part; record it anew");
}

}  // namespace

SceneFile parseScene(const std::string& text, const std::string& origin, const std::string& folder,
                     const std::vector<std::string>& overrides, PathTrust trust) {
  SceneFile scene = unsetScene(text, origin, folder);
  scene.overrides = overrides;
  SettingOrigins origins;
  applyFile(parseToml(text, origin), origin, scene, origins);
  for (const std::string& setting : overrides) applyOverride(setting, trust, scene, origins);
  checkScene(scene, origin, origins, AnatomyIs::kToBeBuilt);
  scene.origins = origins;
  return scene;
}

SceneFile parseRecordedScene(const RecordedScene& recorded, const std::string& origin, const std::vector<std::string>& overrides, bool& otherAnatomy) {
  const std::string file = origin + ":scene.toml";
  SceneFile scene = unsetScene(recorded.text, file, scenesDirectory() + "/" + recorded.name);
  scene.name = recorded.name;
  scene.overrides = recorded.settings;
  scene.overrides.insert(scene.overrides.end(), overrides.begin(), overrides.end());
  SettingOrigins origins;
  toml::table root = parseToml(recorded.text, file);
  NamedMeshes named = takeOutFiles(scene, root);
  applyFile(root, file, scene, origins);
  noteSettings(withoutPresets(recorded.settings, scene), origin, named, origins);
  for (const std::string& row : recorded.parameters) applyParameter(row, origin, scene);
  const SceneFile before = scene;
  for (const std::string& setting : overrides) applyOverride(setting, PathTrust::kUser, scene, origins);
  const auto leavesMesh = [&](const auto& mesh) { return mesh.second && setByUser(origins, mesh.first); };   // also for none
  otherAnatomy = !sameAnatomy(before, scene) || std::any_of(named.begin(), named.end(), leavesMesh);
  if (otherAnatomy) checkRebuild(recorded, origin, named, origins);
  checkScene(scene, file, origins, otherAnatomy ? AnatomyIs::kToBeBuilt : AnatomyIs::kRecorded);
  scene.origins = origins;
  return scene;
}

std::string knownScenes() {
  std::string names;
  for (const std::string& folder : sceneFolders()) names += (names.empty() ? "" : ", ") + fs::path(folder).filename().string();
  return names.empty() ? "none in " + scenesDirectory() : names;
}

std::string installedScene(const std::string& name) {
  for (const std::string& folder : sceneFolders())
    if (fs::path(folder).filename().string() == name) return folder;
  return {};
}

std::string findScene(const std::string& scene) {
  const std::string installed = installedScene(scene);
  if (!installed.empty()) return installed;
  if (!scene.empty() && hasScene(scene)) return scene.find('/') == std::string::npos ? "./" + scene : scene;
  throw InputError("unknown scene '" + quoted(scene) + "': no such name, and no folder with a scene.toml; known scenes: " + knownScenes());
}

SceneFile readScene(const std::string& folder, const std::vector<std::string>& overrides) {
  const std::string place = findScene(folder), path = (fs::path(place) / "scene.toml").string();
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
    if (hasScene(it->path())) folders.push_back(it->path().string());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

}  // namespace halsted::scenes
