#pragma once
/// A scripted surgeon. It reads `expert.toml` (anatomical terms: bite at an angle, depth, hand over, pull, tighten), looks at the
/// simulated scene as a person would, and says where each hand wants to be. It never touches the physics: the targets move the
/// simulated hands that hold the virtual devices. Pure: same script, model, state and memory give the same targets.
/// Runs on the physics thread, after each step.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted::scenes {

struct ExpertAction {
  std::string kind;                            // "bite", "pull_through", "tighten", ... see expert.cpp
  double angleDegrees = 0.0;                   // [deg] round the opening, 0 at +x, counter-clockwise seen by the surgeon
  double depth = 0.0;                          // [m] from the rim
  double width = 0.0;                          // [m] entry to exit
  double tension = 0.0;                        // [N]
  double seconds = 0.0;                        // [s] limit of the action
  int line = 0;                                // in the file, for messages
};

struct ExpertScript {
  std::string scene;                           // folder name of the scene it is for
  std::string text;                            // as read, kept for the session record
  std::vector<ExpertAction> actions;
};

/// Throws InputError (scenes/scene.h) naming file, line and key, also for an impossible bite.
ExpertScript readExpert(const std::string& path);
ExpertScript parseExpert(const std::string& text, const std::string& origin);

/// The surgeon's memory: which action and phase, since when, what was seen at its start.
struct ExpertState;
struct ExpertStateDeleter { void operator()(ExpertState*) const; };
using ExpertStatePtr = std::unique_ptr<ExpertState, ExpertStateDeleter>;
ExpertStatePtr beginExpert(const ExpertScript&, const Model&);

/// Where both tools start, in the world; the virtual devices are placed there.
std::array<Pose, kHands> startPoses(const Model&);

/// True while there is something left to do. `failure` is set when an action ran out of time.
bool advanceExpert(const ExpertScript&, const Model&, const State&, ExpertState&, std::array<HandTarget, kHands>& targets,
                   std::string& failure);

}  // namespace halsted::scenes
