#include "sim/suture/cut.h"

namespace halsted {
namespace {

constexpr int kMaxTetsPerStep = 12;

std::array<double, 4> weightsAt(const Model& m, std::span<const Vec3> x, int tet, const Vec3& p) {
  const auto& v = m.tissue.tets[tet];
  const Vec3 a = x[v[1]] - x[v[0]], b = x[v[2]] - x[v[0]], c = x[v[3]] - x[v[0]], d = p - x[v[0]];
  const double volume = a.dot(b.cross(c));     // [m^3] six times the tet's volume; never zero for a tet that still has one
  const double scale = volume != 0.0 ? 1.0 / volume : 0.0;
  const double w1 = d.dot(b.cross(c)) * scale, w2 = a.dot(d.cross(c)) * scale, w3 = a.dot(b.cross(d)) * scale;
  return {1.0 - w1 - w2 - w3, w1, w2, w3};
}

int mostNegative(const std::array<double, 4>& w) {
  int least = 0;
  for (int c = 1; c < 4; ++c)
    if (w[c] < w[least]) least = c;
  return least;
}

Vec3 pointAt(const Model& m, std::span<const Vec3> x, int tet, const std::array<double, 4>& w) {
  const auto& v = m.tissue.tets[tet];
  return w[0] * x[v[0]] + w[1] * x[v[1]] + w[2] * x[v[2]] + w[3] * x[v[3]];
}

/// The part of the way from `from` to `to` until the first weight becomes zero [1].
double shareInside(const std::array<double, 4>& from, const std::array<double, 4>& to) {
  double share = 1.0;
  for (int c = 0; c < 4; ++c) {
    if (to[c] >= 0.0 || from[c] - to[c] <= 0.0) continue;
    const double reach = from[c] > 0.0 ? from[c] / (from[c] - to[c]) : 0.0;
    if (reach < share) share = reach;
  }
  return share;
}

}  // namespace

CutResult advanceCut(const Model& m, const SurfaceNow& tissue, const Vec3& step, Hole& hole) {
  const std::span<const Vec3> x = tissue.position;
  constexpr double kEdge = 1e-9;               // [1] weight below which a point counts as outside
  const Vec3 target = pointAt(m, x, hole.tet, hole.weight) + step;
  int tet = hole.tet;
  for (int n = 0; n < kMaxTetsPerStep; ++n) {
    const auto w = weightsAt(m, x, tet, target);
    const int out = mostNegative(w);
    if (w[out] >= -kEdge) {
      hole.tet = tet;
      hole.weight = w;
      return CutResult::kMoved;
    }
    const int next = m.surface.tetNeighbour[tet][out];
    if (next < 0 || (!tissue.gone.empty() && tissue.gone[next])) {   // the far side is outside the wall: stop on the face
      const auto start = weightsAt(m, x, tet, target - step);
      const double share = shareInside(start, w);
      for (int c = 0; c < 4; ++c) hole.weight[c] = start[c] + share * (w[c] - start[c]);
      double sum = 0.0;                        // [1]
      for (double& c : hole.weight) { c = c < 0.0 ? 0.0 : c; sum += c; }
      for (double& c : hole.weight) c /= sum;
      hole.tet = tet;
      return CutResult::kAtSurface;
    }
    tet = next;
  }
  return CutResult::kMoved;
}

}  // namespace halsted
