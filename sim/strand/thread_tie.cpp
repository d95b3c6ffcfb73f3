#include "sim/strand/thread_tie.h"

#include <algorithm>

namespace halsted {
namespace {

void addEnd(const CurveWeights& w, double stiffness, const Vec3& force, BandedMatrix& matrix, std::vector<double>& rhs) {
  for (int a = 0; a < 3; ++a)
    for (int r = 0; r < 3; ++r) {
      rhs[3 * (w.node + a) + r] += w.weight[a] * force[r];
      for (int b = a; b < 3; ++b) matrix.add(3 * (w.node + a) + r, 3 * (w.node + b) + r, w.weight[a] * w.weight[b] * stiffness);
    }
}

}  // namespace

CurveWeights segmentWeights(const StrandModel& m, double coordinate) {
  const ThreadSpot spot = threadSpot(m, coordinate);
  if (spot.node + 2 < m.nodes) return {spot.node, {1.0 - spot.fraction, spot.fraction, 0.0}};
  return {m.nodes - 3, {0.0, 1.0 - spot.fraction, spot.fraction}};
}

Vec3 tieForce(const ThreadTie& t, const std::vector<Vec3>& nodes) {
  return t.stiffness * (t.apart - (curvePoint(nodes, t.first) - curvePoint(nodes, t.second)));
}

void assembleTie(const ThreadTie& t, const std::vector<Vec3>& iterate, BandedMatrix& matrix, std::vector<double>& rhs, CoupledSolve& coupled) {
  const Vec3 force = tieForce(t, iterate);
  addEnd(t.first, t.stiffness, force, matrix, rhs);
  addEnd(t.second, t.stiffness, -force, matrix, rhs);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) {
      const int i = t.first.node + a, j = t.second.node + b;
      const Mat3 block = -t.first.weight[a] * t.second.weight[b] * t.stiffness * Mat3::Identity();
      if (i != j) coupled.add(std::max(i, j), std::min(i, j), block);
      else coupled.add(i, j, 2.0 * block);     // a node that both places share
    }
}

}  // namespace halsted
