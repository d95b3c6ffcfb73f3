#pragma once
/// Steps the simulation at its fixed dt. Late steps are counted and the simulated time falls behind; dt is never stretched.
#include <string>
#include <vector>

#include "app/fault_log.h"
#include "app/scenario.h"
#include "app/threads/links.h"
#include "app/timing.h"

namespace halsted::app {

struct PhysicsOutcome {
  std::uint64_t steps = 0, lateSteps = 0;
  double pausedSeconds = 0.0;                  // [s] that a device was away and the simulation stood still
  double seconds = 0.0;                        // [s] from first to last step
  Durations stepTimes;
  std::string failure;                         // of a script; empty: none
  FaultLog faults;                             // of the procedure
  std::vector<std::string> lostStitches;       // why a script set them anew
  bool realtime = false;
};

/// Runs until `links.stop`. Physics thread; `state` is its own until it ends.
void runPhysics(const Scenario&, State& state, Links&, PhysicsOutcome&);

}  // namespace halsted::app
