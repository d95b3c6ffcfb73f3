#pragma once
/// Finds the samples of the thread's curve that are, or within a step may come, near another part of it. Physics thread; no heap.
#include "sim/strand/thread_contacts.h"

namespace halsted {

inline constexpr std::size_t kMostNear = 16384;   // pairs that the search may find
inline constexpr double kNarrow = 0.5, kWide = 3.0;   // [1] of the radius: bounds of a piece's allowance
inline constexpr double kRounding = 1e-9;      // [m] by which a bound is wider, so that it cuts off nothing that the test behind it keeps

/// Fills `near` with all pairs that matter, in a fixed order, and `allowance` with half of each piece's clearance, within its bounds.
/// False when there were more than fit.
bool searchNear(const StrandModel&, const StrandState&, double dt, ThreadTouch&);   // [s]

/// Whether a pair could touch when both pieces stray as far as they may.
bool mayTouch(const NearPair&, double dt, const ThreadContactWork&);   // [s]; of a pair that the last search found

}  // namespace halsted
