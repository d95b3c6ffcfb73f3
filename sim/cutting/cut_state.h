#pragma once
/// What follows from the tets that are gone: found anew in a step in which one went, kept so that no other step pays. Written by sim/cutting.
#include <array>
#include <cstdint>
#include <vector>

#include "sim/mesh.h"

namespace halsted {

/// Part of `State` of a scene with tissue that can be cut.
struct CutState {
  std::vector<std::int32_t> piece;             // per tet: 0 hangs on what is held in place; 1 .. `pieces` a free piece, by its first tet; -1 gone
  std::vector<std::uint8_t> bare;              // per particle: 1 = corner of a triangle that can be touched
  std::vector<std::uint8_t> tie;               // per entry of SurfaceModel::neighbour: 1 = a tet that is left holds both ends
  std::array<std::vector<std::int32_t>, kCutWalls> edge;   // per wall and column of its rim: vertex of the edge that is left, sim/cutting/edge.h
  std::int32_t pieces = 0;                     // free ones
  std::int32_t goneTets = 0;
};

/// Scratch, sized by `initialState`.
struct CutWork {
  std::vector<std::int32_t> parent, label;     // per particle
  std::vector<double> volume;                  // [m^3] per free piece; as many as there are tets
};

}  // namespace halsted
