#include "sim/suture/pierced_wall.h"

#include <algorithm>
#include <cmath>

#include "sim/suture/edge_exit.h"
#include "sim/suture/strand_sample.h"

namespace halsted {
namespace {

constexpr double kThrough = 0.16;              // [1] of its length: so deep lies a segment that goes through, not over a corner

/// Does it lead from one face to the other? Not where thread lies along a wall, and a node of it is taken for one on the wall's far face.
bool leadsAcross(const Vec3& along, const SurfacePoint& before, const SurfacePoint& now) {   // [1]
  constexpr double kSteep = 0.3;               // [1] sine
  return along.dot(before.normal) < -kSteep && along.dot(now.normal) > kSteep;
}

/// Somewhere between the two it lies deep in the tissue of that wall, and no edge is near. Not only half-way: a thin wall may lie beside either. The other bowel's
/// may overlap it: asked which face is nearest of all, thread that two wild hands had driven through both was left there.
bool pierces(const Model& m, int node, const Vec3& along, int face, const State& state) {   // [1]
  constexpr double kLooks[] = {0.5, 0.25, 0.75};                // [1] of the segment
  const SurfaceNow tissue(state.tissue.position, state.tissue.gone);
  const double deep = kThrough * m.strand.rest[node - 1];        // [m]
  for (const double share : kLooks) {
    const Vec3 at = (1.0 - share) * state.strand.position[node - 1] + share * state.strand.position[node];   // [m]
    int vertex = m.surface.triangles[face][0];
    const SurfacePoint near = nearestTriangle(m.surface, tissue, at, vertex, m.bowels.of);   // on either side
    if (near.distance > -deep) continue;
    if (m.mesh.triangleLayer[near.triangle] == kEdgeFace) return false;
    return exitOverEdge(m.surface, m.mesh.triangleLayer, tissue, {at, along, near, vertex}, kSkinDepth).triangle < 0;
  }
  return false;
}

enum class Ends { kLoose, kNeedle, kHole, kHand };

/// Thread from a place to the first thing on its way: its end, the needle while nobody holds that, a hole, or jaws.
struct Way {
  double length = 0.0;                         // [m]
  Ends ends = Ends::kLoose;
};

bool isDrawn(const Way& w) { return w.ends == Ends::kHole || w.ends == Ends::kHand; }
bool letsThrough(const Way& w) { return w.ends == Ends::kLoose || w.ends == Ends::kHole; }

Way toNeedle(const Model& m, const State& s, double place) {   // [m]
  const bool held = std::any_of(s.tools.begin(), s.tools.end(), [](const ToolState& t) { return t.holdsNeedle; });
  return {m.strand.length - place, held ? Ends::kHand : Ends::kNeedle};
}

Way wayFrom(const Model& m, const State& s, double place, double direction) {   // [m]; [1] -1 toward the tail, +1 toward the needle
  Way way = direction < 0.0 ? Way{place, Ends::kLoose} : toNeedle(m, s, place);
  const auto meet = [&](double at, Ends what) {   // [m]
    const double off = direction * (at - place);
    if (off >= 0.0 && off < way.length) way = {off, what};
  };
  for (int i = 0; i < s.strand.holeCount; ++i) meet(s.strand.holes[i].coordinate, Ends::kHole);
  for (const ToolState& tool : s.tools)
    if (tool.threadCoordinate >= 0.0) meet(tool.threadCoordinate, Ends::kHand);
  for (std::size_t i = 0; i < s.threadContacts.cut.size(); ++i)
    if (s.threadContacts.cut[i] != 0) meet(m.strand.place[i], Ends::kLoose);
  return way;
}

/// Is the shorter way out that of the node before, toward the tail?
bool comesBack(const Way& back, const Way& ahead) { return letsThrough(back) && (!letsThrough(ahead) || back.length < ahead.length); }

bool isKept(const StrandState& s, int sample) { return sample < static_cast<int>(s.comesThrough.size()); }

}  // namespace

bool comesThrough(const StrandState& s, int sample) { return isKept(s, sample) && s.comesThrough[sample] != 0; }

void hasComeThrough(int sample, StrandState& s) {
  if (isKept(s, sample)) s.comesThrough[sample] = 0;
}

void drawBack(const Model& m, int node, const SurfacePoint& before, const SurfacePoint& now, State& state) {
  if (state.cut || (m.params.thread.knots && m.bowels.count < 2) || !overEdge(m, before, now)) return;
  const Vec3 along = (state.strand.position[node] - state.strand.position[node - 1]).normalized();
  if (!leadsAcross(along, before, now)) return;
  const Way back = wayFrom(m, state, m.strand.place[node - 1], -1.0), ahead = wayFrom(m, state, m.strand.place[node], 1.0);
  if (isDrawn(back) && isDrawn(ahead)) return;
  if (!letsThrough(back) && !letsThrough(ahead)) return;
  if (!pierces(m, node, along, now.triangle, state)) return;
  const int mover = comesBack(back, ahead) ? node - 1 : node, other = mover == node ? node - 1 : node;
  follow(m, mover, state.strand.nearVertex[other], state.strand);
  if (!state.strand.comesThrough.empty()) state.strand.comesThrough[mover] = 1;
}

}  // namespace halsted
