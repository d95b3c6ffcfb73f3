#pragma once
/// What a mesh says of the cut that is planned in it, laid out for the step. Built at load time; empty where nothing can be cut.
#include <array>
#include <vector>

#include "sim/contact/surface.h"
#include "sim/cutting/edge.h"
#include "sim/mesh.h"

namespace halsted {

enum class CutSide : char { kWithin, kStays, kSpecimen };        // of a tet beside tissue that cannot be cut

struct CutPlan {
  std::vector<std::array<int, 12>> tetTie;     // per tet: entries of SurfaceModel::neighbour that join two of its corners, -1 where none
  // Tets of each part (bin) of each wall's circumference: bins of wall w are binStart[wallStart[w]] ..; where there is a line.
  std::array<int, kCutWalls + 1> wallStart{};  // index into binStart
  std::vector<int> binStart, binTet;
  std::vector<CutSide> side;                   // per entry of binTet
  EdgeRows edge;
  bool present() const { return !tetTie.empty(); }
};

/// Throws std::invalid_argument when the mesh's lists do not fit its tets. To be asked before the surface is built, which reads them.
void checkCut(const TetMesh&);

CutPlan planCut(const TetMesh&, const SurfaceModel&, const Bowels&);

}  // namespace halsted
