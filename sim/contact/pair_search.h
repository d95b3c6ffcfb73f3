#pragma once
/// Tissue against itself: which surface vertices are so near to which triangles that a contact may follow. The search is spread over
/// kPairRound steps, every kPairRound-th triangle in each, so that no step pays for all of it. Nothing that changes the outcome is carried
/// from step to step: a turn looks at the vertices where they are now. Where nothing has moved far it looks at a list of its last search
/// instead of the cells, and finds the same pairs in the same order. Physics thread; no heap.
///
/// A vertex that comes nearer than kPairReach between two looks is found while it is no deeper than kPairBehind, whatever closes
/// slower than (kPairReach + kPairBehind) / kPairRound: 0.27 m/s at a step of 1 ms.
#include <array>
#include <span>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

inline constexpr int kPairRound = SelfWork::kRound;
inline constexpr double kPairReach = 1.2e-3;     // [m] a vertex this near to a triangle is watched
inline constexpr double kPairBehind = 1.0e-3;    // [m] half a wall: deeper, the vertex belongs to the other side
inline constexpr double kPairAside = 0.5e-3;     // [m] and no farther than this from the triangle within its plane
inline constexpr double kPairDrift = 0.4e-3;     // [m] a list of near pairs holds while every vertex is this near to where it was

PairGap pairGap(const Model&, const SurfaceNow&, int vertex, int triangle);

/// False where contact has nothing to do: neighbours on the surface, which elasticity keeps apart, what is held in place altogether, and
/// vertices that no cut has laid bare.
bool mayTouch(const Model&, int vertex, int triangle, const CutState* cut = nullptr);

/// Looks anew at the triangles whose turn it is at `state.step`: pairs that carry force stay, the others stay or come as they are near.
void searchPairs(const Model&, State&);

}  // namespace halsted
