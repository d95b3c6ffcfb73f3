#include "sim/contact/pair_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim/contact/face.h"
#include "sim/contact/geometry.h"
#include "sim/contact/vertex_grid.h"

namespace halsted {
namespace {

constexpr double kLevel = 1e-7;                  // [m] nearer to the triangle's own column is over the triangle
constexpr double kRoom = 1e-6;                   // [m] for rounding: the exact test follows
constexpr double kWatched = 1.3e-3 + kRoom;      // [m] from the triangle's nearest point: kPairReach and kPairAside, at a right angle
constexpr double kListed = kWatched + 2.0 * kPairDrift + kRoom;   // [m] farther now, a pair cannot be near while the list holds
static_assert(kWatched * kWatched > kPairReach * kPairReach + kPairAside * kPairAside && kPairReach >= kPairBehind);

/// What a search looks for: pairs that are near, and when it makes a list those too that may be while the list holds.
struct Scope {
  double aside = kPairReach + kPairAside;        // [m] more than any watched vertex is away
  double above = kPairReach + kRoom, behind = kPairBehind + kRoom;   // [m]
  NearPairs* list = nullptr;                     // to be made
};

Scope listScope(NearPairs& list) {
  Scope s;
  s.list = &list;
  s.above = s.behind = kListed;                  // a triangle may turn while the list holds
  s.aside = kListed;
  return s;
}

Face faceOf(const Model& m, std::span<const Vec3> x, int triangle, const Scope& scope) {
  const auto& v = m.surface.triangles[triangle];
  Face f;
  f.a = x[v[0]];
  f.b = x[v[1]];
  f.c = x[v[2]];
  f.index = triangle;
  f.held = m.tissue.isFixed[v[0]] && m.tissue.isFixed[v[1]] && m.tissue.isFixed[v[2]];
  f.normal = (f.b - f.a).cross(f.c - f.a).normalized();
  f.centre = (f.a + f.b + f.c) / 3.0;
  f.above = scope.above;
  f.behind = scope.behind;
  const double most = std::max({(f.a - f.centre).squaredNorm(), (f.b - f.centre).squaredNorm(), (f.c - f.centre).squaredNorm()});   // [m^2]
  const double reach = std::sqrt(most) + scope.aside;   // [m]
  f.squaredReach = reach * reach;
  return f;
}

double squaredDistance(const Face& f, const Vec3& p) { return (p - mix(closestOnTriangle(p, f.a, f.b, f.c), f.a, f.b, f.c)).squaredNorm(); }

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

/// Marks of SelfWork::ring: the vertex is a neighbour of this triangle; the vertex is in a pair with it that has stayed.
int ringMark(int triangle) { return 2 * triangle; }
int keptMark(int triangle) { return 2 * triangle + 1; }

/// Pairs of a triangle that carry force stay, near or not: the next sweep lets go of them. Marked, so that none is added twice.
void keepLoaded(int triangle, int& next, State& s) {
  SelfWork& w = s.work.self;
  for (; next < w.count && w.triangle[next] == triangle; ++next) {
    if (w.force[next] == 0.0) continue;
    addPair(s, w.vertex[next], triangle, w.force[next]);
    w.ring[w.vertex[next]] = keptMark(triangle);
  }
}

/// Is a surface edge still held by tissue? Across a cut nothing but contact keeps two neighbours apart.
bool tied(const State& s, int edge) { return !s.cut || s.cut->tie[edge]; }

/// Marks the corners of a triangle and all that they are joined to: most vertices near a triangle are its neighbours.
void markRing(const Model& m, int triangle, State& s) {
  auto& ring = s.work.self.ring;
  for (int v : m.surface.triangles[triangle]) {
    for (int e = m.surface.neighbourStart[v]; e < m.surface.neighbourStart[v + 1]; ++e)
      if (tied(s, e)) ring[m.surface.neighbour[e]] = ringMark(triangle);
  }
  for (int v : m.surface.triangles[triangle]) ring[v] = ringMark(triangle);
}

void offer(const Model& m, const Face& face, int vertex, State& s) {
  if (!pairGap(m, {s.tissue.position, s.tissue.gone}, vertex, face.index).near) return;
  const int reserved = s.work.self.count - face.next;   // for what may still have to stay
  if (s.tissue.pairCount + reserved < TissueState::kMaxPairs) addPair(s, vertex, face.index, 0.0);
  else ++s.tissue.droppedPairs;
}

/// Puts the pair on the list if it belongs there; true when it may be near now.
bool enlist(const Face& face, int vertex, const Vec3& p, NearPairs& list) {   // p [m]
  const double far2 = squaredDistance(face, p);  // [m^2]
  if (far2 > kListed * kListed) return false;
  if (list.count < NearPairs::kMost) {
    list.vertex[list.count] = vertex;
    list.triangle[list.count] = face.index;
    list.far[list.count] = std::sqrt(far2);
  }
  ++list.count;
  return far2 <= kWatched * kWatched;
}

void searchRun(const Model& m, const Face& face, std::array<int, 2> run, NearPairs* list, State& s) {
  SelfWork& w = s.work.self;
  const int count = insideRun(face, run[0], run[1], w);
  for (int i = 0; i < count; ++i) {
    const int vertex = w.inside[i];
    if (s.cut && !s.cut->bare[vertex]) continue;
    if (w.ring[vertex] == ringMark(face.index) || (face.held && m.tissue.isFixed[vertex])) continue;
    const bool candidate = list == nullptr || enlist(face, vertex, s.tissue.position[vertex], *list);
    if (candidate && w.ring[vertex] != keptMark(face.index)) offer(m, face, vertex, s);
  }
}

void searchFace(const Model& m, const VertexGrid& grid, const Face& face, const Scope& scope, State& s) {
  const SelfWork& w = s.work.self;
  const Vec3 margin = Vec3::Constant(scope.aside);
  const Cell low = grid.at(face.a.cwiseMin(face.b).cwiseMin(face.c) - margin), high = grid.at(face.a.cwiseMax(face.b).cwiseMax(face.c) + margin);
  for (int x = low[0]; x <= high[0]; ++x)
    for (int y = low[1]; y <= high[1]; ++y)
      searchRun(m, face, {w.start[VertexGrid::index(x, y, low[2])], w.start[VertexGrid::index(x, y, high[2]) + 1]}, scope.list, s);
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
bool behindNeighbours(const Model& m, const SurfaceNow& now, int vertex, int triangle, const std::array<double, 3>& weight) {   // weight [1]
  const SurfaceModel& s = m.surface;
  const std::span<const Vec3> x = now.position;
  const int k = weight[0] > 0.0 ? 0 : (weight[1] > 0.0 ? 1 : 2), corner = s.triangles[triangle][k];
  for (int e = s.triangleStart[corner]; e < s.triangleStart[corner + 1]; ++e) {
    const int other = s.triangleOf[e];
    if (other == triangle || !exposed(s, now.gone, other) || !sharesFeature(s, triangle, other, weight)) continue;
    const auto& v = s.triangles[other];
    if ((x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]).dot(x[vertex] - x[v[0]]) > 0.0) return false;
  }
  return true;
}

/// How far any vertex is from where it was when the list was made, squared; more than a list allows for where something is not a number.  [m^2]
double drift(const Model& m, std::span<const Vec3> x, const NearPairs& list) {   // [m]
  double most = 0.0;                             // [m^2]
  bool numbers = true;
  for (std::size_t i = 0; i < list.place.size(); ++i) {
    const double gone = (x[m.surface.vertices[i]] - list.place[i]).squaredNorm();   // [m^2]
    numbers &= gone == gone;
    most = gone > most ? gone : most;
  }
  return numbers ? most : std::numeric_limits<double>::infinity();
}

int goneTets(const State& s) { return s.cut ? s.cut->goneTets : 0; }

/// Through the cells. A list costs half as much again as a search: it is made where the last one served, or would have.
void searchCells(const Model& m, int turn, const Scope& scope, State& s) {
  SelfWork& w = s.work.self;
  const VertexGrid grid(m, s.tissue.position);
  std::fill(w.ring.begin(), w.ring.end(), -1);   // no mark of an earlier step counts
  NearPairs& list = w.nearby[turn];
  list.whole = list.used = false;
  list.count = 0;
  list.goneTets = goneTets(s);
  for (std::size_t i = 0; i < list.place.size(); ++i) list.place[i] = s.tissue.position[m.surface.vertices[i]];
  fillGrid(m, s.tissue, grid, w);
  int next = 0;
  for (int f = turn; f < static_cast<int>(m.surface.triangles.size()); f += kPairRound) {
    if (s.cut && !exposed(m.surface, s.tissue.gone, f)) continue;
    markRing(m, f, s);
    keepLoaded(f, next, s);
    Face face = faceOf(m, s.tissue.position, f, scope);
    face.next = next;
    searchFace(m, grid, face, scope, s);
  }
  list.whole = scope.list != nullptr && list.count <= NearPairs::kMost;
}

/// A list as it is looked at in one step.
struct ListLook {
  NearPairs& list;
  double within = 0.0;                           // [m] what was farther apart when the list was made cannot be near now
  bool kept = false;                             // pairs of the last round may stay, and are marked
  std::optional<VertexGrid> grid;                // made for the first triangle with two vertices to be put in order
};

/// One triangle's part of the list, in the order of the cells.
void searchListed(const Model& m, const Face& face, std::array<int, 2> run, ListLook& look, State& s) {
  SelfWork& w = s.work.self;
  const auto x = [&](int vertex) -> const Vec3& { return s.tissue.position[vertex]; };
  int count = 0;
  for (int e = run[0]; e < run[1]; ++e) {
    const int v = look.list.vertex[e];
    if (look.list.far[e] <= look.within && insideBall(face, x(v)) && !(look.kept && w.ring[v] == keptMark(face.index))) w.inside[count++] = v;
  }
  if (count > 1) {
    if (!look.grid) look.grid.emplace(m, s.tissue.position);
    std::sort(w.inside.begin(), w.inside.begin() + count, [&](int a, int b) {
      const int left = look.grid->indexAt(x(a)), right = look.grid->indexAt(x(b));
      return left != right ? left < right : a < b;
    });
  }
  for (int i = 0; i < count; ++i) offer(m, face, w.inside[i], s);
}

void searchList(const Model& m, int turn, double drifted, State& s) {   // [m]
  SelfWork& w = s.work.self;
  ListLook look{w.nearby[turn], kWatched + 2.0 * drifted + kRoom, w.count > 0, std::nullopt};
  NearPairs& list = look.list;
  if (look.kept) std::fill(w.ring.begin(), w.ring.end(), -1);   // no mark of an earlier step counts
  list.used = true;
  int next = 0, e = 0;
  while (e < list.count || next < w.count) {
    // Triangles with nothing near and no pair of the last round have nothing to do.
    const int listed = e < list.count ? list.triangle[e] : std::numeric_limits<int>::max();
    const int f = next < w.count ? std::min(listed, w.triangle[next]) : listed;
    const int first = e;
    bool near = false;
    for (; e < list.count && list.triangle[e] == f; ++e) near |= list.far[e] <= look.within;
    keepLoaded(f, next, s);
    if (!near) continue;
    Face face = faceOf(m, s.tissue.position, f, Scope{});
    face.next = next;
    searchListed(m, face, {first, e}, look, s);
  }
}

}  // namespace

PairGap pairGap(const Model& m, const SurfaceNow& now, int vertex, int triangle) {
  const std::span<const Vec3> x = now.position;
  PairGap g;
  const auto& v = m.surface.triangles[triangle];
  const Vec3 &a = x[v[0]], &b = x[v[1]], &c = x[v[2]];
  g.weight = closestOnTriangle(x[vertex], a, b, c);
  g.normal = (b - a).cross(c - a).normalized();
  const Vec3 away = x[vertex] - mix(g.weight, a, b, c);
  g.height = away.dot(g.normal);
  const double aside = (away - g.height * g.normal).squaredNorm();   // [m^2]
  g.near = g.height > -kPairBehind && g.height < kPairReach && aside < kPairAside * kPairAside;
  if (g.near && g.height < 0.0 && aside > kLevel * kLevel) g.near = behindNeighbours(m, now, vertex, triangle, g.weight);
  return g;
}

bool mayTouch(const Model& m, int vertex, int triangle, const CutState* cut) {
  if (cut && !cut->bare[vertex]) return false;
  bool free = !m.tissue.isFixed[vertex];
  for (int v : m.surface.triangles[triangle]) {
    if (v == vertex) return false;
    free = free || !m.tissue.isFixed[v];
    for (int e = m.surface.neighbourStart[v]; e < m.surface.neighbourStart[v + 1]; ++e)
      if (m.surface.neighbour[e] == vertex && (!cut || cut->tie[e])) return false;
  }
  return free;
}

void searchPairs(const Model& m, State& s) {
  TissueState& t = s.tissue;
  SelfWork& w = s.work.self;
  const int turn = static_cast<int>(s.step % kPairRound), before = t.pairCount;
  takeOut(turn, t, w);
  NearPairs& list = w.nearby[turn];
  const double drifted = drift(m, t.position, list);   // [m^2]
  const bool calm = list.goneTets == goneTets(s) && drifted < kPairDrift * kPairDrift;
  if (calm && list.whole) searchList(m, turn, std::sqrt(drifted), s);
  else searchCells(m, turn, calm || list.used ? listScope(list) : Scope{}, s);
  for (int i = t.pairCount; i < before; ++i) { t.pairVertex[i] = t.pairTriangle[i] = -1; t.pairForce[i] = 0.0; }
}

}  // namespace halsted
