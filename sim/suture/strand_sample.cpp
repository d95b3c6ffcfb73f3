#include "sim/suture/strand_sample.h"

#include <algorithm>

#include "sim/contact/vertex_boxes.h"
#include "sim/suture/edge_exit.h"
#include "sim/suture/hole_sides.h"
#include "sim/suture/holes.h"

namespace halsted {
namespace {

constexpr double kReach = 8e-3;                // [m] samples farther than this from every vertex are not examined
constexpr int kRepairInterval = 32;            // steps between exhaustive searches of one sample
constexpr int kPiecesInterval = 6;             // the same where walls that a cut has parted lie so near to each other that no walk leads over in time
constexpr double kSearchedWay = 1e-3;          // [m] that a sample may go between two such searches
constexpr double kOnTissue = 1e-3;             // [m]
constexpr double kFlight = 0.2e-3, kFlightOverCut = 0.5e-3;      // [m] in a step; slower thread leaves cut walls across itself

/// Steps between exhaustive searches. From one bowel no walk leads to the other: thread that flies across looks for it as often as it may get there.
int searchInterval(const Model& m, const State& s, const StrandSample& x) {
  const int interval = s.cut ? kPiecesInterval : kRepairInterval;
  const double way = (x.predicted - x.position).norm();          // [m] in this step
  if (m.bowels.count < 2 || way * interval <= kSearchedWay) return interval;
  return std::max(1, static_cast<int>(kSearchedWay / way));
}

/// Thread that flies into a wall in this step, by more than `flight`, is stopped by the face that it meets, end on, too, and beside an edge: out of the nearest
/// one, or across itself, it was thrown on through the wall (in `altemeier`, as a needle was let go that drew with 2.5 N, with 24 N in the thread, which broke;
/// flung over the edge of an end it was pushed on by the next face, `FlyingThread`). Else triangle -1.
SurfacePoint faceMet(const Model& m, const SurfaceNow& tissue, const StrandSample& x, int vertex, double flight) {   // [m]
  const Vec3 way = x.predicted - x.position;   // [m]
  if (way.squaredNorm() < flight * flight) return {};
  SurfacePoint met = nearestSurface(m.surface, tissue, x.position, kReach, vertex);
  if (met.triangle < 0 || met.distance < -flight || met.normal.dot(way) > -flight) return {};
  met.distance = met.normal.dot(x.predicted - met.point);
  return met.distance < 0.0 ? met : SurfacePoint{};
}

/// From the vertex that is known.
SurfacePoint nearKnown(const Model& m, const SurfaceNow& tissue, const StrandSample& x, StrandState& s) {
  return nearestSurface(m.surface, tissue, x.predicted, kReach, s.nearVertex[x.index]);
}

/// The nearest vertex of all may be one of the wall's far side. Which side a sample is on tells the face that is nearest to it where it begins its step.
SurfacePoint fromItsSide(const Model& m, const SurfaceNow& tissue, const StrandSample& x, StrandState& s) {
  int vertex = s.nearVertex[x.index];
  nearestTriangle(m.surface, tissue, x.position, vertex);
  follow(m, x.index, vertex, s);
  return nearKnown(m, tissue, x, s);
}

bool pressedIn(const SurfacePoint& near) { return near.triangle >= 0 && near.distance < 0.0 && near.distance > -kSkinDepth; }

/// Thread between two walls lies on the one whose surface is nearer, not its vertex: known by that one alone it went into the other.
SurfacePoint ofNearerBowel(const Model& m, const SurfaceNow& tissue, const StrandSample& x, const SurfacePoint& near, StrandState& s) {
  int& other = s.otherVertex[x.index];
  if (other < 0 || pressedIn(near)) return near;
  const SurfacePoint there = nearestSurface(m.surface, tissue, x.predicted, kReach, other);
  if (there.triangle < 0 || there.distance >= near.distance) return near;
  if (there.distance >= -kOnTissue) {
    follow(m, x.index, other, s);
    return there;
  }
  other = -1;                                  // deep at once: known by its far side
  return fromItsSide(m, tissue, x, s);
}

/// The samples next to a hole are led by it.
bool ledByHole(const Model& m, const StrandSample& x, const State& s) { return insideWall(m, s, x.coordinate, kLedSegments * segmentAt(m.strand, x.coordinate)); }

int nearestOf(const Model& m, const SurfaceNow& tissue, const Vec3& p, int known, VertexBoxes& boxes) {   // p [m]
  if (!boxes.filled) fillBoxes(m.surface, tissue, boxes);
  return nearestVertex(m.surface, tissue, boxes, p, known);
}

}  // namespace

void follow(const Model& m, int sample, int vertex, StrandState& s) {
  const std::vector<int>& bowel = m.bowels.of;
  std::int32_t& near = s.nearVertex[sample];
  if (bowel[vertex] != bowel[near]) s.otherVertex[sample] = near;
  near = vertex;
}

int sampleCount(const StrandModel& m) { return m.nodes + static_cast<int>(m.sampleCoordinate.size()); }

StrandSample sampleAt(const Model& m, const StrandState& s, int index) {
  StrandSample x;
  x.index = index;
  const bool thread = x.thread = index < m.strand.nodes;
  x.coordinate = thread ? m.strand.place[index] : m.strand.sampleCoordinate[index - m.strand.nodes];
  x.radius = thread ? m.strand.radius : m.strand.needle.wireRadius;
  x.isTip = index + 1 == sampleCount(m.strand);
  if (x.isTip) x.radius = 0.0;
  x.position = thread ? s.position[index] : strandPoint(m.strand, s, x.coordinate + 1e-12);
  x.predicted = x.position + m.params.dt * (thread ? s.velocity[index] : strandVelocity(m.strand, s, x.coordinate + 1e-12));
  return x;
}

StrandSample sampleBetween(const Model& m, const StrandState& s, int node) {
  StrandSample x;
  x.index = sampleCount(m.strand) + node;
  x.coordinate = 0.5 * (m.strand.place[node - 1] + m.strand.place[node]);
  x.radius = m.strand.radius;
  x.position = 0.5 * (s.position[node - 1] + s.position[node]);
  x.predicted = x.position + 0.5 * m.params.dt * (s.velocity[node - 1] + s.velocity[node]);
  return x;
}

SurfacePoint outAcross(const Model& m, const StrandSample& x, const SurfacePoint& near, const State& state) {
  if (near.triangle < 0 || near.distance < -kSkinDepth) return near;
  const SurfaceNow tissue(state.tissue.position, state.tissue.gone);
  const int node = x.index < sampleCount(m.strand) ? x.index : x.index - sampleCount(m.strand);
  int vertex = state.strand.nearVertex[node];
  if (node != x.index) nearestSurface(m.surface, tissue, x.predicted, kReach, vertex);
  return exitAcross(m.surface, tissue, {x.predicted, strandTangent(m.strand, state.strand, x.coordinate), near, vertex}, kSkinDepth);
}

SurfacePoint nearTissue(const Model& m, const StrandSample& x, State& state) {
  StrandState& s = state.strand;
  const SurfaceNow tissue(state.tissue.position, state.tissue.gone);
  if (ledByHole(m, x, state)) return {};
  SurfacePoint near = ofNearerBowel(m, tissue, x, nearKnown(m, tissue, x, s), s);
  const int interval = searchInterval(m, state, x);
  if (!pressedIn(near) && static_cast<int>(state.step % interval) == x.index % interval) {
    const bool flies = x.thread && m.bowels.count > 1;             // the side that it is on now, not the one where it would come out
    follow(m, x.index, nearestOf(m, tissue, flies ? x.position : x.predicted, s.nearVertex[x.index], state.work.boxes), s);
    near = nearKnown(m, tissue, x, s);
    if (near.distance < 0.0) near = fromItsSide(m, tissue, x, s);
    near = ofNearerBowel(m, tissue, x, near, s);
  }
  const bool cut = state.cut.has_value();
  if (!x.thread || near.distance >= 0.0 || (!cut && m.bowels.count < 2)) return near;
  const SurfacePoint met = faceMet(m, tissue, x, s.nearVertex[x.index], cut ? kFlightOverCut : kFlight);
  if (met.triangle >= 0) return met;
  return cut ? outAcross(m, x, near, state) : near;              // what a cut leaves of a wall ends in an edge hardly wider than the thread's nodes lie apart
}

SurfacePoint faceOnWay(const Model& m, const StrandSample& x, State& state) {
  constexpr double kLook = 0.4e-3;             // [m] between two looks: no wall is so thin
  const SurfaceNow tissue(state.tissue.position, state.tissue.gone);
  const Vec3 way = x.predicted - x.position;   // [m]
  if (ledByHole(m, x, state)) return {};
  int vertex = nearestOf(m, tissue, x.position, state.strand.nearVertex[x.index], state.work.boxes);
  if ((tissue.position[vertex] - x.position).norm() > kReach + way.norm()) return {};
  nearestTriangle(m.surface, tissue, x.position, vertex);
  const int looks = std::min(32, 1 + static_cast<int>(way.norm() / kLook));
  for (int k = 0; k <= looks; ++k) {
    SurfacePoint met = nearestSurface(m.surface, tissue, x.position + (static_cast<double>(k) / looks) * way, kReach, vertex);
    if (met.triangle < 0 || met.distance >= 0.0) continue;
    met.distance = met.normal.dot(x.predicted - met.point);
    return k > 0 && met.distance < 0.0 ? met : SurfacePoint{};   // at once: it lay in the tissue, which is known
  }
  return {};
}

SurfacePoint nearBetween(const Model& m, const StrandSample& x, int node, const State& state) {
  const SurfaceNow tissue(state.tissue.position, state.tissue.gone);
  const std::vector<int>& layer = m.mesh.triangleLayer;
  int vertex = state.strand.nearVertex[node];
  const SurfacePoint near = nearestSurface(m.surface, tissue, x.predicted, kReach, vertex);
  if (near.triangle < 0 || near.distance < -kSkinDepth || layer[near.triangle] == kEdgeFace) return near;
  if (near.distance >= 0.0) return {};
  return exitOverEdge(m.surface, layer, tissue, {x.predicted, strandTangent(m.strand, state.strand, x.coordinate), near, vertex}, kSkinDepth);
}

bool oppositeFaces(const Model& m, int triangle, int other) {
  const std::vector<int>& layer = m.mesh.triangleLayer;
  if (layer.size() != m.surface.triangles.size() || layer[triangle] + layer[other] != 1) return false;   // serosa 0, mucosa 1, edge 2
  return m.bowels.of[m.surface.triangles[triangle][0]] == m.bowels.of[m.surface.triangles[other][0]];
}

bool overEdge(const Model& m, const SurfacePoint& a, const SurfacePoint& b) {
  const bool bothOn = a.triangle >= 0 && b.triangle >= 0 && a.distance <= kOnTissue && b.distance <= kOnTissue;
  return bothOn && oppositeFaces(m, a.triangle, b.triangle);
}

}  // namespace halsted
