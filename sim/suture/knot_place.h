#pragma once
/// Where the knot lies on the thread: its strands push on each other there. A strand that only lies across the loop pushes with next to
/// nothing, so the outermost twentieth of the push on either side is passed over; but not, toward the loop, what lies against the knot
/// itself. Physics thread; no heap.
#include <optional>

namespace halsted {

struct Model;
struct State;

/// Coordinates at which the two strands of the loop enter the knot, and at which they leave it.
struct KnotPlace {
  double tail = 0.0, tip = 0.0;                // [m] before the first hole, past the last
  double tailOut = 0.0, tipOut = 0.0;          // [m] farther from the holes
};

/// Nothing where thread before the first hole does not press on thread past the last.
std::optional<KnotPlace> placeOfKnot(const Model&, const State&);

}  // namespace halsted
