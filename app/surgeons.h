#pragma once
/// The scripted surgeons of a run, one per script: after each step they look at the state and say where their hands want to be.
/// Made on the main thread, so that a script which does not fit the scene is refused before anything runs; then on the physics thread.
#include <array>
#include <string>
#include <vector>

#include "app/scenario.h"

namespace halsted::app {

class Surgeons {
 public:
  explicit Surgeons(const Scenario&);          // the scenario must outlive it; throws scenes::InputError
  /// True while a script has something left to do.
  bool advance(const State&);
  const Scenario& scenario() const { return scenario_; }
  bool any() const { return !running_.empty(); }
  /// What they have asked for aloud, for the next step's input.
  const Command& command() const { return command_; }
  const HandTarget& target(int hand) const { return targets_[hand]; }
  const std::string& failure() const { return failure_; }        // an action that ran out of time, the script's last; empty: none
  const std::vector<std::string>& lost() const { return lost_; } // why stitches were taken out and set anew

 private:
  struct Running {
    const scenes::ExpertScript* script;
    scenes::ExpertStatePtr memory;
    bool busy = true;
  };
  const Scenario& scenario_;
  std::vector<Running> running_;
  std::array<HandTarget, kHands> targets_{};
  Command command_;
  std::string failure_;
  std::vector<std::string> lost_;
};

}  // namespace halsted::app
