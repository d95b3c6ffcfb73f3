#pragma once
/// The wall with the thread already drawn through it: holes placed where a given path crosses its faces.
#include <algorithm>
#include <vector>

#include "tests/sim/step_rig.h"

namespace halsted {

struct ThreadedWall : StepRig {
  explicit ThreadedWall(const Pose& needle, const SimParams& p = wallParams()) : StepRig(p, needle) {}

  /// Lays the thread along a path that begins at the swage, each segment at its rest length, and opens the holes it crosses.
  void thread(const std::vector<Vec3>& path) {
    StrandState& s = state.strand;
    std::size_t leg = 0;
    Vec3 at = path.front();
    for (int i = model.strand.nodes - 1; i >= 0; --i) {
      s.position[i] = at;
      while ((path[leg + 1] - at).norm() < model.strand.segment) ++leg;
      const Vec3 a = path[leg] - at, d = path[leg + 1] - path[leg];
      // |a + u d| = segment, the larger root
      const double dd = d.squaredNorm(), ad = a.dot(d), c = a.squaredNorm() - model.strand.segment * model.strand.segment;
      const double u = (-ad + std::sqrt(ad * ad - dd * c)) / dd;               // [1]
      at = path[leg] + u * d;
    }
    openHoles();
  }
  /// Opens a hole wherever the thread, as it lies, crosses the wall's faces.
  void openHoles() {
    StrandState& s = state.strand;
    for (int i = 0; i + 1 < model.strand.nodes; ++i) openHoles(i);
    for (int h = 0; h < s.holeCount; ++h) {
      s.holes[h].bite = h / 2;
      s.holes[h].role = static_cast<std::int32_t>(h % 2 ? HoleRole::kPassed : HoleRole::kEntry);
    }
    s.bitesBegun = s.holeCount / 2;
  }

  void pull(const Vec3& by) {                  // [m] of the right hand, in one step
    input.tools[kRight].pose.position += by;
    step();
  }
  /// Between the last hole and the needle [N].
  double needleTension() const {
    const Hole& last = state.strand.holes[state.strand.holeCount - 1];
    return strandTension(model.strand, state.strand, last.coordinate + 3.0 * model.strand.segment, 1);
  }
  Vec3 holeAt(int h) const { return holePoint(model, state.strand.holes[h], state.tissue.position); }
  double apart(int a, int b) const { return (holeAt(a) - holeAt(b)).norm(); }   // [m] straight
  double inside(int a, int b) const { return state.strand.holes[b].coordinate - state.strand.holes[a].coordinate; }   // [m] of thread

 private:
  void openHoles(int node) {
    const Vec3 &a = state.strand.position[node], &b = state.strand.position[node + 1];
    std::vector<std::pair<double, double>> crossings;          // [1] along the segment, [m] face
    for (double face : {0.0, kWallX})
      if ((a.x() - face) * (b.x() - face) < 0.0) crossings.emplace_back((face - a.x()) / (b.x() - a.x()), face);
    std::sort(crossings.begin(), crossings.end());
    for (const auto& [share, face] : crossings) {
      Vec3 p = a + share * (b - a);
      p.x() = face;
      if (!(p.z() > 0.0 && p.z() < kWallZ)) continue;          // it passes above the wall
      Hole& h = state.strand.holes[state.strand.holeCount++];
      h.coordinate = coordinateAt(model.strand, node, share);
      const TissuePoint at = tissuePointAt(model, p);
      h.tet = at.tet;
      h.weight = at.weight;
    }
  }
};

}  // namespace halsted
