#include "app/banner.h"

#include "app/event_text.h"
#include "app/run_summary.h"

namespace halsted::app {
namespace {

constexpr double kShown = 3.0;                 // [s]

}  // namespace

void Banner::tell(const Event& event, const Model& m, double now) {   // [s]
  const bool grave = isGrave(event.kind);
  if (now < graveUntil_ && !grave) return;
  text_ = number("%.1f s: ", static_cast<double>(event.step) * m.params.dt) + eventText(event, m.procedure);
  until_ = now + kShown;
  if (grave) graveUntil_ = until_;
}

const std::string& Banner::at(double now) {    // [s]
  if (now > until_) text_.clear();
  return text_;
}

}  // namespace halsted::app
