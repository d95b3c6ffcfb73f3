#include "app/threads/recorder_thread.h"

#include <spdlog/spdlog.h>

#include "app/threads/realtime.h"
#include "haptics/limits.h"

namespace halsted::app {
namespace {

constexpr Nanoseconds kDrainInterval = 20'000'000;               // [ns]

const char* handName(std::int64_t hand) { return hand == kLeft ? "left" : "right"; }

std::string faultNames(std::uint32_t bits) {
  std::string names;
  for (std::uint32_t bit = 1; bit != 0; bit <<= 1)
    if (bits & bit) names += (names.empty() ? "" : ", ") + std::string(haptics::faultName(static_cast<haptics::FaultCode>(bit)));
  return names;
}

void log(const Notice& notice, const char* thread) {
  switch (notice.kind) {
    case NoticeKind::kNoRealtimePriority:
      spdlog::warn("{} thread: no real-time priority granted (needs CAP_SYS_NICE or an rtprio limit); timing is best effort", thread);
      break;
    case NoticeKind::kMemoryNotLocked: spdlog::warn("memory is not locked; page faults may delay a tick"); break;
    case NoticeKind::kSkippedPeriods: spdlog::debug("haptic tick {}: {} periods skipped", notice.when, notice.value); break;
    case NoticeKind::kHandFault:
      spdlog::warn("haptic tick {}: {} hand: {}", notice.when, handName(notice.value & 0xff), faultNames(static_cast<std::uint32_t>(notice.value >> 8)));
      break;
    case NoticeKind::kDeviceGone: spdlog::error("haptic tick {}: the {} device is gone", notice.when, handName(notice.value)); break;
    case NoticeKind::kDevicePaused: {
      const auto problem = static_cast<haptics::DeviceProblem>(notice.value >> 8);
      spdlog::warn("the {} device is away ({}): the session waits. {}", handName(notice.value & 0xff), haptics::problemText(problem), haptics::remedyText(problem));
      break;
    }
    case NoticeKind::kDeviceBack: spdlog::warn("the {} device is back: the session goes on", handName(notice.value & 0xff)); break;
    case NoticeKind::kScriptEnded: spdlog::info("step {}: the script has ended", notice.when); break;
  }
}

struct Recorder {
  SessionWriter* writer;
  Links& links;
  RecorderOutcome& outcome;
  bool gap = false;

  void drainNotices() {
    Notice notice;
    while (links.hapticNotices.pop(notice)) log(notice, "haptic");
    while (links.physicsNotices.pop(notice)) log(notice, "physics");
  }

  /// A replay is exact only up to the first missing step: behind a gap nothing more is recorded.
  void drainSteps() {
    StepRecord record;
    while (links.steps.pop(record)) {
      if (!writer || gap) continue;
      gap = record.step != writer->steps();
      if (gap) stopRecording();
      else writer->addStep(record.input, record.stateHash);
    }
  }

  void stopRecording() {
    outcome.failure = writer->path() + ": recording stops at step " + std::to_string(writer->steps()) + ": " +
                      std::to_string(links.steps.dropped()) + " steps were lost, the disk is too slow";
    spdlog::error("{}", outcome.failure);
  }

  void drainRest() {
    Event event;
    while (links.events.pop(event)) {
      spdlog::info("step {}: {} {}", event.step, name(event.kind), event.index);
      if (writer && !gap) writer->addEvent(event);
    }
    HapticRecord haptic;
    while (links.hapticRecords.pop(haptic))
      if (writer && !gap) writer->addHaptic(haptic);
    if (links.wholeState.acquire() && writer && !gap) writer->addState(links.wholeState.front().step, save(links.wholeState.front()));
  }

  void drain() {
    drainNotices();
    drainSteps();
    drainRest();
    if (writer) writer->commitWhenDue();
  }
};

}  // namespace

void runRecorder(SessionWriter* writer, Links& links, const std::atomic<bool>& finish, RecorderOutcome& outcome) noexcept {
  Recorder recorder{writer, links, outcome};
  try {
    for (bool last = false; !last;) {
      last = finish.load();
      recorder.drain();
      if (!last) sleepUntil(monotonicNow() + kDrainInterval);
    }
  } catch (const std::exception& error) {
    outcome.failure = error.what();
    links.stop.store(true);
  }
  outcome.stepsRecorded = writer ? writer->steps() : 0;
  outcome.dropped = links.steps.dropped() + links.events.dropped() + links.hapticRecords.dropped();
}

}  // namespace halsted::app
