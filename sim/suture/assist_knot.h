#pragma once
/// An assistance for beginners, not physics: the knot object of paper 003 (physics.md A1, items 15 and 16). `thread.assist = "knot"` turns
/// it on, the session's record carries that parameter, and reports name it.
///
/// When both hands hold the two tails of the stitch, these have gone at least half round each other between the tissue and the hands,
/// and both are drawn past a tension, a knot is placed where they cross: the two strands are held to each other there by a spring in the
/// strand's own solve. While both hands draw, it runs down to the tissue and draws the two sides together; it runs back only where the
/// tissue pulls far harder than they do. Once it lies on the tissue and is no longer drawn, it locks; letting go of a tail before it lies there undoes it.
/// A locked knot holds a difference of tension of `thread.assist_holding` in either strand; pulled past that, it slips. Thread does not
/// go back through the tissue past the knot. When it locks, the event is that of a throw of no turns: none was tied. Physics thread; no heap.
#include <cstdint>

#include "sim/types.h"

namespace halsted {

struct Model;
struct State;
struct StepOutput;

/// Part of `State` in a scene with this assistance.
struct AssistKnot {
  bool placed = false, locked = false;
  double tail = 0.0, tip = 0.0;                // [m] coordinates that are held to each other: before the first hole, past the last
  double apart = 0.0;                          // [m] between them, as wanted now
  double drawn = 0.0;                          // [s] that both tails have been crossed and tight
  double seated = 0.0;                         // [s] that the knot has been drawn on the tissue
  std::array<double, 2> felt{};                // [N] tension on the hand's side over that on the tissue's, of either strand; a short mean
  std::int32_t locks = 0;                      // knots that locked
  double slipped = 0.0;                        // [m] of thread that was pulled through a locked knot
};

/// Before the strand's solve: sets its tie.
void linkAssistKnot(const Model&, State&);
/// After it: places the knot, lets it run, lock, slip, or come undone.
void settleAssistKnot(const Model&, State&, StepOutput&);

/// Half turns of the two tails about each other between the tissue and two places on them, signed.  [m] [1]
int halfTurns(const Model&, const State&, double tail, double tip);

}  // namespace halsted
