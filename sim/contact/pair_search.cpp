#include "sim/contact/pair_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/contact/geometry.h"

namespace halsted {
namespace {

constexpr double kCell = 4e-3;                   // [m] about one edge of the mesh
constexpr double kLevel = 1e-7;                  // [m] nearer to the triangle's own column is over the triangle
constexpr int kCellsPerAxis = 4096;              // 16 m about the origin: beyond, the outermost cell

using Cell = std::array<int, 3>;

int cellAlong(double v) {                        // [m]
  const double cells = v * (1.0 / kCell) + kCellsPerAxis / 2;   // [1]
  return cells > 0.0 ? static_cast<int>(std::min(cells, kCellsPerAxis - 1.0)) : 0;
}
Cell cellAt(const Vec3& p) { return {cellAlong(p.x()), cellAlong(p.y()), cellAlong(p.z())}; }

std::int64_t keyOf(const Cell& c) { return (static_cast<std::int64_t>(c[0]) * kCellsPerAxis + c[1]) * kCellsPerAxis + c[2]; }

int bucketOf(const Cell& c) {
  const std::uint32_t h = static_cast<std::uint32_t>(c[0]) * 73856093u ^ static_cast<std::uint32_t>(c[1]) * 19349663u ^
                          static_cast<std::uint32_t>(c[2]) * 83492791u;
  return static_cast<int>(h % SelfWork::kBuckets);
}

/// Counting sort of the surface's vertices into hashed cells: index order within a bucket.
void fillGrid(const Model& m, const TissueState& t, SelfWork& w) {
  w.start.fill(0);
  const int n = static_cast<int>(m.surface.vertices.size());
  for (int i = 0; i < n; ++i) {
    const Cell c = cellAt(t.position[m.surface.vertices[i]]);
    w.key[i] = keyOf(c);
    w.bucket[i] = bucketOf(c);
    ++w.start[w.bucket[i] + 1];
  }
  for (int b = 0; b < SelfWork::kBuckets; ++b) w.start[b + 1] += w.start[b];
  for (int i = n - 1; i >= 0; --i) {             // from the last: afterwards start[b + 1] is where bucket b begins
    const int at = --w.start[w.bucket[i] + 1];
    w.item[at] = m.surface.vertices[i];
    w.itemKey[at] = w.key[i];
  }
  for (int b = 0; b < SelfWork::kBuckets; ++b) w.start[b] = w.start[b + 1];
  w.start[SelfWork::kBuckets] = n;
}

/// A triangle made ready to reject most vertices by its plane and its ball.
struct Face {
  int index = 0;
  Vec3 normal = Vec3::UnitZ();                   // [1]
  Vec3 centre = Vec3::Zero();                    // [m]
  double squaredReach = 0.0;                     // [m^2] about the centre
  Cell low{}, high{};
};

Face faceOf(const Model& m, std::span<const Vec3> x, int triangle) {
  constexpr double kMargin = kPairReach + kPairAside;   // [m] more than any watched vertex is away
  const auto& v = m.surface.triangles[triangle];
  const Vec3 &a = x[v[0]], &b = x[v[1]], &c = x[v[2]];
  Face f;
  f.index = triangle;
  f.normal = (b - a).cross(c - a).normalized();
  f.centre = (a + b + c) / 3.0;
  const double most = std::max({(a - f.centre).squaredNorm(), (b - f.centre).squaredNorm(), (c - f.centre).squaredNorm()});   // [m^2]
  const double reach = std::sqrt(most) + kMargin;       // [m]
  f.squaredReach = reach * reach;
  const Vec3 margin = Vec3::Constant(kMargin);
  f.low = cellAt(a.cwiseMin(b).cwiseMin(c) - margin);
  f.high = cellAt(a.cwiseMax(b).cwiseMax(c) + margin);
  return f;
}

bool insideBall(const Face& f, const Vec3& p) {
  constexpr double kRoom = 1e-6;                 // [m] for rounding: the exact test follows
  const Vec3 d = p - f.centre;
  const double height = d.dot(f.normal);         // [m]
  return height < kPairReach + kRoom && height > -kPairBehind - kRoom && d.squaredNorm() < f.squaredReach;
}

/// Moves the pairs of this turn's triangles into the work space; the others close ranks. Both stay in ascending order of triangles.
void takeOut(int turn, TissueState& t, SelfWork& w) {
  int kept = 0;
  w.count = 0;
  for (int i = 0; i < t.pairCount; ++i) {
    const bool due = t.pairTriangle[i] % kPairRound == turn;
    auto& vertex = due ? w.vertex[w.count] : t.pairVertex[kept];
    auto& triangle = due ? w.triangle[w.count] : t.pairTriangle[kept];
    auto& force = due ? w.force[w.count] : t.pairForce[kept];
    ++(due ? w.count : kept);
    vertex = t.pairVertex[i];
    triangle = t.pairTriangle[i];
    force = t.pairForce[i];
  }
  t.pairCount = kept;
}

/// Force that this pair carried; `first` is the first pair of its triangle. Taken: what is left over was not found again.
double takeForce(SelfWork& w, int first, int vertex, int triangle) {
  for (int i = first; i < w.count && w.triangle[i] == triangle; ++i)
    if (w.vertex[i] == vertex) return std::exchange(w.force[i], 0.0);
  return 0.0;
}

void addPair(State& s, int first, int vertex, int triangle) {
  TissueState& t = s.tissue;
  if (t.pairCount >= TissueState::kMaxPairs) { ++t.droppedPairs; return; }
  t.pairVertex[t.pairCount] = vertex;
  t.pairTriangle[t.pairCount] = triangle;
  t.pairForce[t.pairCount++] = takeForce(s.work.self, first, vertex, triangle);
}

void searchVertex(const Model& m, const Face& face, int vertex, int first, State& s) {
  if (!insideBall(face, s.tissue.position[vertex]) || !mayTouch(m, vertex, face.index)) return;
  if (pairGap(m, s.tissue.position, vertex, face.index).near) addPair(s, first, vertex, face.index);
}

void searchCell(const Model& m, const Face& face, const Cell& cell, int first, State& s) {
  const SelfWork& w = s.work.self;
  const std::int64_t key = keyOf(cell);
  const int bucket = bucketOf(cell);
  for (int e = w.start[bucket]; e < w.start[bucket + 1]; ++e)
    if (w.itemKey[e] == key) searchVertex(m, face, w.item[e], first, s);
}

void searchFace(const Model& m, const Face& face, int first, State& s) {
  constexpr double kManyCells = 500.0;           // [1] a triangle stretched over more: every vertex is looked at instead
  double cells = 1.0;                            // [1]
  for (int axis = 0; axis < 3; ++axis) cells *= face.high[axis] - face.low[axis] + 1;
  if (cells > kManyCells) {
    for (int vertex : m.surface.vertices) searchVertex(m, face, vertex, first, s);
    return;
  }
  Cell c;
  for (c[0] = face.low[0]; c[0] <= face.high[0]; ++c[0])
    for (c[1] = face.low[1]; c[1] <= face.high[1]; ++c[1])
      for (c[2] = face.low[2]; c[2] <= face.high[2]; ++c[2]) searchCell(m, face, c, first, s);
}

/// Triangle holds every corner of `triangle` that has weight: it meets it in the edge or corner where the weights are.
bool sharesFeature(const SurfaceModel& s, int triangle, int other, const std::array<double, 3>& weight) {   // weight [1]
  const auto& v = s.triangles[other];
  for (int k = 0; k < 3; ++k)
    if (weight[k] > 0.0 && std::find(v.begin(), v.end(), s.triangles[triangle][k]) == v.end()) return false;
  return true;
}

/// Beside a triangle and below its plane is inside the tissue only if it is below the triangles beyond that edge or corner too. What
/// stands in front of one face of a sharp edge, as of the open rim, is below the plane of the other.
bool behindNeighbours(const Model& m, std::span<const Vec3> x, int vertex, int triangle, const std::array<double, 3>& weight) {   // weight [1]
  const SurfaceModel& s = m.surface;
  const int k = weight[0] > 0.0 ? 0 : (weight[1] > 0.0 ? 1 : 2), corner = s.triangles[triangle][k];
  for (int e = s.triangleStart[corner]; e < s.triangleStart[corner + 1]; ++e) {
    const int other = s.triangleOf[e];
    if (other == triangle || !sharesFeature(s, triangle, other, weight)) continue;
    const auto& v = s.triangles[other];
    if ((x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]).dot(x[vertex] - x[v[0]]) > 0.0) return false;
  }
  return true;
}

}  // namespace

