#pragma once
/// Finds the samples of the thread's curve that are, or within a step may come, near another part of it. Physics thread; no heap.
#include "sim/strand/thread_contacts.h"

namespace halsted {

/// A sample and the place on another piece that is nearest to it.
struct NearPair { int piece, sample, partner; double place; };   // [1]

/// Bounding spheres of pieces and of chunks of pieces, and the fastest node.
void boundPieces(const StrandModel&, const StrandState&, ThreadContactWork&);

/// Calls `found(NearPair)` for each, in a fixed order.
template <class Found> void searchPairs(const StrandModel&, const StrandState&, double dt, const ThreadContactWork&, Found&& found);   // [s]

inline constexpr int kChunk = 8;               // pieces in a chunk

/// Pieces of one stretch of thread that are too near along it to touch: a thread cannot be bent tighter than its own width.
inline int nearestNeighbour(const StrandModel& m) {
  const int widths = static_cast<int>(4.0 * m.radius / m.segment) + 1;
  return widths > 3 ? widths : 3;
}

/// How far apart a pair is still of interest: at rest a share of the width, and what its motion covers.  [m]
inline double searchReach(const StrandModel& m, double speed, double dt) { return 2.5 * m.radius + 1.2 * dt * speed; }   // [m/s], [s]

template <class Found>
void searchPieces(const StrandModel& m, const StrandState& s, double dt, const ThreadContactWork& w, std::pair<int, int> pieces, Found&& found) {   // [s]
  const auto [p, q] = pieces;
  const Vec3 relative = curvePoint(s.velocity, curveWeights(p, 0.5)) - curvePoint(s.velocity, curveWeights(q, 0.5));
  const double reach = searchReach(m, relative.norm(), dt), sum = w.pieceRadius[p] + w.pieceRadius[q] + reach;   // [m]
  if ((w.pieceCentre[p] - w.pieceCentre[q]).squaredNorm() > sum * sum) return;
  for (int side = 0; side < 2; ++side) {
    const int own = side ? q : p, other = side ? p : q;
    for (int k = 0; k < kSamples; ++k) {
      const Vec3 point = curvePoint(s.position, curveWeights(own, (k + 0.5) / kSamples));
      const double place = nearestOnPiece(s.position, other, point);   // [1]
      if (place < 0.0) continue;
      if ((point - curvePoint(s.position, curveWeights(other, place))).squaredNorm() < reach * reach) found(NearPair{own, k, other, place});
    }
  }
}

template <class Found> void searchPairs(const StrandModel& m, const StrandState& s, double dt, const ThreadContactWork& w, Found&& found) {   // [s]
  const int pieces = m.nodes - 2, chunks = static_cast<int>(w.chunkCentre.size()), apart = nearestNeighbour(m);
  for (int a = 0; a < chunks; ++a)
    for (int b = a; b < chunks; ++b) {
      const double sum = w.chunkRadius[a] + w.chunkRadius[b] + searchReach(m, 2.0 * w.fastest, dt);   // [m]
      if ((w.chunkCentre[a] - w.chunkCentre[b]).squaredNorm() > sum * sum) continue;
      const int endA = std::min(pieces, kChunk * (a + 1)), endB = std::min(pieces, kChunk * (b + 1));
      for (int p = kChunk * a; p < endA; ++p)
        for (int q = std::max(kChunk * b, p + apart); q < endB; ++q) searchPieces(m, s, dt, w, {p, q}, found);
    }
}

}  // namespace halsted
