#include "sim/join.h"

#include <cmath>

#include "sim/contact/geometry.h"
#include "sim/cutting/edge.h"
#include "sim/join_stretch.h"
#include "sim/model.h"
#include "sim/state.h"
#include "sim/suture/holes.h"
#include "sim/suture/knotting.h"

namespace halsted {
namespace {

constexpr double kColumnDepth = 12e-3;         // [m] of wall behind the edge that a stitch turns in
constexpr double kBaseDepth = 10e-3, kDeepDepth = 17e-3;   // [m] behind the edge: past the stitches the wall keeps its direction
constexpr double kReach = 60e-3;               // [m] walls farther apart are not being joined

/// Vertex of the bowel's outer (0) or inner (1) wall nearest to a direction and depth behind the rim.
int wallVertexAt(const TetMesh& mesh, const Bowels& b, int like, double depth, double layer) {   // [m], [1]
  int best = like;
  double least = 1e300;                        // [m^2]
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (b.of[v] != b.of[like] || b.wallDepth[v] != layer) continue;
    const double turn = (mesh.uv[v].x() - mesh.uv[like].x()) * 0.1;          // [m] a tenth of a metre round: columns before rows
    const double down = mesh.uv[v].y() - depth;
    if (turn * turn + down * down < least) { least = turn * turn + down * down; best = static_cast<int>(v); }
  }
  return best;
}

int nearestOfOther(const TetMesh& mesh, const Bowels& b, int to) {
  int best = to;
  double least = 1e300;                        // [m^2]
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (b.of[v] == b.of[to] || b.wallDepth[v] != 0.0) continue;
    const double d2 = (mesh.vertices[v] - mesh.vertices[to]).squaredNorm();
    if (d2 < least) { least = d2; best = static_cast<int>(v); }
  }
  return best;
}

EdgeColumn columnBehind(const TetMesh& mesh, const Bowels& b, int rim) {
  EdgeColumn c;
  for (int i = 0; i < EdgeColumn::kMost; ++i) {
    const int v = wallVertexAt(mesh, b, rim, kColumnDepth * i / EdgeColumn::kMost, 0.0);
    if (c.count > 0 && c.vertex[c.count - 1] == v) continue;
    c.vertex[c.count] = v;
    c.facing[c.count++] = nearestOfOther(mesh, b, v);
  }
  c.base = wallVertexAt(mesh, b, rim, kBaseDepth, 0.0);
  c.deep = wallVertexAt(mesh, b, rim, kDeepDepth, 0.0);
  c.lumen = wallVertexAt(mesh, b, rim, 0.0, 1.0);
  c.inner = wallVertexAt(mesh, b, rim, kBaseDepth, 1.0);
  return c;
}

/// The shorter way round from the first sewn column to the last.
SewnStretch stretchBetween(int from, int to, int around) {
  const int up = (to - from + around) % around, down = (from - to + around) % around;
  return up <= down ? SewnStretch{from, up + 1} : SewnStretch{to, down + 1};
}

double edgeDistance(const Model& m, const State& s, int bowel, int column) {   // [m]
  const auto& x = s.tissue.position;
  const Vec3& p = x[edgeOf(m, s, bowel)[column]];
  const std::span<const int> other = edgeOf(m, s, 1 - bowel);
  double least = 1e300;                        // [m]
  for (std::size_t i = 0; i < other.size(); ++i) {
    const Vec3 &a = x[other[i]], &b = x[other[(i + 1) % other.size()]];
    least = std::fmin(least, (p - a - closestOnSegment(p, a, b) * (b - a)).norm());
  }
  return least;
}

/// Where the search for the other bowel's surface starts: not at what has been cut away.
int startOpposite(const Model& m, const State& s, const EdgeColumn& c, int i) {
  const int near = c.facing[i], other = m.bowels.of[near];
  return !s.cut || s.cut->bare[near] ? near : edgeOf(m, s, other)[columnNear(m, other, m.mesh.vertices[near])];
}

/// From what the cut has left of a column.  [m]
double wallDistance(const Model& m, const State& s, const EdgeColumn& c, int edge) {
  const SurfaceNow now{s.tissue.position, s.tissue.gone};
  double least = kReach;
  for (int i = 0; i < c.count; ++i) {
    if (m.mesh.uv[c.vertex[i]].y() < m.mesh.uv[edge].y()) continue;
    int near = startOpposite(m, s, c, i);
    const SurfacePoint p = nearestSurface(m.surface, now, now.position[c.vertex[i]], kReach, near);
    if (p.triangle >= 0) least = std::fmin(least, std::fmax(0.0, p.distance));
  }
  return least;
}

