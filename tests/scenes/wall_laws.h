#pragma once
/// Laws that every wall of tetrahedra obeys, whatever anatomy it was built from; and how bad input must be refused.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/mesh.h"

namespace halsted::testing {

/// Positive volumes, conforming tets, closed outward surface of Euler characteristic 0, layers, rim and far end as scene.h promises.
void expectWholeWall(const TetMesh&);

/// Runs `read` and expects one InputError line that contains every one of `parts`.
void expectRefused(const std::function<void()>& read, const std::vector<std::string>& parts);

/// FNV-1a over vertices, tets, surface, layers, uv, fixed and rim.
std::uint64_t bitsOf(const TetMesh&);

double worstQuality(const TetMesh&);                             // [1] see tetQuality
double largestDistanceToOuterLayer(const TetMesh&);              // [m] over the inner vertices
double leastDistanceToOuterLayer(const TetMesh&);                // [m]

}  // namespace halsted::testing
