#pragma once
/// A live session whose pictures cost next to nothing.
#include <string>

#include "app/threads/live_session.h"

namespace halsted::app {

inline LiveOptions smallOptions(const std::string& record) {
  LiveOptions options;
  options.record = record;
  options.render = {160, 90, 10.0, false};
  return options;
}

}  // namespace halsted::app
