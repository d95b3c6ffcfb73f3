#include "sim/cutting/cut_plan.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace halsted {
namespace {

/// Entry of the list of `from`'s neighbours that is `to`, -1 where the surface has no such edge.
int tieBetween(const SurfaceModel& s, int from, int to) {
  for (int e = s.neighbourStart[from]; e < s.neighbourStart[from + 1]; ++e)
    if (s.neighbour[e] == to) return e;
  return -1;
}

std::array<int, 12> tiesOf(const SurfaceModel& s, const std::array<int, 4>& tet) {
  std::array<int, 12> ties;
  int k = 0;
  for (int a : tet)
    for (int b : tet)
      if (a != b) ties[k++] = tieBetween(s, a, b);
  return ties;
}

CutSide sideOf(const TetMesh& mesh, const SurfaceModel& s, int tet) {
  for (int beside : s.tetNeighbour[tet])
    if (beside >= 0 && !mesh.cuttable[beside]) return mesh.cutLine[tet].fromLine < 0.0 ? CutSide::kStays : CutSide::kSpecimen;
  return CutSide::kWithin;
}

void listBins(const TetMesh& mesh, const SurfaceModel& s, CutPlan& plan) {
  const auto marked = [&](int t) { return mesh.cuttable[t] && mesh.cutLine[t].wall >= 0; };
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t)
    if (marked(t)) plan.binTet.push_back(t);
  std::stable_sort(plan.binTet.begin(), plan.binTet.end(), [&](int a, int b) {
    const CutMark &left = mesh.cutLine[a], &right = mesh.cutLine[b];
    return left.wall != right.wall ? left.wall < right.wall : left.bin < right.bin;
  });
  int wall = 0;
  for (std::size_t i = 0; i < plan.binTet.size(); ++i) {
    const CutMark& mark = mesh.cutLine[plan.binTet[i]];
    const CutMark* before = i > 0 ? &mesh.cutLine[plan.binTet[i - 1]] : nullptr;
    while (wall < mark.wall) plan.wallStart[++wall] = static_cast<int>(plan.binStart.size());
    if (!before || before->wall != mark.wall || before->bin != mark.bin) plan.binStart.push_back(static_cast<int>(i));
    plan.side.push_back(sideOf(mesh, s, plan.binTet[i]));
  }
  while (wall < kCutWalls) plan.wallStart[++wall] = static_cast<int>(plan.binStart.size());
  plan.binStart.push_back(static_cast<int>(plan.binTet.size()));
}

}  // namespace

void checkCut(const TetMesh& mesh) {
  if (mesh.cuttable.empty()) return;
  if (mesh.cuttable.size() != mesh.tets.size()) throw std::invalid_argument("anatomy: cuttable must say of every tet whether it can be cut");
  if (!mesh.cutLine.empty() && mesh.cutLine.size() != mesh.tets.size()) throw std::invalid_argument("anatomy: cutLine must be empty or name every tet");
  for (const CutMark& mark : mesh.cutLine)
    if (mark.wall >= kCutWalls || mark.bin < 0 || !(mark.fromLine > -1.0 && mark.fromLine < 1.0))
      throw std::invalid_argument("anatomy: cutLine has a mark that makes no sense");
}

CutPlan planCut(const TetMesh& mesh, const SurfaceModel& surface, const Bowels& bowels) {
  CutPlan plan;
  if (mesh.cuttable.empty()) return plan;
  for (const auto& tet : mesh.tets) plan.tetTie.push_back(tiesOf(surface, tet));
  if (!mesh.cutLine.empty()) listBins(mesh, surface, plan);
  plan.edge = rowsBehindRims(mesh, bowels);
  return plan;
}

}  // namespace halsted
