#include "app/lockstep.h"

#include "sim/fits.h"

namespace halsted::app {

Lockstep::Lockstep(const Scenario& scenario)
    : scenario_(scenario), state_(initialState(scenario.model, scenario.start)), surgeons_(scenario) {
  for (int hand = 0; hand < kHands; ++hand) hands_[hand] = makeHand(scenario.devices[hand], scenario.start[hand]);
}

void Lockstep::seek(std::uint64_t step) {
  SessionReader& recording = *scenario_.recording;
  const auto stored = recording.storedBefore(step);
  if (!stored) return;
  // A state that was damaged has indices that lead anywhere: nothing is stepped from but what was recorded.
  std::uint64_t expected = hash(state_);
  StepInput input;
  std::string error;
  if (*stored > 0) {
    recording.seek(*stored - 1);
    if (!recording.next(input, expected)) error = "it lies beyond the end";
  }
  if (error.empty() && load(*recording.stateAfter(*stored), state_, error) && state_.step != *stored) error = "it is of step " + std::to_string(state_.step);
  if (error.empty() && hash(state_) != expected) error = "it is damaged: it has not the recorded hash";
  if (error.empty()) fits(scenario_.model, state_, error);       // a forged hash is no reason to crash either
  if (!error.empty()) throw scenes::InputError(recording.path() + ": state after step " + std::to_string(*stored) + ": " + error);
  recording.seek(*stored);
}

bool Lockstep::readHands() {
  if (scenario_.recording) return scenario_.recording->next(input_, recordedHash_);
  if (!busy_ && surgeons_.any()) return false;
  input_.command = surgeons_.command();
  // As many haptic ticks as fit into this step of virtual time: one at the default 1 ms.
  const double end = static_cast<double>(state_.step + 1) * scenario_.model.params.dt;   // [s]
  for (; static_cast<double>(ticks_ + 1) * kHapticPeriod <= end + 1e-9; ++ticks_)
    for (int hand = 0; hand < kHands; ++hand) {
      Hand& h = hands_[hand];
      haptics::tick(*h.device, h.config, output_.contact[hand], surgeons_.target(hand), ticks_, h.state, h.output);
      input_.tools[hand] = h.output.sample;
    }
  if (ticks_ == 0)                             // a step shorter than a tick: the tools still stand where they started
    for (int hand = 0; hand < kHands; ++hand) input_.tools[hand].pose = scenario_.start[hand];
  return true;
}

bool Lockstep::advance() {
  if (!readHands()) return false;
  const Stopwatch watch;
  step(scenario_.model, input_, state_, output_);
  stepTimes_.add(watch.seconds());
  faults_.add(output_, scenario_.model.params.dt);
  busy_ = surgeons_.advance(state_);
  return true;
}

}  // namespace halsted::app
