#include "app/fault_log.h"

#include "app/event_text.h"

namespace halsted::app {

void FaultLog::add(const StepOutput& output, double dt) {   // [s]
  for (int i = 0; i < output.eventCount && count_ < kMost; ++i) {
    const Event& event = output.events[i];
    if (isFault(event.kind)) begun_[count_++] = {event.index, event.kind, static_cast<double>(event.step) * dt};
  }
}

std::vector<FaultLine> FaultLog::lines(const Model& m) const {
  std::vector<FaultLine> lines;
  for (int i = 0; i < count_; ++i) lines.push_back({begun_[i].row, faultText(begun_[i].kind, m.procedure[begun_[i].row]), begun_[i].time});
  return lines;
}

}  // namespace halsted::app
