#include "tests/app/abuse_watch.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "sim/contact/geometry.h"
#include "sim/contact/surface.h"
#include "sim/fields.h"
#include "sim/suture/strand_sample.h"
#include "sim/tools/tool_shape.h"

namespace halsted::app {
namespace {

constexpr double kAbout = 5e-3;                // [m] of thread: the hole leads it, jaws pinch it
constexpr double kReach = 8e-3;                // [m]

struct NumberCheck {
  bool good = true;
  void size(const FieldPath&, std::size_t) {}
  template <class T> void leaf(const FieldPath&, const T* data, std::size_t count, int) {
    if constexpr (std::is_same_v<std::remove_const_t<T>, double>)
      for (std::size_t i = 0; i < count; ++i) good = good && std::isfinite(data[i]);
  }
};

/// On its way through the wall, from the first hole of a bite to its last, or led by a hole.
bool ledByHole(const StrandState& s, double coordinate) {        // [m]
  for (int i = 0; i < s.holeCount; ++i) {
    const Hole& h = s.holes[i];
    if (std::fabs(h.coordinate - coordinate) < kAbout) return true;
    const bool tipInside = h.role == static_cast<int>(HoleRole::kEntry) && (i + 1 == s.holeCount || s.holes[i + 1].bite != h.bite);
    if (tipInside && coordinate > h.coordinate) return true;
    if (i + 1 < s.holeCount && s.holes[i + 1].bite == h.bite && coordinate > h.coordinate && coordinate < s.holes[i + 1].coordinate) return true;
  }
  return false;
}

/// In the wall of this bowel: beside the face of one a point may lie deep in the wall of another that overlaps it.
double depthInWall(const Model& m, const State& s, int bowel, const Vec3& p) {   // [m], negative outside
  const SurfaceNow now{s.tissue.position, s.tissue.gone};
  int near = m.bowels.rim[bowel].front();
  const double distance = nearestTriangle(m.surface, now, p, near, m.bowels.of).distance;   // [m]
  return std::fabs(distance) < kReach ? -distance : -kReach;     // no wall is so thick: which side of its nearest corner it lies on says nothing
}

double depthInTissue(const Model& m, const State& s, const Vec3& p) {   // [m], negative outside
  double deepest = -kReach;                    // [m]
  for (int bowel = 0; bowel < m.bowels.count; ++bowel) deepest = std::fmax(deepest, depthInWall(m, s, bowel, p));
  return deepest;
}

/// In those that have gone through a wall (`passed`), which meet no thread until they are out (sim/tools/perforation.h), or in all others.
double depthInTools(const Model& m, const State& s, const Vec3& p, double coordinate, bool passed) {   // [m]
  const auto solids = worldSolids(m, s);
  double deepest = -kReach;                    // [m]
  for (int k = 0; k < kSolids; ++k) {
    const int hand = solidHand(k);
    if (hand >= 0 && std::fabs(s.tools[hand].threadCoordinate - coordinate) < kAbout) continue;
    if (hand >= 0 && s.tools[hand].holdsNeedle) continue;        // such jaws do not collide with thread (README)
    if ((hand >= 0 && s.tools[hand].through) != passed) continue;
    const CapsuleShape& c = solids[k];
    deepest = std::fmax(deepest, c.radius - (p - c.a - closestOnSegment(p, c.a, c.b) * (c.b - c.a)).norm());
  }
  return deepest;
}

/// A face of the tissue that a segment goes through.
struct Crossing {
  double share = 0.0;                          // [1] of the segment
  int face = -1;
};

/// Those of one bowel, in the order in which the segment goes through them.
std::vector<Crossing> crossings(const Model& m, const State& s, int bowel, const Vec3& a, const Vec3& b) {   // [m]
  const Vec3 way = b - a;
  std::vector<Crossing> all;
  for (std::size_t f = 0; f < m.surface.triangles.size(); ++f) {
    const auto& v = m.surface.triangles[f];
    if (m.bowels.of[v[0]] != bowel) continue;
    const Vec3& p = s.tissue.position[v[0]];
    if ((p - a).squaredNorm() > kReach * kReach || !exposed(m.surface, s.tissue.gone, static_cast<int>(f))) continue;
    const Vec3 e1 = s.tissue.position[v[1]] - p, e2 = s.tissue.position[v[2]] - p, h = way.cross(e2);   // Moeller and Trumbore 1997
    const double det = e1.dot(h);
    if (det == 0.0) continue;
    const Vec3 q = (a - p).cross(e1);
    const double u = (a - p).dot(h) / det, w = way.dot(q) / det, t = e2.dot(q) / det;   // [1]
    if (u >= 0.0 && w >= 0.0 && u + w <= 1.0 && t >= 0.0 && t < 1.0) all.push_back({t, static_cast<int>(f)});
  }
  std::sort(all.begin(), all.end(), [](const Crossing& x, const Crossing& y) { return x.share < y.share; });
  return all;
}

/// In by one side of a bowel's wall and out by the other side of the same one, no hole on the way, and deep in between: cut off at a corner is not through.
int timesThrough(const Model& m, const State& s, int bowel) {
  int times = 0, in = -1;                      // the face by which it went in
  double deepest = 0.0;                        // [m] since
  const auto goOn = [&](const Vec3& from, const Vec3& to) {   // [m]
    if (in >= 0) deepest = std::max({deepest, depthInWall(m, s, bowel, from), depthInWall(m, s, bowel, 0.5 * (from + to))});
  };
  for (int i = 0; i + 1 < static_cast<int>(s.strand.position.size()); ++i) {
    const Vec3 &a = s.strand.position[i], &b = s.strand.position[i + 1];
    const bool parted = !s.threadContacts.cut.empty() && s.threadContacts.cut[i] != 0;   // broken thread: no segment leads from one piece to the other
    if (parted || ledByHole(s.strand, m.strand.place[i]) || ledByHole(s.strand, m.strand.place[i + 1])) { in = -1; continue; }
    Vec3 from = a;                             // [m]
    for (const Crossing& c : crossings(m, s, bowel, a, b)) {
      const Vec3 at = a + c.share * (b - a);   // [m]
      goOn(from, at);
      times += in >= 0 && oppositeFaces(m, in, c.face) && deepest > kDeep;
      in = in < 0 ? c.face : -1;
      deepest = 0.0;
      from = at;
    }
    goOn(from, b);
  }
  return times;
}

}  // namespace

bool finite(const State& s) {
  NumberCheck check;
  visitFields(const_cast<State&>(s), check);   // the check only reads
  return check.good;
}

ThreadDepth threadDepth(const Model& m, const State& s) {
  ThreadDepth d;
  for (int i = 0; i < static_cast<int>(s.strand.position.size()); ++i) {
    const double coordinate = m.strand.place[i];                 // [m]
    if (ledByHole(s.strand, coordinate)) continue;
    const Vec3& p = s.strand.position[i];
    const double tissue = depthInTissue(m, s, p), inPassed = depthInTools(m, s, p, coordinate, true);   // [m]
    const double tool = std::fmax(inPassed, depthInTools(m, s, p, coordinate, false));   // [m]
    d.tissue = std::fmax(d.tissue, tissue);
    d.tool = std::fmax(d.tool, tool);
    d.inTissue += tissue > kDeep;
    d.inTool += tool > kDeep;
    d.inPassed += inPassed > kDeep;
    ++d.nodes;
  }
  for (int bowel = 0; bowel < m.bowels.count; ++bowel) d.through += timesThrough(m, s, bowel);
  return d;
}

}  // namespace halsted::app
