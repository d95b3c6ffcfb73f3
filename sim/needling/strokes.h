#pragma once
/// Counts movement to and fro: lifting and thrusting, twirling. A stroke ends where the movement has turned back by a threshold.
#include "sim/types.h"

namespace halsted {

/// Unit of every length here: that of what moves, [m] or [rad].
struct Strokes {
  std::int32_t direction = 0;                  // 1 rising, -1 falling, 0 not moved yet
  double extreme = 0.0, lastTurn = 0.0;        // [m or rad] farthest on the way; where it turned back last
  std::int32_t count = 0, counted = 0;         // strokes one way; those of an amplitude within the limits
  double amplitude = 0.0, amplitudeSquares = 0.0;   // [m or rad], squared: sums over `counted`: the way in is no stroke of the practice
  double trough = 0.0, troughSquares = 0.0;    // [m or rad], squared: sums of the lower turns of those
  std::int32_t troughs = 0;
};

struct StrokeLimits { double turnBack = 0.0, least = 0.0, most = 0.0; };   // [m or rad]

void followStroke(const StrokeLimits&, double x, Strokes&);   // x [m or rad]

}  // namespace halsted
