#pragma once
/// The line over the picture: what happened last, for a few seconds. A fault, or what has torn, keeps its time; only another takes its place.
#include <string>

#include "sim/exchange.h"
#include "sim/model.h"

namespace halsted::app {

class Banner {
 public:
  void tell(const Event&, const Model&, double now);   // [s] by any clock
  const std::string& at(double now);           // [s] by the same one; empty: nothing to say

 private:
  std::string text_;
  double until_ = 0.0, graveUntil_ = 0.0;      // [s]
};

}  // namespace halsted::app
