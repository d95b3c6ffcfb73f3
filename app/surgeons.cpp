#include "app/surgeons.h"

namespace halsted::app {

Surgeons::Surgeons(const Scenario& scenario) : scenario_(scenario) {
  if (scenario.recording) return;
  for (const scenes::ExpertScript& script : scenario.scripts)
    running_.push_back({&script, scenes::beginExpert(script, scenario.model), true});
}

bool Surgeons::advance(const State& state) {
  bool busy = false;
  command_ = {};
  for (std::size_t i = 0; i < running_.size(); ++i) {
    Running& surgeon = running_[i];
    if (!surgeon.busy) continue;
    std::array<HandTarget, kHands> wanted = targets_;
    std::string failure;
    surgeon.busy = scenes::advanceExpert(*surgeon.script, scenario_.model, state, *surgeon.memory, wanted, failure);
    const Command spoken = scenes::takeSpokenCommand(*surgeon.memory);
    if (spoken.kind != Command::Kind::kNone) command_ = spoken;
    if (!failure.empty() && surgeon.busy) lost_.push_back(failure);
    else if (!failure.empty()) failure_ = failure;
    for (int hand = 0; hand < kHands; ++hand)
      if (scenario_.scriptOfHand[hand] == static_cast<int>(i)) targets_[hand] = wanted[hand];
    busy = busy || surgeon.busy;
  }
  return busy;
}

}  // namespace halsted::app
