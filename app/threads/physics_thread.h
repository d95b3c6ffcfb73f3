#pragma once
/// Steps the simulation at its fixed dt. Late steps are counted and the simulated time falls behind; dt is never stretched.
#include <string>
#include <vector>

#include "app/fault_log.h"
#include "app/surgeons.h"
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
  std::string fault;                           // why stepping had to stop; empty: none
};

/// Runs until `links.stop`. Physics thread; surgeons and `state` are its own until it ends.
void runPhysics(Surgeons&, State& state, Links&, PhysicsOutcome&) noexcept;

}  // namespace halsted::app
