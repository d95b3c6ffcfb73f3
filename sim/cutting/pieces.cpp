#include "sim/cutting/pieces.h"

#include <algorithm>
#include <span>

#include "sim/cutting/edge.h"
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"
#include "sim/suture/holes.h"
#include "sim/union_find.h"

namespace halsted {
namespace {

constexpr int kTakeInterval = 16;              // steps between looks at how far free pieces are

void joinCorners(const Model& m, State& s) {
  auto& parent = s.work.cut.parent;
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = static_cast<std::int32_t>(v);
  for (std::size_t t = 0; t < m.tissue.tets.size(); ++t) {
    if (s.tissue.gone[t]) continue;
    for (int c = 1; c < 4; ++c) join(parent, m.tissue.tets[t][0], m.tissue.tets[t][c]);
  }
  for (int v : m.mesh.fixed) join(parent, m.mesh.fixed[0], v);   // what is held in place hangs together by what holds it
}

/// Where nothing is held, the piece of the first tet counts as the rest.
int heldRoot(const Model& m, State& s) {
  if (!m.mesh.fixed.empty()) return rootOf(s.work.cut.parent, m.mesh.fixed[0]);
  for (std::size_t t = 0; t < m.tissue.tets.size(); ++t)
    if (!s.tissue.gone[t]) return rootOf(s.work.cut.parent, m.tissue.tets[t][0]);
  return 0;
}

void numberPieces(const Model& m, State& s) {
  CutState& cut = *s.cut;
  CutWork& w = s.work.cut;
  std::fill(w.label.begin(), w.label.end(), -1);
  w.label[heldRoot(m, s)] = 0;
  w.volume[0] = 0.0;
  std::fill(s.tissue.piece.begin(), s.tissue.piece.end(), -1);
  cut.pieces = cut.goneTets = 0;
  for (std::size_t t = 0; t < cut.piece.size(); ++t) {
    cut.piece[t] = -1;
    if (s.tissue.gone[t]) { ++cut.goneTets; continue; }
    std::int32_t& label = w.label[rootOf(w.parent, m.tissue.tets[t][0])];
    if (label < 0) { label = ++cut.pieces; w.volume[label] = 0.0; }
    cut.piece[t] = label;
    for (int v : m.tissue.tets[t]) s.tissue.piece[v] = label;
    w.volume[label] += m.tissue.restVolume[t];
  }
}

void markBare(const Model& m, State& s) {
  auto& bare = s.cut->bare;
  std::fill(bare.begin(), bare.end(), std::uint8_t{0});
  for (int f = 0; f < static_cast<int>(m.surface.triangles.size()); ++f) {
    if (!exposed(m.surface, s.tissue.gone, f)) continue;
    for (int v : m.surface.triangles[f]) bare[v] = 1;
  }
}

void markTies(const Model& m, State& s) {
  auto& tie = s.cut->tie;
  std::fill(tie.begin(), tie.end(), std::uint8_t{0});
  for (std::size_t t = 0; t < m.cut.tetTie.size(); ++t) {
    if (s.tissue.gone[t]) continue;
    for (int e : m.cut.tetTie[t])
      if (e >= 0) tie[e] = 1;
  }
}

/// Summed in the order in which the masses were: where nothing is gone the share is one to the last bit.
void weighParticles(const Model& m, State& s) {
  auto& left = s.tissue.left;
  std::fill(left.begin(), left.end(), 0.0);
  for (std::size_t t = 0; t < m.tissue.tets.size(); ++t) {
    if (s.tissue.gone[t]) continue;
    for (int v : m.tissue.tets[t]) left[v] += m.params.tissue.density * m.tissue.restVolume[t] / 4.0;
  }
  for (std::size_t v = 0; v < left.size(); ++v) left[v] /= m.tissue.mass[v];
}

void takePiece(int piece, State& s) {
  for (std::size_t t = 0; t < s.cut->piece.size(); ++t)
    if (s.cut->piece[t] == piece) s.tissue.gone[t] = static_cast<std::uint8_t>(Gone::kTaken);
}

/// Smallest and largest coordinates of a piece.
struct Box { Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300); };   // [m]

Box boxOf(const Model& m, const State& s, int piece) {
  Box box;
  for (std::size_t t = 0; t < s.cut->piece.size(); ++t) {
    if (s.cut->piece[t] != piece) continue;
    for (int v : m.tissue.tets[t]) {
      box.low = box.low.cwiseMin(s.tissue.position[v]);
      box.high = box.high.cwiseMax(s.tissue.position[v]);
    }
  }
  return box;
}

bool holdsSome(const Model& m, const State& s, const TissueGrasp& grasp, int piece) {
  for (int g = 0; g < grasp.count; ++g)
    if (s.cut->piece[m.surface.triangleTet[grasp.triangle[g]]] == piece) return true;
  return false;
}

}  // namespace

void findPieces(const Model& m, State& s) {
  joinCorners(m, s);
  numberPieces(m, s);
  markBare(m, s);
  markTies(m, s);
  weighParticles(m, s);
  findEdges(m, s);
}

void settlePieces(const Model& m, State& s, StepOutput& out) {
  CutMetrics& metrics = *s.metrics.cut;
  const int before = s.cut->pieces;
  findPieces(m, s);
  const int crumbsBefore = metrics.crumbs;
  for (int piece = 1; piece <= s.cut->pieces; ++piece) {
    if (s.work.cut.volume[piece] > m.params.cautery.crumb) continue;
    takePiece(piece, s);
    ++metrics.crumbs;
  }
  if (metrics.crumbs > crumbsBefore) findPieces(m, s);
  metrics.freePieces = s.cut->pieces;
  metrics.freeVolume = 0.0;
  for (int piece = 1; piece <= s.cut->pieces; ++piece) metrics.freeVolume += s.work.cut.volume[piece];
  if (s.cut->pieces > before) pushEvent(out, {s.step, EventKind::kPieceFree, -1, s.cut->pieces, metrics.freeVolume});
}

bool heldByHand(const Model& m, const State& s, int piece) {
  return std::any_of(s.tools.begin(), s.tools.end(), [&](const ToolState& t) { return holdsSome(m, s, t.grasp, piece); });
}

bool heldByClamp(const Model& m, const State& s, int piece) {
  for (int k = 0; s.clamps && k < s.clamps->count; ++k)
    if (holdsSome(m, s, s.clamps->clamp[k].grasp, piece)) return true;
  return false;
}

bool takeAwayPieces(const Model& m, State& s, StepOutput& out) {
  if (s.cut->pieces == 0 || s.step % kTakeInterval != 0) return false;
  const Box rest = boxOf(m, s, 0);
  const double far = m.params.cautery.takeAway;                  // [m]
  bool any = false;
  for (int piece = 1; piece <= s.cut->pieces; ++piece) {
    const Box box = boxOf(m, s, piece);
    const Vec3 gap = (box.low - rest.high).cwiseMax(rest.low - box.high).cwiseMax(Vec3::Zero());   // [m]
    if (gap.squaredNorm() <= far * far || heldByHand(m, s, piece) || heldByClamp(m, s, piece)) continue;
    double volume = 0.0;                                         // [m^3]
    for (std::size_t t = 0; t < s.cut->piece.size(); ++t)
      if (s.cut->piece[t] == piece) volume += m.tissue.restVolume[t];
    takePiece(piece, s);
    pushEvent(out, {s.step, EventKind::kPieceTaken, -1, ++s.metrics.cut->taken, volume});
    any = true;
  }
  return any;
}

}  // namespace halsted
