#pragma once
/// The edge of a wall that has been cut: round the opening, column by column, the first row of its serosa that is whole toward the base. Before
/// the cut it is the rim that the mesh names, on the planned line; a cut that strays, or chars its way into the side that stays, moves it back.
/// Physics thread; no heap.
#include <array>
#include <span>
#include <vector>

#include "sim/bowels.h"
#include "sim/mesh.h"

namespace halsted {

struct Model;
struct State;

/// One row behind a rim, and the tets toward the next.
struct EdgeRow {
  int vertex = 0, mucosa = 0;                  // on the serosa; opposite to it
  std::vector<int> behind;                     // tets beside the column, between this row and the next one toward the base
};

/// Built at load time. Per wall and column of its rim: the rows from the rim to the base.
using EdgeRows = std::array<std::vector<std::vector<EdgeRow>>, kCutWalls>;

/// Empty where nothing can be cut, or a wall has no rim.
EdgeRows rowsBehindRims(const TetMesh&, const Bowels&);

/// After tets went: writes `CutState::edge`.
void findEdges(const Model&, State&);

/// Of a bowel, in the rim's order: its rim where nothing can be cut, else the edge that is left.
std::span<const int> edgeOf(const Model&, const State&, int bowel);

}  // namespace halsted
