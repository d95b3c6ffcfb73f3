#pragma once
/// Plays a script or a recorded session through in lockstep: what `replay` and `capture` share. One thread.
#include <functional>
#include <string>
#include <vector>

#include "app/lockstep.h"
#include "app/run_summary.h"

namespace halsted::app {

struct PlayOptions {
  std::string file;
  std::vector<std::string> overrides;          // --set
  bool verify = false, realtime = false, json = false, requireComplete = false;
  double from = 0.0;                           // [s] a recorded session goes on from the last whole state stored by then
  std::string record, report;                  // files to write; empty: none
  std::string video;                           // that the watcher writes
};

/// Called with every state, the initial one included; `capture` draws from it. False: it has seen all that it wants.
using Watcher = std::function<bool(const Lockstep&)>;
/// Called once, before the first step.
using WatcherMaker = std::function<Watcher(const Scenario&)>;

/// Runs to the end and prints the outcome on standard output. Returns the exit code; throws scenes::InputError and SystemFault.
int play(const PlayOptions&, const WatcherMaker& makeWatcher);

}  // namespace halsted::app
