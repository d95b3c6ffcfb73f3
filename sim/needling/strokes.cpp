#include "sim/needling/strokes.h"

namespace halsted {
namespace {

void turnBack(const StrokeLimits& limits, Strokes& s) {
  const double size = s.direction > 0 ? s.extreme - s.lastTurn : s.lastTurn - s.extreme;   // [m or rad]
  const bool inRange = size >= limits.least && size <= limits.most;
  ++s.count;
  if (inRange) {
    ++s.counted;
    s.amplitude += size;
    s.amplitudeSquares += size * size;
  }
  if (inRange && s.direction < 0) {
    ++s.troughs;
    s.trough += s.extreme;
    s.troughSquares += s.extreme * s.extreme;
  }
  s.lastTurn = s.extreme;
  s.direction = -s.direction;
}

}  // namespace

void followStroke(const StrokeLimits& limits, double x, Strokes& s) {
  if (s.direction == 0) {                      // the first movement: no stroke yet, it comes from anywhere
    const double moved = x - s.lastTurn;       // [m or rad]
    if (moved > limits.turnBack || moved < -limits.turnBack) { s.direction = moved > 0.0 ? 1 : -1; s.extreme = x; }
    return;
  }
  const double on = s.direction > 0 ? x - s.extreme : s.extreme - x;   // [m or rad]
  if (on >= 0.0) { s.extreme = x; return; }
  if (on > -limits.turnBack) return;
  turnBack(limits, s);
  s.extreme = x;
}

}  // namespace halsted
