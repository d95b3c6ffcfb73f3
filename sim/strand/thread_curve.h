#pragma once
/// The smooth curve that touches: a quadratic B-spline over the thread's nodes. A polygon's corners would catch on each other like teeth
/// and hold a knot that real thread does not; this curve has one tangent everywhere. Piece p is controlled by nodes p, p + 1, p + 2 and
/// runs from the middle of one segment to the middle of the next. Pure functions.
#include "sim/types.h"

namespace halsted {

struct CurveWeights {
  int node = 0;                                // of nodes node, node + 1, node + 2
  std::array<double, 3> weight{};              // [1] sum 1
};

inline CurveWeights curveWeights(int piece, double v) {   // v [1] in [0, 1]
  return {piece, {0.5 * (1.0 - v) * (1.0 - v), 0.5 + v - v * v, 0.5 * v * v}};
}

/// `nodes` is anything indexed by node: positions, velocities.
template <class Nodes> Vec3 curvePoint(const Nodes& nodes, const CurveWeights& w) {
  return w.weight[0] * nodes[w.node] + w.weight[1] * nodes[w.node + 1] + w.weight[2] * nodes[w.node + 2];
}

/// Of a piece what `nearestOn` needs, whatever the point.
struct PieceShape {
  Vec3 start, along, turn;                     // [m] where it begins; twice its slope there; what that changes by on its way
  double c1 = 0.0, c2 = 0.0, c3 = 0.0;         // [m^2]
};

template <class Nodes> PieceShape pieceShape(const Nodes& nodes, int piece) {
  const Vec3 e0 = nodes[piece + 1] - nodes[piece], e1 = nodes[piece + 2] - nodes[piece + 1], c = e1 - e0;
  return {0.5 * (nodes[piece] + nodes[piece + 1]), e0, c, e0.dot(e0), 1.5 * e0.dot(c), 0.5 * c.dot(c)};
}

/// The place [1] on a piece where its distance from `point` has a minimum; negative when it has none there. Neighbouring pieces share
/// the derivative at their joint, so every minimum of the whole curve is found once.
inline double nearestOn(const PieceShape& piece, const Vec3& point) {   // [m]
  const Vec3 q = piece.start - point;
  const double c0 = q.dot(piece.along), c1 = q.dot(piece.turn) + piece.c1, c2 = piece.c2, c3 = piece.c3;   // [m^2]
  if (c0 > 0.0 || c0 + c1 + c2 + c3 <= 0.0) return -1.0;
  double low = 0.0, high = 1.0, v = -c0 / (c1 + c2 + c3);   // [1]
  for (int k = 0; k < 64; ++k) {                 // Newton, halving where it leaves the bracket; four steps as a rule
    const double value = c0 + v * (c1 + v * (c2 + v * c3));   // [m^2]
    const double slope = c1 + v * (2.0 * c2 + v * 3.0 * c3);   // [m^2]
    if (std::abs(value) <= 1e-13 * slope) break;   // before the bracket is asked: at the root a step no longer leaves its edge
    (value > 0.0 ? high : low) = v;
    const double next = slope > 0.0 ? v - value / slope : low;   // [1]
    v = next > low && next < high ? next : 0.5 * (low + high);
  }
  return v;
}

template <class Nodes> double nearestOnPiece(const Nodes& nodes, int piece, const Vec3& point) { return nearestOn(pieceShape(nodes, piece), point); }

}  // namespace halsted
