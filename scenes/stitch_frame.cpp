#include "scenes/stitch_frame.h"

#include "sim/suture/hole_sides.h"
#include "sim/suture/holes.h"

namespace halsted::scenes {
namespace {

/// Square to the wall, out of it on its mucosa's side.  [1]
Vec3 outOfMucosa(const Model& m, const Hole& h) {
  const auto& v = m.tissue.tets[h.tet];
  const std::span<const Vec3> x = m.mesh.vertices;
  Mat3 edges;
  Vec3 depth;                                  // [1]
  for (int c = 0; c < 3; ++c) {
    edges.row(c) = x[v[c + 1]] - x[v[0]];
    depth[c] = m.bowels.wallDepth[v[c + 1]] - m.bowels.wallDepth[v[0]];
  }
  return Vec3(edges.inverse() * depth).normalized();             // up the gradient from the serosa to the mucosa
}

/// Away from both walls: out of the tissue at a hole, and out of that end's opening.  [1]
Vec3 clearOf(const Scene& s, const Hole& h) {
  const Opening& o = s.model.bowels.opening[bowelOf(s.model, h)];
  if (onMucosa(s.model, h)) return outOfMucosa(s.model, h) + o.axis;
  const Vec3 from = holePoint(s.model, h, s.model.mesh.vertices) - o.centre;   // [m]
  return (from - from.dot(o.axis) * o.axis).normalized() + o.axis;
}

}  // namespace

StitchFrame stitchFrame(const Scene& s) {
  const StrandState& strand = s.state.strand;
  const auto& x = s.state.tissue.position;
  const Hole &first = strand.holes[0], &last = strand.holes[strand.holeCount - 1];
  const Vec3 tail = holePoint(s.model, first, x), tip = holePoint(s.model, last, x);
  StitchFrame f;
  f.middle = 0.5 * (tail + tip);
  f.up = s.model.join.present() ? Vec3((clearOf(s, first) + clearOf(s, last)).normalized()) : Vec3(Vec3::UnitZ());
  f.side = tip - tail;
  f.side -= f.side.dot(f.up) * f.up;
  f.side = f.side.norm() > 1e-4 ? Vec3(f.side.normalized()) : Vec3(Vec3::UnitX());
  f.front = f.side.cross(f.up);
  return f;
}

}  // namespace halsted::scenes
