#include "scenes/centreline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "scenes/scene.h"

namespace halsted::scenes {
namespace {

constexpr int kLevels = 240;                      // level sets along the tube; tuned: several per radius on a whole colon
constexpr int kMostWandering = 4;                 // line over length of the surface; a tube's is near 1
constexpr double kMostNonManifold = 0.25;         // [1] share of edges; the reference colon's parts share walls: 0.16

/// Neighbouring vertices of each vertex, as one array with offsets.
struct VertexGraph {
  std::vector<int> begin, neighbour;
};

std::vector<std::array<int, 2>> sortedEdges(const Surface& surface) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(3 * surface.triangles.size());
  for (const auto& t : surface.triangles)
    for (int k = 0; k < 3; ++k) edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  std::sort(edges.begin(), edges.end());
  return edges;
}

VertexGraph vertexGraph(const Surface& surface) {
  std::vector<std::array<int, 2>> edges = sortedEdges(surface);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  VertexGraph graph;
  graph.begin.assign(surface.vertices.size() + 1, 0);
  for (const auto& [a, b] : edges) {
    ++graph.begin[a + 1];
    ++graph.begin[b + 1];
  }
  std::partial_sum(graph.begin.begin(), graph.begin.end(), graph.begin.begin());
  graph.neighbour.resize(2 * edges.size());
  std::vector<int> next(graph.begin.begin(), graph.begin.end() - 1);
  for (const auto& [a, b] : edges) {
    graph.neighbour[next[a]++] = b;
    graph.neighbour[next[b]++] = a;
  }
  return graph;
}

/// Shortest way along edges from `source`; infinite where there is none.
std::vector<double> distancesFrom(int source, const Surface& surface, const VertexGraph& graph) {  // [m]
  std::vector<double> distance(surface.vertices.size(), std::numeric_limits<double>::infinity());  // [m]
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  distance[source] = 0.0;
  open.emplace(0.0, source);
  while (!open.empty()) {
    const auto [reached, vertex] = open.top();
    open.pop();
    if (reached > distance[vertex]) continue;
    for (int i = graph.begin[vertex]; i < graph.begin[vertex + 1]; ++i) {
      const int other = graph.neighbour[i];
      const double through = reached + (surface.vertices[other] - surface.vertices[vertex]).norm();  // [m]
      if (through >= distance[other]) continue;
      distance[other] = through;
      open.emplace(through, other);
    }
  }
  return distance;
}

int farthest(const std::vector<double>& distance) {  // [m]
  int best = 0;
  for (int i = 0; i < static_cast<int>(distance.size()); ++i)
    if (std::isfinite(distance[i]) && distance[i] > distance[best]) best = i;
  return best;
}

/// Which connected piece each vertex belongs to, numbered by lowest vertex.
std::vector<int> connectedParts(const Surface& surface) {
  std::vector<int> parent(surface.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const auto& t : surface.triangles)
    for (int k = 1; k < 3; ++k) {
      const int a = root(t[0]), b = root(t[k]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  for (int v = 0; v < static_cast<int>(parent.size()); ++v) parent[v] = root(v);
  return parent;
}

int partWithLargestBox(const Surface& surface, const std::vector<int>& part) {
  const double far = std::numeric_limits<double>::infinity();  // [m]
  std::vector<Vec3> low(part.size(), Vec3::Constant(far)), high(part.size(), Vec3::Constant(-far));
  for (std::size_t v = 0; v < part.size(); ++v) {
    low[part[v]] = low[part[v]].cwiseMin(surface.vertices[v]);
    high[part[v]] = high[part[v]].cwiseMax(surface.vertices[v]);
  }
  int best = part[0];
  double largest = -1.0;  // [m]
  for (std::size_t v = 0; v < part.size(); ++v) {
    if (part[v] != static_cast<int>(v)) continue;
    const double diagonal = (high[v] - low[v]).norm();  // [m]
    if (diagonal > largest) {
      largest = diagonal;
      best = static_cast<int>(v);
    }
  }
  return best;
}

void refuseNonManifold(const Surface& surface) {
  const std::vector<std::array<int, 2>> edges = sortedEdges(surface);
  std::size_t distinct = 0, crowded = 0;
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    for (next = i; next < edges.size() && edges[next] == edges[i];) ++next;
    ++distinct;
    if (next - i > 2) ++crowded;
  }
  if (static_cast<double>(crowded) > kMostNonManifold * static_cast<double>(distinct))
    throw InputError("is non-manifold: " + std::to_string(crowded) + " of " + std::to_string(distinct) +
                     " edges join more than two triangles");
}

/// Adds the piece of each level line inside one triangle to the sums of that level.
void addLevels(const std::array<Vec3, 3>& corner, const std::array<double, 3>& value, double step,  // value, step [m]
               std::vector<Vec3>& sums, std::vector<double>& weights) {                             // weights [m]
  const double low = std::min({value[0], value[1], value[2]}), high = std::max({value[0], value[1], value[2]});  // [m]
  const int last = std::min(static_cast<int>(high / step), static_cast<int>(sums.size()) - 1);
  for (int level = std::max(0, static_cast<int>(std::ceil(low / step))); level <= last; ++level) {
    std::array<Vec3, 3> crossing;
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const double a = value[k] - level * step, b = value[(k + 1) % 3] - level * step;  // [m]
      if ((a < 0.0) == (b < 0.0)) continue;
      crossing[count++] = corner[k] + (a / (a - b)) * (corner[(k + 1) % 3] - corner[k]);
    }
    if (count != 2) continue;
    const double weight = (crossing[1] - crossing[0]).norm();  // [m]
    sums[level] += 0.5 * weight * (crossing[0] + crossing[1]);
    weights[level] += weight;
  }
}

Centreline withEqualSpacing(const std::vector<Vec3>& points, double spacing) {  // [m]
  double length = 0.0;  // [m]
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  if (!(length > 0.0)) throw InputError("is not a tube: it has no length");
  const int pieces = std::max(1, static_cast<int>(length / spacing + 0.5));
  Centreline line;
  line.spacing = length / pieces;
  line.points.push_back(points.front());
  double passed = 0.0;  // [m] up to points[i - 1]
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double piece = (points[i] - points[i - 1]).norm();  // [m]
    while (static_cast<int>(line.points.size()) < pieces && passed + piece >= line.spacing * static_cast<double>(line.points.size())) {
      const double rest = line.spacing * static_cast<double>(line.points.size()) - passed;  // [m]
      line.points.push_back(points[i - 1] + (rest / piece) * (points[i] - points[i - 1]));
    }
    passed += piece;
  }
  line.points.push_back(points.back());
  return line;
}

}  // namespace