/// Sine of the edge's turn toward the lumen against the wall behind it.  [1]
double turnIn(std::span<const Vec3> x, const EdgeColumn& c, int edgeVertex) {
  const Vec3 edge = (x[edgeVertex] - x[c.base]).normalized(), wall = (x[c.base] - x[c.deep]).normalized();
  const Vec3 thick = x[c.inner] - x[c.base];
  const Vec3 inward = (thick - thick.dot(wall) * wall).normalized();
  return edge.dot(inward);
}

/// Sewn columns of one bowel: every hole of the thread in it counts.
SewnStretch sewnOn(const Model& m, const StrandState& s, int bowel) {
  const int around = static_cast<int>(m.bowels.rim[bowel].size());
  int first = -1, last = -1;
  for (int i = 0; i < s.holeCount; ++i) {
    if (bowelOf(m, s.holes[i]) != bowel) continue;
    const int column = columnNear(m, bowel, holePoint(m, s.holes[i], m.mesh.vertices));
    if (first < 0) first = column;
    last = column;
  }
  return first < 0 ? SewnStretch{} : stretchBetween(first, last, around);
}

}  // namespace

int columnNear(const Model& m, int bowel, const Vec3& rest) {
  const auto& rim = m.bowels.rim[bowel];
  int best = 0;
  double least = 1e300;                        // [m^2]
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double d2 = (m.mesh.vertices[rim[i]] - rest).squaredNorm();
    if (d2 < least) { least = d2; best = static_cast<int>(i); }
  }
  return best;
}

void measureStretch(const Model& m, const State& s, int bowel, const SewnStretch& sewn, JoinMetrics& join) {
  const std::span<const int> edge = edgeOf(m, s, bowel);
  const auto& columns = m.join.columns[bowel];
  const int around = static_cast<int>(columns.size());
  for (int i = 0; i < sewn.count; ++i) {
    const int column = (sewn.first + i) % around;
    join.rimGap = std::fmax(join.rimGap, edgeDistance(m, s, bowel, column));
    join.wallGap = std::fmax(join.wallGap, wallDistance(m, s, columns[column], edge[column]));
    join.inversion += turnIn(s.tissue.position, columns[column], edge[column]) - turnIn(m.mesh.vertices, columns[column], edge[column]);
  }
}

int bowelOf(const Model& m, const Hole& h) { return m.bowels.of[m.tissue.tets[h.tet][0]]; }

JoinModel buildJoin(const TetMesh& mesh, const Bowels& b, const SurfaceModel& surface) {
  JoinModel join;
  if (b.count != 2 || b.rim[0].empty() || b.rim[1].empty()) return join;
  join.restGap = kReach;
  for (int bowel = 0; bowel < 2; ++bowel) {
    for (int rim : b.rim[bowel]) {
      const EdgeColumn c = columnBehind(mesh, b, rim);
      join.columns[bowel].push_back(c);
      for (int i = 0; i < c.count; ++i) {
        int near = c.facing[i];
        const SurfacePoint p = nearestSurface(surface, mesh.vertices, mesh.vertices[c.vertex[i]], kReach, near);
        if (p.triangle >= 0) join.restGap = std::fmin(join.restGap, p.distance);
      }
    }
  }
  return join;
}

JoinMetrics measureJoin(const Model& m, const State& s) {
  JoinMetrics join;
  if (!m.join.present()) return join;
  const StrandState& strand = s.strand;
  for (int i = 0; i + 1 < strand.holeCount; ++i)
    join.crossings += bowelOf(m, strand.holes[i]) != bowelOf(m, strand.holes[i + 1]);
  if (strand.holeCount > 0) {
    const double last = strand.holes[strand.holeCount - 1].coordinate;       // [m]
    join.tailDifference = std::fabs(strand.holes[0].coordinate - (threadEnd(m, s, last) - last));
  }
  if (join.crossings == 0) { join.rimGap = join.wallGap = m.join.restGap; return join; }
  const std::array<SewnStretch, 2> sewn{sewnOn(m, strand, 0), sewnOn(m, strand, 1)};
  for (int bowel = 0; bowel < 2; ++bowel) measureStretch(m, s, bowel, sewn[bowel], join);
  const int columns = sewn[0].count + sewn[1].count;
  join.inversion /= columns;
  join.sewnShare = static_cast<double>(columns) / static_cast<double>(m.join.columns[0].size() + m.join.columns[1].size());
  return join;
}

}  // namespace halsted
