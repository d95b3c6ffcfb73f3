#include "app/verifier.h"

#include "app/run_summary.h"

namespace halsted::app {

bool Verifier::check(const Lockstep& run) {
  const State& state = run.state();
  const std::uint64_t now = hash(state);
  ++checked_;
  if (!failed_ && now == run.recordedHash()) return true;
  if (!failed_) {
    failed_ = true;
    firstStep_ = state.step;
    recorded_ = run.recordedHash();
    found_ = now;
  }
  if (state.step >= firstStep_ + kStateInterval) return false;
  const auto stored = run.scenario().recording->stateAfter(state.step);
  if (!stored) return true;                    // go on to the next whole state: it says which field
  State recorded = state;
  std::string error;
  fieldStep_ = state.step;
  field_ = load(*stored, recorded, error) ? diff(recorded, state) : error;
  return false;
}

std::string Verifier::message() const {
  if (!failed_) return {};
  std::string text = "the state after step " + std::to_string(firstStep_) + " differs: recorded " + hexadecimal(recorded_) +
                     ", replayed " + hexadecimal(found_);
  if (!field_.empty()) text += "; first differing field after step " + std::to_string(fieldStep_) + " (recorded and replayed): " + field_;
  return text;
}

}  // namespace halsted::app