PairGap pairGap(const Model& m, std::span<const Vec3> x, int vertex, int triangle) {
  PairGap g;
  const auto& v = m.surface.triangles[triangle];
  const Vec3 &a = x[v[0]], &b = x[v[1]], &c = x[v[2]];
  g.weight = closestOnTriangle(x[vertex], a, b, c);
  g.normal = (b - a).cross(c - a).normalized();
  const Vec3 away = x[vertex] - mix(g.weight, a, b, c);
  g.height = away.dot(g.normal);
  const double aside = (away - g.height * g.normal).squaredNorm();   // [m^2]
  g.near = g.height > -kPairBehind && g.height < kPairReach && aside < kPairAside * kPairAside;
  if (g.near && g.height < 0.0 && aside > kLevel * kLevel) g.near = behindNeighbours(m, x, vertex, triangle, g.weight);
  return g;
}

bool mayTouch(const Model& m, int vertex, int triangle) {
  bool free = !m.tissue.isFixed[vertex];
  for (int v : m.surface.triangles[triangle]) {
    if (v == vertex) return false;
    free = free || !m.tissue.isFixed[v];
    for (int e = m.surface.neighbourStart[v]; e < m.surface.neighbourStart[v + 1]; ++e)
      if (m.surface.neighbour[e] == vertex) return false;
  }
  return free;
}

void searchPairs(const Model& m, State& s) {
  TissueState& t = s.tissue;
  SelfWork& w = s.work.self;
  const int turn = static_cast<int>(s.step % kPairRound), before = t.pairCount;
  takeOut(turn, t, w);
  fillGrid(m, t, w);
  int first = 0;
  for (int f = turn; f < static_cast<int>(m.surface.triangles.size()); f += kPairRound) {
    while (first < w.count && w.triangle[first] < f) ++first;
    searchFace(m, faceOf(m, t.position, f), first, s);
  }
  for (int i = t.pairCount; i < before; ++i) { t.pairVertex[i] = t.pairTriangle[i] = -1; t.pairForce[i] = 0.0; }
}

}  // namespace halsted
