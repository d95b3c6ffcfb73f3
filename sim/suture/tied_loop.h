#pragma once
/// The loop of the stitch under way, from knot to knot through its holes: how much thread it has, and whether it pulls. Physics thread; no heap.
#include <optional>

namespace halsted {

struct Model;
struct State;

/// Between these coordinates the strand is a closed loop: where its two ends enter the knot.
struct TiedLoop {
  double tail = 0.0, tip = 0.0;                // [m]
};

/// The stitch of the running strand, if it is tied and the needle cut off; whether by the beginner's knot or by throws that lock.
std::optional<TiedLoop> finishedLoop(const Model&, const State&);

/// Pull of the loop on the knot: the lesser of its two strands' between knot and tissue, the mean of each.  [N]
double loopPull(const Model&, const State&, const TiedLoop&);

/// Mean tension all the way round.  [N]
double loopTension(const Model&, const State&, const TiedLoop&);

/// Whether it is drawn: with a hundredth of a newton.
bool isTaut(const Model&, const State&, const TiedLoop&);

/// Its thread outside the wall beyond the shortest way from hole to hole; negative where throws that lie wide span a part of that.  [m]
double threadBeyondWay(const Model&, const State&, const TiedLoop&);

/// What of that could be lifted off the wall: none in a loop that is taut, whatever it is drawn over.  [m]
double loopSlack(const Model&, const State&, const TiedLoop&);

}  // namespace halsted
