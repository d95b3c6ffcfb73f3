#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sim/types.h"

namespace halsted {

enum class Gone : std::uint8_t { kNo, kBurnt, kTaken };   // kTaken: with a free piece that was carried away

/// Written by sim/tissue.
struct TissueState {
  std::vector<Vec3> position, velocity;        // [m], [m/s] one per particle
  std::vector<Quat> rotation;                  // per tet (projective) or cluster (shape matching): warm start of the polar factor
  std::vector<double> pressure;                // [Pa] per tet: volumetric part of the stress (projective)
  std::vector<Vec3> rodForce;                  // [N] per particle: on the tissue from the fixed rod
  static constexpr int kMaxPairs = 2048;
  std::int32_t pairCount = 0;                  // tissue against itself: a vertex near a triangle (sim/contact/pair_search.h)
  std::int32_t droppedPairs = 0;               // pairs that did not fit
  std::array<std::int32_t, kMaxPairs> pairVertex{}, pairTriangle{};
  std::array<double, kMaxPairs> pairForce{};   // [N] along the triangle's normal, on the vertex
  // Of a scene with tissue that can be cut, else empty. Written by sim/cutting:
  std::vector<double> heat;                    // [J] per tet, that current has left there; none of it flows on
  std::vector<std::uint8_t> gone;              // per tet: Gone
  std::vector<double> left;                    // [1] per particle: share of its mass in tets that are left; 0: it belongs to nothing any more
  std::vector<std::int32_t> piece;             // per particle: 0 hangs on what is held in place, 1 .. a free piece, -1 belongs to nothing any more
};

}  // namespace halsted
