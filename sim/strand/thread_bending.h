#pragma once
/// Bending of the thread: quadratic in the curl of each node (Bergou et al. 2006), a constant matrix with a linear moment for a straight
/// thread, where the cosine form of paper 003 has none. Thread that knots is elasto-plastic: its moment is capped at `yield_moment`, and
/// what it is bent beyond that it keeps (its set). A knot of purely elastic thread springs open and holds too little (physics.md B5;
/// Johanns et al. 2023). A set turns with the thread and not about it: there is no torsion. Physics thread; no heap.
#include <cstdint>
#include <span>
#include <vector>

#include "sim/strand/banded.h"
#include "sim/strand/strand_model.h"

namespace halsted {

/// What bends: `set` is empty where the thread is elastic, `cut` where it cannot be cut.
struct BendingState {
  std::span<const Vec3> set;                   // [m] curl at rest, of each node but the two ends
  std::span<const std::uint8_t> cut;           // [1] per segment
};

/// Forces and stiffness at an iterate, into the strand's system.
void assembleBending(const StrandModel&, const std::vector<Vec3>& iterate, const BendingState&, BandedMatrix&, std::vector<double>& rhs);   // [m], [N]

/// After a step: the set turns with the thread from where it was, and grows by what it is bent beyond its yield.
void takeSet(const StrandModel&, const std::vector<Vec3>& before, const std::vector<Vec3>& now, std::vector<Vec3>& set);   // [m]

}  // namespace halsted
