#pragma once
/// A scenario in virtual time on one thread: haptic ticks of both hands, physics step, scripted surgeons, in turn and as fast as the
/// machine allows. `replay`, `capture`, `bench` and the tests all run on this one loop; `train` calls the same functions from threads.
#include <cstdint>
#include <string>

#include "app/fault_log.h"
#include "app/scenario.h"
#include "app/surgeons.h"
#include "app/timing.h"
#include "sim/step.h"

namespace halsted::app {

class Lockstep {
 public:
  explicit Lockstep(const Scenario&);          // the scenario must outlive it; throws scenes::InputError where a script does not fit it

  /// Of a recording, before the first step: goes on from the last whole state that it holds after no more than so many steps, or from the
  /// start where there is none. Throws scenes::InputError for a stored state of another model or step, or one that has not the recorded hash.
  void seek(std::uint64_t step);

  /// One physics step; false when there was nothing left to do: the scripts have ended, or the recording.
  bool advance();

  const Scenario& scenario() const { return scenario_; }
  const State& state() const { return state_; }
  State& state() { return state_; }            // for tests that restore one
  const StepInput& input() const { return input_; }
  const StepOutput& output() const { return output_; }
  const Hands& hands() const { return hands_; }
  const Durations& stepTimes() const { return stepTimes_; }
  const FaultLog& faults() const { return faults_; }
  const std::string& failure() const { return surgeons_.failure(); }
  const std::vector<std::string>& lostStitches() const { return surgeons_.lost(); }   // why each was set anew
  std::uint64_t recordedHash() const { return recordedHash_; }   // of the state after this step, from the recording
  double time() const { return static_cast<double>(state_.step) * scenario_.model.params.dt; }   // [s]

 private:
  bool readHands();                            // devices or recording -> input_

  const Scenario& scenario_;
  State state_;
  StepInput input_;
  StepOutput output_;
  Hands hands_;
  Surgeons surgeons_;
  Durations stepTimes_;
  FaultLog faults_;
  std::uint64_t ticks_ = 0, recordedHash_ = 0;
  bool busy_ = true;
};

}  // namespace halsted::app
