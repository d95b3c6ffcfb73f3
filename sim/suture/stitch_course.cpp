#include "sim/suture/stitch_course.h"

#include <algorithm>

#include "sim/model.h"
#include "sim/state.h"
#include "sim/strand/strand.h"
#include "sim/suture/tied_loop.h"

namespace halsted {
namespace {

static_assert(kStitchPoints == 2 * TiedStitch::kLeg + TiedStitch::kMostHoles, "a leg, the holes, a leg");

constexpr double kTrimmed = 4e-3;              // [m] of tail beyond the knot: what an assistant leaves of braided thread
constexpr double kReach = 0.1;                 // [m]

OverSurface overSurface(const Model& m, const SurfaceNow& x, const Vec3& p) {   // [m]
  int vertex = nearestVertex(m.surface, x, p);
  const SurfacePoint near = nearestSurface(m.surface, x, p, kReach, vertex);
  if (near.triangle < 0) return {};
  return {near.triangle, near.weight, std::clamp(near.distance, 0.0, kTrimmed)};   // thread that has sunk into the wall is seen on it
}

Vec3 placeOver(const Model& m, const OverSurface& o, std::span<const Vec3> x) {   // [m]
  const auto& v = m.surface.triangles[o.triangle];
  const Vec3 normal = (x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]).normalized();
  return pointOn(m.surface, x, o.triangle, o.weight) + o.height * normal;
}

using Leg = std::array<OverSurface, TiedStitch::kLeg>;

/// From the trimmed end over the knot to near the hole. `way` leads from the hole to the end.  [m] [1]
Leg legOf(const Model& m, const State& s, double knot, double hole, double way) {
  const double step = kTrimmed / 2.0, toHole = hole - knot;      // [m]
  const double place[TiedStitch::kLeg] = {knot + 2.0 * way * step, knot + way * step, knot, knot + toHole / 3.0, knot + 2.0 * toHole / 3.0};
  Leg leg;
  for (int i = 0; i < TiedStitch::kLeg; ++i)
    leg[i] = overSurface(m, {s.tissue.position, s.tissue.gone}, strandPoint(m.strand, s.strand, std::clamp(place[i], 0.0, m.strand.length)));
  return leg;
}

/// From the serosa toward the mucosa, about a hole.  [1]
Vec3 inwardAt(const Model& m, const TissuePoint& h, std::span<const Vec3> x) {   // [m]
  const auto& v = m.tissue.tets[h.tet];
  const Vec3 centre = 0.25 * (x[v[0]] + x[v[1]] + x[v[2]] + x[v[3]]);
  const auto depth = [&](int c) { return m.bowels.wallDepth[v[c]]; };   // [1]
  const double mean = 0.25 * (depth(0) + depth(1) + depth(2) + depth(3));
  Vec3 way = Vec3::Zero();                     // [m]
  for (int c = 0; c < 4; ++c) way += (depth(c) - mean) * (x[v[c]] - centre);
  const double size = way.norm();              // [m]
  return size > 1e-9 ? Vec3(way / size) : Vec3::Zero();
}

constexpr int kTwoBites = 4;                   // holes
constexpr double kSunk = 1.2e-3;               // [m] about as deep as the needle went; only the holes are remembered

/// Hole, two places within the wall, hole: twice.
Vec3 twoBitesAt(const Model& m, const TiedStitch& stitch, std::span<const Vec3> x, int slot) {   // [m]
  const TissuePoint &in = stitch.hole[slot < 4 ? 0 : 2], &out = stitch.hole[slot < 4 ? 1 : 3];
  const double share = (slot % 4) / 3.0;       // [1]
  const Vec3 straight = (1.0 - share) * pointOf(m, in, x) + share * pointOf(m, out, x);
  const bool within = slot % 4 == 1 || slot % 4 == 2;
  return within ? Vec3(straight + kSunk * ((1.0 - share) * inwardAt(m, in, x) + share * inwardAt(m, out, x))) : straight;
}

}  // namespace

void keepCourse(const Model& m, const State& s, const TiedLoop& loop, TiedStitch& stitch) {
  stitch.tailLeg = legOf(m, s, loop.tail, s.strand.holes[0].coordinate, -1.0);
  stitch.tipLeg = legOf(m, s, loop.tip, s.strand.holes[s.strand.holeCount - 1].coordinate, 1.0);
}

void courseOf(const Model& m, const TiedStitch& stitch, std::span<const Vec3> x, std::span<Vec3, kStitchPoints> course) {
  constexpr int kLast = kStitchPoints - 1;
  const auto holeAt = [&](int i) { return pointOf(m, stitch.hole[std::min(i, stitch.holeCount - 1)], x); };
  for (int i = 0; i < TiedStitch::kMostHoles; ++i) course[TiedStitch::kLeg + i] = stitch.holeCount == kTwoBites ? twoBitesAt(m, stitch, x, i) : holeAt(i);
  for (int i = 0; i < TiedStitch::kLeg; ++i) {
    course[i] = stitch.tailLeg[i].triangle >= 0 ? placeOver(m, stitch.tailLeg[i], x) : holeAt(0);
    course[kLast - i] = stitch.tipLeg[i].triangle >= 0 ? placeOver(m, stitch.tipLeg[i], x) : holeAt(TiedStitch::kMostHoles);
  }
}

}  // namespace halsted
