#include "app/scenario.h"

#include <ctime>
#include <filesystem>
#include <stdexcept>

#include "app/parameters.h"
#include "app/version.h"

namespace fs = std::filesystem;

namespace halsted::app {
namespace {

/// A scene's name, or a folder given on the command line: the user's word.
std::string folderOfScene(const std::string& scene) {
  std::error_code ignored;
  if (scene.find('/') != std::string::npos) {
    if (fs::exists(fs::path(scene) / "scene.toml", ignored)) return fs::path(scene).lexically_normal().string();
    throw scenes::InputError(scene + ": no scene.toml in this folder");
  }
  std::string known;
  for (const std::string& folder : scenes::sceneFolders()) {
    const std::string name = fs::path(folder).filename().string();
    if (name == scene) return folder;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw scenes::InputError(scene + ": unknown scene; known: " + known);
}

/// The folder that a script's `scene` names: its own when it lies in one of that name, else among the installed scenes.
std::string folderOfScript(const std::string& path, const scenes::ExpertScript& script) {
  std::error_code ignored;
  const fs::path own = fs::absolute(fs::path(path), ignored).lexically_normal().parent_path();
  if (own.filename() == script.scene && fs::exists(own / "scene.toml", ignored)) return own.string();
  if (script.scene.find('/') != std::string::npos || script.scene.find("..") != std::string::npos)
    throw scenes::InputError(path + ": scene: a name, not a path: " + script.scene);
  return folderOfScene(script.scene);
}

void build(Scenario& scenario) {
  try {
    scenario.model = buildModel(scenario.scene.params, scenario.anatomy, scenario.scene.procedure);
  } catch (const std::invalid_argument& error) {
    throw scenes::InputError(scenario.scene.folder + "/scene.toml: " + error.what());
  }
}

Scenario scenarioFromFolder(const std::string& folder, const std::vector<std::string>& overrides) {
  Scenario scenario;
  scenario.scene = scenes::readScene(folder, overrides);
  scenario.anatomy = scenes::buildAnatomy(scenario.scene);
  build(scenario);
  scenario.start = scenes::startPoses(scenario.model);
  return scenario;
}

/// What was recorded wins over today's scene folder; the user's own overrides win over both.
Scenario scenarioFromSession(const std::string& path, const std::vector<std::string>& overrides) {
  Scenario scenario;
  scenario.recording = std::make_unique<SessionReader>(path);
  const SessionHeader& header = scenario.recording->header();
  std::vector<std::string> settings = header.parameters;
  settings.push_back("anatomy.mesh=");          // the anatomy comes from the recording
  settings.push_back("anatomy.layers_from=");
  settings.insert(settings.end(), overrides.begin(), overrides.end());
  scenario.scene = scenes::parseScene(header.sceneText, path + ":scene.toml", scenes::scenesDirectory() + "/" + header.scene, settings);
  scenario.scene.name = header.scene;
  scenario.scene.text = header.sceneText;
  bool otherAnatomy = false;
  for (const std::string& entry : overrides) otherAnatomy = otherAnatomy || entry.rfind("anatomy.", 0) == 0;
  scenario.anatomy = otherAnatomy ? scenes::buildAnatomy(scenario.scene) : header.anatomy;
  build(scenario);
  scenario.start = header.start;
  for (int hand = 0; hand < kHands; ++hand) scenario.devices[hand].text = header.devices[hand];
  return scenario;
}

std::string nowText() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

Scenario scenarioFromScene(const std::string& scene, const std::vector<std::string>& overrides,
                           const std::array<DeviceChoice, kHands>& devices) {
  Scenario scenario = scenarioFromFolder(folderOfScene(scene), overrides);
  scenario.devices = devices;
  for (int hand = 0; hand < kHands; ++hand) {
    if (devices[hand].mover != Mover::kScript) continue;
    const bool shared = hand > 0 && devices[0].mover == Mover::kScript && devices[0].scriptPath == devices[hand].scriptPath;
    if (!shared) scenario.scripts.push_back(scenes::readExpert(devices[hand].scriptPath));
    scenario.scriptOfHand[hand] = static_cast<int>(scenario.scripts.size()) - 1;
    if (scenario.scripts.back().scene != scenario.scene.name)
      throw scenes::InputError(devices[hand].scriptPath + ": scene: this script is for " + scenario.scripts.back().scene);
  }
  return scenario;
}

Scenario scenarioFromFile(const std::string& path, const std::vector<std::string>& overrides) {
  if (fs::path(path).extension() != ".toml") return scenarioFromSession(path, overrides);
  const scenes::ExpertScript script = scenes::readExpert(path);
  Scenario scenario = scenarioFromFolder(folderOfScript(path, script), overrides);
  scenario.scripts.push_back(script);
  scenario.scriptOfHand = {0, 0};
  for (DeviceChoice& device : scenario.devices) device = {"script:" + path, Mover::kScript, path, {}};
  return scenario;
}

SessionHeader sessionHeader(const Scenario& scenario, const std::string& trainee) {
  SessionHeader header;
  header.scene = scenario.scene.name;
  header.sceneText = scenario.scene.text;
  header.overrides = scenario.scene.overrides;
  header.parameters = resolvedParameters(scenario.scene);
  for (const scenes::ExpertScript& script : scenario.scripts) header.expertText += script.text;
  header.program = kVersionText;
  header.created = nowText();
  header.trainee = trainee;
  for (int hand = 0; hand < kHands; ++hand) header.devices[hand] = scenario.devices[hand].text;
  header.dt = scenario.model.params.dt;
  header.seed = scenario.model.params.seed;
  header.start = scenario.start;
  header.anatomy = scenario.anatomy;
  return header;
}

}  // namespace halsted::app
