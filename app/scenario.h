#pragma once
/// Everything a run starts from: the scene, the model built from it, who moves the hands, and the recording to follow, if any.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "app/hands.h"
#include "app/session/session_reader.h"
#include "scenes/expert.h"
#include "scenes/scene.h"
#include "sim/model.h"

namespace halsted::app {

struct Scenario {
  scenes::SceneFile scene;
  Anatomy anatomy;                             // as built or as recorded; kept for the session file
  Model model;
  std::array<Pose, kHands> start;              // world
  std::array<DeviceChoice, kHands> devices;
  std::vector<scenes::ExpertScript> scripts;
  std::array<int, kHands> scriptOfHand{-1, -1};
  std::unique_ptr<SessionReader> recording;    // set: inputs come from here, hands and scripts rest
};

/// All throw scenes::InputError.
/// A scene by name (or a folder that holds a scene.toml), hands moved as chosen.
Scenario scenarioFromScene(const std::string& scene, const std::vector<std::string>& overrides,
                           const std::array<DeviceChoice, kHands>& devices);
/// An expert script (.toml), which moves both hands, or a recorded session.
Scenario scenarioFromFile(const std::string& path, const std::vector<std::string>& overrides);

/// The header that a recording of this scenario begins with; of a recording played again its own script and, where none is named, trainee.
SessionHeader sessionHeader(const Scenario&, const std::string& trainee);

}  // namespace halsted::app
