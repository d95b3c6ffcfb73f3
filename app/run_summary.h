#pragma once
/// What a run came to: the object that `--json` prints and the text for people (DESIGN 5). Any thread that owns the state.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/fault_log.h"
#include "app/hexadecimal.h"
#include "app/timing.h"
#include "sim/model.h"
#include "sim/state.h"

namespace halsted::app {

struct ProcedureLine {
  std::string id, instruction;
  bool done = false;
  double time = 0.0;                           // [s] from the start of the run; 0 when not done
  int faults = 0;
};

struct RunSummary {
  std::string scene, title;
  std::string assist;                          // "none" | "knot": thread.assist
  double dt = 0.0;                             // [s]
  std::uint64_t steps = 0;
  bool completed = false;
  std::vector<ProcedureLine> procedure;
  std::vector<FaultLine> faults;               // in the order in which they began
  std::vector<std::pair<std::string, double>> metrics;           // name with its unit, value [in that unit]
  std::uint64_t stateHash = 0;
  Percentiles stepMilliseconds;
  double realtimeFactor = 0.0;                 // [1] simulated time / wall-clock time
  double realtimeFactorCpu = 0.0;              // [1] simulated time / CPU time of the thread that stepped: what a core of its own would give. 0: not measured, or pictures were drawn
};

/// `wall` is the time that the run took. Faults are counted, not named: the caller has kept the log of them.
RunSummary summariseRun(const std::string& scene, const std::string& title, const Model&, const State&, const Durations& steps,
                        double wall);          // [s]
std::string textOf(const RunSummary&);
/// The object of `replay --json`; `extra` is inserted as further members, already JSON ("\"haptic\":{...}"), empty for none.
std::string jsonOf(const RunSummary&, const std::string& extra);

/// Printf-style number in the C locale, whatever the user's.
std::string number(const char* format, double value);            // [any unit]

}  // namespace halsted::app
