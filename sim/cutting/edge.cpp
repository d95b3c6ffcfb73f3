#include "sim/cutting/edge.h"

#include <algorithm>
#include <cmath>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted {
namespace {

constexpr double kSame = 1e-6;                 // [m], [1 of a turn] vertices of one row, of one column

/// Serosa of one column from a rim vertex toward the base, where `uv.y` grows.
std::vector<EdgeRow> columnBehind(const TetMesh& mesh, const Bowels& b, int rim) {
  std::vector<EdgeRow> rows;
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    const bool column = b.of[v] == b.of[rim] && b.wallDepth[v] == 0.0 && std::fabs(mesh.uv[v].x() - mesh.uv[rim].x()) < kSame;
    if (column && mesh.uv[v].y() > mesh.uv[rim].y() - kSame) rows.push_back({v, v, {}});
  }
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v)
    for (EdgeRow& row : rows)
      if (b.of[v] == b.of[rim] && b.wallDepth[v] == 1.0 && (mesh.uv[v] - mesh.uv[row.vertex]).norm() < kSame) row.mucosa = v;
  std::sort(rows.begin(), rows.end(), [&](const EdgeRow& one, const EdgeRow& other) { return mesh.uv[one.vertex].y() < mesh.uv[other.vertex].y(); });
  return rows;
}

/// Of the tets that can go and touch the column on either of its layers: those between two of its rows.
void findBehind(const TetMesh& mesh, const Bowels& b, std::vector<EdgeRow>& rows) {
  const double turn = mesh.uv[rows[0].vertex].x();               // [1]
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
    if (!mesh.cuttable[t] || b.of[mesh.tets[t][0]] != b.of[rows[0].vertex]) continue;
    bool beside = false;
    double nearest = 1e300;                    // [m] of its corners to the line, toward the base
    for (int v : mesh.tets[t]) {
      beside = beside || std::fabs(mesh.uv[v].x() - turn) < kSame;
      nearest = std::fmin(nearest, mesh.uv[v].y());
    }
    for (EdgeRow& row : rows)
      if (beside && std::fabs(mesh.uv[row.vertex].y() - nearest) < kSame) row.behind.push_back(t);
  }
}

/// From the base upward as far as nothing has gone.
int lastWhole(const State& s, const std::vector<EdgeRow>& rows) {
  int vertex = rows.back().vertex;
  for (std::size_t i = rows.size() - 1; i-- > 0;) {
    for (int t : rows[i].behind)
      if (s.tissue.gone[t]) return vertex;
    vertex = rows[i].vertex;
  }
  return vertex;
}

}  // namespace

EdgeRows rowsBehindRims(const TetMesh& mesh, const Bowels& b) {
  EdgeRows edges;
  if (mesh.cuttable.empty() || mesh.uv.size() != mesh.vertices.size()) return edges;
  for (int wall = 0; wall < kCutWalls && wall < b.count; ++wall)
    for (int rim : b.rim[wall]) {
      edges[wall].push_back(columnBehind(mesh, b, rim));
      findBehind(mesh, b, edges[wall].back());
    }
  return edges;
}

void findEdges(const Model& m, State& s) {
  for (int wall = 0; wall < kCutWalls; ++wall)
    for (std::size_t i = 0; i < s.cut->edge[wall].size(); ++i) s.cut->edge[wall][i] = lastWhole(s, m.cut.edge[wall][i]);
}

std::span<const int> edgeOf(const Model& m, const State& s, int bowel) {
  if (s.cut && bowel < kCutWalls && !s.cut->edge[bowel].empty()) return s.cut->edge[bowel];
  return m.bowels.rim[bowel];
}

}  // namespace halsted
