#include "app/scenario.h"

#include <ctime>
#include <filesystem>
#include <stdexcept>

#include "app/parameters.h"
#include "app/version.h"
#include "scenes/input_text.h"
#include "scenes/scene_reader.h"

namespace fs = std::filesystem;

namespace halsted::app {
namespace {

/// "file:line: scene" of a script.
std::string placeOfScene(const scenes::ExpertScript& script) { return scenes::quoted(script.origin) + ":" + std::to_string(script.sceneLine) + ": scene"; }

/// The folder that a script's `scene` names: its own when it lies in one of that name, else among the installed scenes.
std::string folderOfScript(const std::string& path, const scenes::ExpertScript& script) {
  std::error_code ignored;
  const fs::path own = fs::absolute(fs::path(path), ignored).lexically_normal().parent_path();
  if (own.filename() == script.scene && fs::exists(own / "scene.toml", ignored)) return own.string();
  if (script.scene.find('/') != std::string::npos || script.scene.find("..") != std::string::npos)
    throw scenes::InputError(placeOfScene(script) + ": a name, not a path: " + scenes::quoted(script.scene));
  const std::string folder = scenes::installedScene(script.scene);
  if (folder.empty()) throw scenes::InputError(placeOfScene(script) + ": unknown scene '" + scenes::quoted(script.scene) + "'; known scenes: " + scenes::knownScenes());
  return folder;
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
  bool otherAnatomy = false;
  scenario.scene = scenes::parseRecordedScene({header.scene, header.sceneText, header.overrides, header.parameters}, path, overrides, otherAnatomy);
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
  Scenario scenario = scenarioFromFolder(scenes::findScene(scene), overrides);
  scenario.devices = devices;
  for (int hand = 0; hand < kHands; ++hand) {
    if (devices[hand].mover != Mover::kScript) continue;
    const bool shared = hand > 0 && devices[0].mover == Mover::kScript && devices[0].scriptPath == devices[hand].scriptPath;
    if (!shared) scenario.scripts.push_back(scenes::readExpert(devices[hand].scriptPath));
    scenario.scriptOfHand[hand] = static_cast<int>(scenario.scripts.size()) - 1;
    if (scenario.scripts.back().scene != scenario.scene.name)
      throw scenes::InputError(placeOfScene(scenario.scripts.back()) + ": this script is for " + scenario.scripts.back().scene);
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
  if (scenario.recording) header.expertText = scenario.recording->header().expertText;
  header.program = kVersionText;
  header.created = nowText();
  header.trainee = scenario.recording && trainee.empty() ? scenario.recording->header().trainee : trainee;
  for (int hand = 0; hand < kHands; ++hand) header.devices[hand] = scenario.devices[hand].text;
  header.dt = scenario.model.params.dt;
  header.seed = scenario.model.params.seed;
  header.start = scenario.start;
  header.anatomy = scenario.anatomy;
  return header;
}

}  // namespace halsted::app