Vec3 Centreline::at(double distance) const {
  const double place = std::clamp(distance / spacing, 0.0, static_cast<double>(points.size() - 1));  // [1]
  const std::size_t index = std::min(static_cast<std::size_t>(place), points.size() - 2);
  return points[index] + (place - static_cast<double>(index)) * (points[index + 1] - points[index]);
}

Vec3 Centreline::tangent(double distance) const { return (at(distance + spacing) - at(distance - spacing)).normalized(); }

double Centreline::nearest(const Vec3& place) const {
  double best = std::numeric_limits<double>::infinity(), distance = 0.0;  // [m^2], [m]
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 piece = points[i + 1] - points[i];
    const double share = std::clamp((place - points[i]).dot(piece) / std::max(piece.squaredNorm(), 1e-24), 0.0, 1.0);  // [1]
    const double squared = (place - points[i] - share * piece).squaredNorm();  // [m^2]
    if (squared >= best) continue;
    best = squared;
    distance = spacing * (static_cast<double>(i) + share);
  }
  return distance;
}

Surface largestPart(const Surface& surface) {
  const std::vector<int> part = connectedParts(surface);
  const int chosen = partWithLargestBox(surface, part);
  Surface result;
  result.groups = surface.groups;
  std::vector<int> compact(surface.vertices.size(), -1);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::array<int, 3> corners = surface.triangles[t];
    if (part[corners[0]] != chosen) continue;
    for (int& corner : corners) {
      if (compact[corner] < 0) {
        compact[corner] = static_cast<int>(result.vertices.size());
        result.vertices.push_back(surface.vertices[corner]);
      }
      corner = compact[corner];
    }
    result.triangles.push_back(corners);
    result.triangleGroup.push_back(surface.triangleGroup[t]);
  }
  refuseNonManifold(result);
  return result;
}

Centreline traceCentreline(const Surface& surface) {
  const VertexGraph graph = vertexGraph(surface);
  // Twice to the farthest vertex finds the two ends of anything long.
  const int one = farthest(distancesFrom(0, surface, graph));
  const int other = farthest(distancesFrom(one, surface, graph));
  const std::vector<double> distance = distancesFrom(std::min(one, other), surface, graph);  // [m]
  const double step = distance[std::max(one, other)] / kLevels;                              // [m]
  if (!(step > 0.0)) throw InputError("has no extent");

  std::vector<Vec3> sums(kLevels, Vec3::Zero());
  std::vector<double> weights(kLevels, 0.0);  // [m]
  for (const auto& t : surface.triangles)
    addLevels({surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]},
              {distance[t[0]], distance[t[1]], distance[t[2]]}, step, sums, weights);
  std::vector<Vec3> centres;
  for (int level = 0; level < kLevels; ++level)
    if (weights[level] > 0.0) centres.push_back(sums[level] / weights[level]);
  if (centres.size() < 4) throw InputError("is not a tube: it has no length");
  const Centreline line = withEqualSpacing(centres, step);
  if (line.points.size() > kMostWandering * kLevels) throw InputError("is not a tube: its middle line jumps to and fro");
  return line;
}

Centreline resampled(const Centreline& line, double spacing) { return withEqualSpacing(line.points, spacing); }

Centreline smoothed(const Centreline& line, double window) {
  const int half = std::max(1, static_cast<int>(window / line.spacing));
  const int last = static_cast<int>(line.points.size()) - 1;
  std::vector<Vec3> points = line.points;
  for (int i = 1; i < last; ++i) {
    // Narrower toward the ends, so that they neither shrink nor turn.
    const int reach = std::min({half, i, last - i});
    Vec3 sum = Vec3::Zero();
    double weights = 0.0;  // [1]
    for (int k = -reach; k <= reach; ++k) {
      const double weight = reach + 1 - std::abs(k);  // [1]
      sum += weight * line.points[i + k];
      weights += weight;
    }
    points[i] = sum / weights;
  }
  return withEqualSpacing(points, line.spacing);
}

}  // namespace halsted::scenes
