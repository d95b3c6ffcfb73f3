#include "sim/contact/pair_search.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/geometry.h"

namespace halsted {
namespace {

constexpr double kLeastCell = 3e-3;              // [m] about one edge of the mesh
constexpr double kLevel = 1e-7;                  // [m] nearer to the triangle's own column is over the triangle

using Cell = std::array<int, 3>;

/// Cells of a box about all vertices, each axis divided alike: however far the tissue is stretched there are no more of them.
class Grid {
 public:
  Grid(const Model& m, std::span<const Vec3> x) : low_(x[m.surface.vertices.front()]) {   // x [m]
    Vec3 high = low_;                            // [m]
    for (int v : m.surface.vertices) {
      low_ = low_.cwiseMin(x[v]);
      high = high.cwiseMax(x[v]);
    }
    for (int axis = 0; axis < 3; ++axis) perMetre_[axis] = 1.0 / std::max(kLeastCell, (high[axis] - low_[axis]) / SelfWork::kAxis);
  }
  Cell at(const Vec3& p) const {                 // [m]
    Cell c;
    for (int axis = 0; axis < 3; ++axis) {
      const double cells = (p[axis] - low_[axis]) * perMetre_[axis];   // [1]
      c[axis] = cells > 0.0 ? static_cast<int>(std::min(cells, SelfWork::kAxis - 1.0)) : 0;
    }
    return c;
  }
  static int index(int x, int y, int z) { return (x * SelfWork::kAxis + y) * SelfWork::kAxis + z; }

