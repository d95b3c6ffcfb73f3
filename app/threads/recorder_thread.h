#pragma once
/// The only thread that formats, logs and writes while a session runs. It drains the rings fifty times a second.
#include <string>

#include "app/session/session_writer.h"
#include "app/threads/links.h"

namespace halsted::app {

struct RecorderOutcome {
  std::uint64_t stepsRecorded = 0, dropped = 0;
  std::string failure;                         // why writing had to stop, also behind a gap; empty: none
};

/// Runs until `finish` is set, which the main thread does after the others have ended; then drains what is left.
/// `writer` may be null: then it only logs. Recorder thread.
void runRecorder(SessionWriter* writer, Links&, const std::atomic<bool>& finish, RecorderOutcome&) noexcept;

}  // namespace halsted::app
