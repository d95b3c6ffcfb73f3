#include "sim/contact/tissue_contact.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/geometry.h"

namespace halsted {
namespace {

constexpr int kRefreshInterval = 8;            // steps between searches for pairs
constexpr double kCell = 4e-3;                 // [m] about one edge of the mesh
constexpr double kPairReach = 1.2e-3;          // [m] pairs closer than this are watched until the next search
constexpr double kThickness = 0.1e-3;          // [m] gap kept between two surfaces
constexpr double kBehind = 1.0e-3;             // [m] half a wall: deeper, the vertex belongs to the other side
constexpr double kMostForce = 10.0;            // [N] of one pair: next to held particles the compliance says too little
constexpr double kShare = 8.0;                 // [1] neighbours pushed at the same time; over-estimates the compliance

int cellHash(const Vec3& p) {
  const auto index = [](double v) { return static_cast<std::int64_t>(std::floor(v / kCell)); };
  const std::uint64_t h = static_cast<std::uint64_t>(index(p.x()) * 73856093 ^ index(p.y()) * 19349663 ^ index(p.z()) * 83492791);
  return static_cast<int>(h % SelfWork::kCells);
}

/// Counting sort of triangle centroids into hashed cells: index order within a cell.
void fillGrid(const Model& m, State& s) {
  SelfWork& w = s.work.self;
  std::fill(w.start.begin(), w.start.end(), 0);
  const int n = static_cast<int>(m.surface.triangles.size());
  for (int f = 0; f < n; ++f) {
    const auto& v = m.surface.triangles[f];
    w.cellOf[f] = cellHash((s.tissue.position[v[0]] + s.tissue.position[v[1]] + s.tissue.position[v[2]]) / 3.0);
    ++w.start[w.cellOf[f] + 1];
  }
  for (int c = 0; c < SelfWork::kCells; ++c) w.start[c + 1] += w.start[c];
  for (int f = n - 1; f >= 0; --f) w.item[--w.start[w.cellOf[f] + 1]] = f;
  // start[c + 1] now points at the first item of cell c; shift back so that start[c] does.
  for (int c = 0; c < SelfWork::kCells; ++c) w.start[c] = w.start[c + 1];
  w.start[SelfWork::kCells] = n;
}

/// Vertex and triangle are neighbours on the surface: elasticity keeps them apart, not contact.
bool related(const Model& m, int vertex, int triangle) {
  for (int v : m.surface.triangles[triangle]) {
    if (v == vertex) return true;
    for (int e = m.surface.neighbourStart[v]; e < m.surface.neighbourStart[v + 1]; ++e)
      if (m.surface.neighbour[e] == vertex) return true;
  }
  return false;
}

struct Gap {
  bool near = false;
  double height = 0.0;                         // [m] of the vertex over the triangle
  std::array<double, 3> weight{};              // [1]
  Vec3 normal = Vec3::UnitZ();                 // [1]
};

Gap gapOf(const Model& m, std::span<const Vec3> x, int vertex, int triangle) {
  Gap g;
  const auto& v = m.surface.triangles[triangle];
  const Vec3 &a = x[v[0]], &b = x[v[1]], &c = x[v[2]];
  g.weight = closestOnTriangle(x[vertex], a, b, c);
  g.normal = (b - a).cross(c - a).normalized();
  const Vec3 away = x[vertex] - mix(g.weight, a, b, c);
  g.height = away.dot(g.normal);
  const double aside = (away - g.height * g.normal).squaredNorm();   // [m^2]
  g.near = g.height > -kBehind && g.height < kPairReach && aside < 0.25e-6;
  return g;
}

/// Cheap rejection before the closest point: the vertex is farther from the triangle's plane than any pair.
bool farFromPlane(const Model& m, std::span<const Vec3> x, int vertex, int triangle) {
  const auto& v = m.surface.triangles[triangle];
  const Vec3 normal = (x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]);
  const double height = normal.dot(x[vertex] - x[v[0]]);              // [m^3] times the normal's length
  return height * height > kPairReach * kPairReach * normal.squaredNorm() * 1.0001;
}

/// Force of the last step if this pair was watched then. Pairs stand in the order of their vertices.
double carried(const SelfWork& w, int count, int vertex, int triangle) {
  const auto first = w.vertex.begin();
  for (auto at = std::lower_bound(first, first + count, vertex); at != first + count && *at == vertex; ++at)
    if (w.triangle[at - first] == triangle) return w.force[at - first];
  return 0.0;
}

void addPair(State& s, int old, int vertex, int triangle) {
  TissueState& t = s.tissue;
  if (t.pairCount >= TissueState::kMaxPairs) { ++t.droppedPairs; return; }
  t.pairVertex[t.pairCount] = vertex;
  t.pairTriangle[t.pairCount] = triangle;
  t.pairForce[t.pairCount++] = carried(s.work.self, old, vertex, triangle);
}

void addPairsOfCell(const Model& m, State& s, int old, int vertex, int cell) {
  const SelfWork& w = s.work.self;
  for (int e = w.start[cell]; e < w.start[cell + 1]; ++e) {
    const int f = w.item[e];
    const Vec3& corner = s.tissue.position[m.surface.triangles[f][0]];
    if ((corner - s.tissue.position[vertex]).squaredNorm() > 49e-6 || farFromPlane(m, s.tissue.position, vertex, f)) continue;
    if (gapOf(m, s.tissue.position, vertex, f).near && !related(m, vertex, f)) addPair(s, old, vertex, f);
  }
}

void findPairs(const Model& m, State& s) {
  TissueState& t = s.tissue;
  SelfWork& w = s.work.self;
  w.vertex = t.pairVertex;
  w.triangle = t.pairTriangle;
  w.force = t.pairForce;
  const int old = t.pairCount;
  t.pairCount = 0;
  fillGrid(m, s);
  for (int vertex : m.surface.vertices) {
    const Vec3& p = t.position[vertex];
    int cells[27], count = 0;
    for (int k = 0; k < 27; ++k) cells[count++] = cellHash(p + kCell * Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
    std::sort(cells, cells + count);
    count = static_cast<int>(std::unique(cells, cells + count) - cells);
    for (int k = 0; k < count; ++k) addPairsOfCell(m, s, old, vertex, cells[k]);
  }
  for (int i = t.pairCount; i < TissueState::kMaxPairs; ++i) { t.pairVertex[i] = t.pairTriangle[i] = -1; t.pairForce[i] = 0.0; }
}

void applyPair(const Model& m, const Gap& g, int vertex, int triangle, double force, std::vector<Vec3>& nodal) {
  nodal[vertex] += force * g.normal;
  const auto& v = m.surface.triangles[triangle];
  for (int k = 0; k < 3; ++k) nodal[v[k]] -= g.weight[k] * force * g.normal;
}

void solvePairs(const Model& m, State& s) {
  TissueState& t = s.tissue;
  const ProjectiveModel& p = m.tissue.projective;
  for (int i = 0; i < t.pairCount; ++i) {
    const Gap g = gapOf(m, t.position, t.pairVertex[i], t.pairTriangle[i]);
    const int corner = m.surface.triangles[t.pairTriangle[i]][0];
    const double give = kShare * (compliance(p, t.pairVertex[i], t.pairVertex[i]) + compliance(p, corner, corner)) + 1e-6;   // [m/N]
    const double before = t.pairForce[i];
    t.pairForce[i] = g.near ? std::fmin(kMostForce, std::fmax(0.0, before + (kThickness - g.height) / give)) : 0.0;
    applyPair(m, g, t.pairVertex[i], t.pairTriangle[i], t.pairForce[i] - before, s.work.change);
  }
}

void solveRod(const Model& m, State& s) {
  TissueState& t = s.tissue;
  const RodParams& rod = m.params.anvil;
  for (int v : m.surface.vertices) {
    const Vec3 axis = rod.from + closestOnSegment(t.position[v], rod.from, rod.to) * (rod.to - rod.from);
    const Vec3 away = t.position[v] - axis;
    const double distance = away.norm();
    const Vec3 old = t.rodForce[v];
    Vec3 fresh = Vec3::Zero();
    if (distance > 1e-9 && (distance < rod.radius + kPairReach || old.squaredNorm() > 0.0)) {
      const Vec3 n = away / distance;
      const double give = kShare * compliance(m.tissue.projective, v, v) + 1e-6;   // [m/N]
      const double pushed = std::fmax(0.0, old.dot(n) + (rod.radius - distance) / give);
      const Vec3 moved = t.position[v] - s.work.tissue.previous[v], slide = moved - moved.dot(n) * n;
      Vec3 grip = old - old.dot(n) * n - slide / give;
      const double limit = m.params.contact.toolTissueFriction * pushed, size = grip.norm();
      if (size > limit) grip *= size > 0.0 ? limit / size : 0.0;
      fresh = pushed * n + grip;
    }
    t.rodForce[v] = fresh;
    s.work.change[v] += fresh - old;
  }
}

}  // namespace

void solveTissueContact(const Model& m, State& s) {
  // Pairs found anew keep their force only if they were watched before; what was carried for the others is taken back here.
  if (s.step % kRefreshInterval == 0) {
    for (int i = 0; i < s.tissue.pairCount; ++i) {
      const Gap g = gapOf(m, s.work.tissue.previous, s.tissue.pairVertex[i], s.tissue.pairTriangle[i]);
      applyPair(m, g, s.tissue.pairVertex[i], s.tissue.pairTriangle[i], -s.tissue.pairForce[i], s.work.change);
    }
    findPairs(m, s);
    for (int i = 0; i < s.tissue.pairCount; ++i) {
      const Gap g = gapOf(m, s.work.tissue.previous, s.tissue.pairVertex[i], s.tissue.pairTriangle[i]);
      applyPair(m, g, s.tissue.pairVertex[i], s.tissue.pairTriangle[i], s.tissue.pairForce[i], s.work.change);
    }
  }
  solvePairs(m, s);
  solveRod(m, s);
}

void gatherTissueContact(const Model& m, const State& s, std::vector<Vec3>& nodal) {
  const TissueState& t = s.tissue;
  for (std::size_t i = 0; i < t.rodForce.size(); ++i) nodal[i] += t.rodForce[i];
  for (int i = 0; i < t.pairCount; ++i) {
    const Gap g = gapOf(m, t.position, t.pairVertex[i], t.pairTriangle[i]);
    applyPair(m, g, t.pairVertex[i], t.pairTriangle[i], t.pairForce[i], nodal);
  }
}

}  // namespace halsted