 private:
  Vec3 low_;                                     // [m]
  Vec3 perMetre_ = Vec3::Zero();                 // [1/m]
};

/// Counting sort of the surface's vertices into cells: index order within a cell.
void fillGrid(const Model& m, const TissueState& t, const Grid& grid, SelfWork& w) {
  w.start.fill(0);
  const int n = static_cast<int>(m.surface.vertices.size());
  for (int i = 0; i < n; ++i) {
    const Cell c = grid.at(t.position[m.surface.vertices[i]]);
    w.cell[i] = Grid::index(c[0], c[1], c[2]);
    ++w.start[w.cell[i] + 1];
  }
  for (int c = 0; c < SelfWork::kCells; ++c) w.start[c + 1] += w.start[c];
  for (int i = n - 1; i >= 0; --i) {             // from the last: afterwards start[c + 1] is where cell c begins
    const int at = --w.start[w.cell[i] + 1];
    w.item[at] = m.surface.vertices[i];
    w.place[at] = t.position[m.surface.vertices[i]];
  }
  std::copy(w.start.begin() + 1, w.start.end(), w.start.begin());
  w.start[SelfWork::kCells] = n;
}

/// A triangle made ready to reject most vertices by its plane and its ball.
struct Face {
  int index = 0, next = 0;                       // triangle; the pairs of the last round from here on belong to later ones
  bool held = false;                             // all three corners are fixed
  Vec3 normal = Vec3::UnitZ();                   // [1]
  Vec3 centre = Vec3::Zero();                    // [m]
  double squaredReach = 0.0;                     // [m^2] about the centre
  Cell low{}, high{};
};

Face faceOf(const Model& m, std::span<const Vec3> x, const Grid& grid, int triangle) {
  constexpr double kMargin = kPairReach + kPairAside;   // [m] more than any watched vertex is away
  const auto& v = m.surface.triangles[triangle];
  const Vec3 &a = x[v[0]], &b = x[v[1]], &c = x[v[2]];
  Face f;
  f.index = triangle;
  f.held = m.tissue.isFixed[v[0]] && m.tissue.isFixed[v[1]] && m.tissue.isFixed[v[2]];
  f.normal = (b - a).cross(c - a).normalized();
  f.centre = (a + b + c) / 3.0;
  const double most = std::max({(a - f.centre).squaredNorm(), (b - f.centre).squaredNorm(), (c - f.centre).squaredNorm()});   // [m^2]
  const double reach = std::sqrt(most) + kMargin;       // [m]
  f.squaredReach = reach * reach;
  const Vec3 margin = Vec3::Constant(kMargin);
  f.low = grid.at(a.cwiseMin(b).cwiseMin(c) - margin);
  f.high = grid.at(a.cwiseMax(b).cwiseMax(c) + margin);
  return f;
}

bool insideBall(const Face& f, const Vec3& p) {
  constexpr double kRoom = 1e-6;                 // [m] for rounding: the exact test follows
  const Vec3 d = p - f.centre;
  const double height = d.dot(f.normal);         // [m]
  // One branch instead of three: which of them fails is as good as random.
  return (height < kPairReach + kRoom) & (height > -kPairBehind - kRoom) & (d.squaredNorm() < f.squaredReach);
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

void addPair(State& s, int vertex, int triangle, double force) {   // [N]
  TissueState& t = s.tissue;
  t.pairVertex[t.pairCount] = vertex;
  t.pairTriangle[t.pairCount] = triangle;
  t.pairForce[t.pairCount++] = force;
}

/// Pairs of a triangle that carry force stay, near or not: the next sweep lets go of them. Marked, so that none is added twice.
void keepLoaded(int triangle, int& next, State& s) {
  SelfWork& w = s.work.self;
  for (; next < w.count && w.triangle[next] == triangle; ++next) {
    if (w.force[next] == 0.0) continue;
    addPair(s, w.vertex[next], triangle, w.force[next]);
    w.ring[w.vertex[next]] = triangle;
  }
}

/// Marks the corners of a triangle and all that they are joined to: most vertices near a triangle are its neighbours.
void markRing(const Model& m, int triangle, SelfWork& w) {
  for (int v : m.surface.triangles[triangle]) {
    w.ring[v] = triangle;
    for (int e = m.surface.neighbourStart[v]; e < m.surface.neighbourStart[v + 1]; ++e) w.ring[m.surface.neighbour[e]] = triangle;
  }
}

void searchRun(const Model& m, const Face& face, int from, int to, State& s) {
  const SelfWork& w = s.work.self;
  for (int e = from; e < to; ++e) {
    if (!insideBall(face, w.place[e]) || w.ring[w.item[e]] == face.index) continue;
    const int vertex = w.item[e];
    if ((face.held && m.tissue.isFixed[vertex]) || !pairGap(m, s.tissue.position, vertex, face.index).near) continue;
    const int reserved = w.count - face.next;    // for what may still have to stay
    if (s.tissue.pairCount + reserved < TissueState::kMaxPairs) addPair(s, vertex, face.index, 0.0);
    else ++s.tissue.droppedPairs;
  }
}

void searchFace(const Model& m, const Face& face, State& s) {
  const SelfWork& w = s.work.self;
  for (int x = face.low[0]; x <= face.high[0]; ++x)
    for (int y = face.low[1]; y <= face.high[1]; ++y)
      searchRun(m, face, w.start[Grid::index(x, y, face.low[2])], w.start[Grid::index(x, y, face.high[2]) + 1], s);
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
  const Grid grid(m, t.position);
  takeOut(turn, t, w);
  fillGrid(m, t, grid, w);
  std::fill(w.ring.begin(), w.ring.end(), -1);   // no mark of an earlier step counts
  int next = 0;
  for (int f = turn; f < static_cast<int>(m.surface.triangles.size()); f += kPairRound) {
    markRing(m, f, w);
    keepLoaded(f, next, s);
    Face face = faceOf(m, t.position, grid, f);
    face.next = next;
    searchFace(m, face, s);
  }
  for (int i = t.pairCount; i < before; ++i) { t.pairVertex[i] = t.pairTriangle[i] = -1; t.pairForce[i] = 0.0; }
}

}  // namespace halsted
