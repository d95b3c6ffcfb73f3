#pragma once
/// What has been tied, as it was last read in full from the thread's course. Part of `State`; written by sim/suture/knot_watch.
#include <array>
#include <cstdint>

#include "sim/types.h"

namespace halsted {

struct KnotState {
  static constexpr int kMostThrows = 12;
  bool watched = false;                        // the scene's thread meets itself; nothing below is written otherwise
  bool complete = false;                       // it has been read: every crossing of the thread belonged to a throw
  std::int32_t throws = 0;
  std::array<std::int32_t, kMostThrows> turns{}, sense{};   // [1] of each throw in the order of tying; +1 or -1
  std::int32_t crossingsLeft = 0;              // at the last look, in full or not
  double tail = 0.0, tip = 0.0;                // [m] coordinates at which the loop's two strands enter the knot (knot_place.h)
  std::array<std::int32_t, kHands> toolTurns{};     // [1] signed turns of the thread about each tool
  std::int32_t breaks = 0;                     // places where the thread is parted
  std::int32_t cuts = 0;                       // of these, with blades
};

/// Pairs of neighbouring throws of opposite sense: each locks the one before (=). And of the same sense: each lets it slide (x).
inline int locks(const KnotState& k) {
  int count = 0;
  for (int i = 0; i + 1 < k.throws; ++i) count += k.sense[i] != k.sense[i + 1] ? 1 : 0;
  return count;
}
inline int slides(const KnotState& k) { return k.throws > 0 ? k.throws - 1 - locks(k) : 0; }

/// Turns of all throws.
inline int turns(const KnotState& k) {
  int count = 0;
  for (int i = 0; i < k.throws; ++i) count += k.turns[i];
  return count;
}

}  // namespace halsted
