/// `halsted scenes`: what there is to train, with its size.
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/commands/commands.h"
#include "app/errors.h"
#include "app/scenario.h"

namespace halsted::app {
namespace {

std::vector<std::string> presetNames(const scenes::SceneFile& scene) {
  std::vector<std::string> names;
  for (const auto& [name, settings] : scene.presets) names.push_back(name);
  return names;
}

nlohmann::ordered_json describe(const Scenario& scenario) {
  const scenes::SceneFile& scene = scenario.scene;
  return {{"name", scene.name}, {"title", scene.title}, {"technique", scene.technique}, {"particles", tissueParticles(scenario.model)},
          {"tets", scenario.model.mesh.tets.size()}, {"thread_nodes", threadNodes(scenario.model)}, {"presets", presetNames(scene)},
          {"train_preset", scene.trainPreset}};
}

std::string presetsText(const nlohmann::ordered_json& scene) {
  std::string text;
  for (const std::string name : scene["presets"])
    text += (text.empty() ? "; presets: " : ", ") + name + (name == scene["train_preset"] ? " (trained with)" : "");
  return text;
}

}  // namespace

int listScenes(bool json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  int code = kDone;
  for (const std::string& folder : scenes::sceneFolders()) {
    try {
      list.push_back(describe(scenarioFromScene(folder, {}, {})));
    } catch (const scenes::InputError& error) {    // the others are there all the same
      std::fprintf(stderr, "halsted: %s\n", error.what());
      code = kBadInput;
    }
  }
  if (json) {
    std::printf("%s\n", list.dump(2).c_str());
    return code;
  }
  if (list.empty()) std::printf("No scenes in %s.\n", scenes::scenesDirectory().c_str());
  for (const auto& scene : list)
    std::printf("%-16s %s\n%-16s %s\n%-16s %d particles, %d tets, %d thread nodes%s\n", scene["name"].get<std::string>().c_str(),
                scene["title"].get<std::string>().c_str(), "", scene["technique"].get<std::string>().c_str(), "",
                scene["particles"].get<int>(), scene["tets"].get<int>(), scene["thread_nodes"].get<int>(), presetsText(scene).c_str());
  return code;
}

}  // namespace halsted::app
