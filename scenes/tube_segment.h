#pragma once
/// Which stretch of a tube to cut: the text of anatomy.segment.
#include <string>

namespace halsted::scenes {

/// Along the tube from its start (0) to its end (1).
struct TubeSegment {
  enum class Kind { kBest, kStart, kEnd, kAt, kRange } kind = Kind::kBest;
  double rim = 0.0;       // [1] kAt, kRange: where the open rim is
  double farEnd = 0.0;    // [1] kRange: where the fixed end is; may be less than rim
};

/// "" the straightest stretch, "start", "end", "0.35" (rim there, anatomy.length long), "0.35:0.45" (rim : far end).
/// Throws InputError for anything else.
TubeSegment parseSegment(const std::string& text);

}  // namespace halsted::scenes
