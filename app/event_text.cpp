#include "app/event_text.h"

#include "app/run_summary.h"

namespace halsted::app {

bool isFault(EventKind kind) { return kind == EventKind::kFault || kind == EventKind::kStepLate; }

bool isGrave(EventKind kind) { return isFault(kind) || kind == EventKind::kWallPerforated || kind == EventKind::kChannelTorn; }

std::string faultText(EventKind kind, const ProcedureStep& step) {
  return kind == EventKind::kStepLate ? number("took longer than %g s", step.limit) : step.faultName;
}

std::string eventText(const Event& event, std::span<const ProcedureStep> procedure) {
  const std::string text = name(event.kind);
  switch (event.kind) {
    case EventKind::kFault:
    case EventKind::kStepLate: return std::string(name(EventKind::kFault)) + ": " + faultText(event.kind, procedure[event.index]);
    case EventKind::kThreadRefused: return text + ": " + name(static_cast<ThreadRefusal>(event.index));
    case EventKind::kInstrumentRefused: return text + ": " + name(static_cast<InstrumentRefusal>(event.index));
    case EventKind::kClampRefused: return text + ": " + name(static_cast<ClampRefusal>(event.index));
    case EventKind::kWallPerforated: return text + number(", %.1f N", event.value);
    default: return text;
  }
}

}  // namespace halsted::app
