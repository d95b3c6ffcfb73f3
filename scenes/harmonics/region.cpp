#include "scenes/harmonics/region.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scenes/input_text.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr double kDome = 0.7;                  // [1] height over mean radius: near enough to round

/// Cuts triangles at the plane. A vertex nearer to it than a third of the usual side moves onto it, so that no sliver is made;
/// elsewhere each edge that crosses the plane gets one vertex there.
class Cutter {
 public:
  Cutter(Surface& surface, const CutPlane& plane, double side) : s_(surface) {   // side [m]
    for (Vec3& p : s_.vertices) {
      const double d = (p - plane.point).dot(plane.normal);   // [m]
      const bool near = std::abs(d) < side / 3.0;
      if (near) p -= d * plane.normal;
      height_.push_back(near ? 0.0 : d);
    }
  }
  void run() {
    const std::vector<std::array<int, 3>> before = std::move(s_.triangles);
    s_.triangles.clear();
    for (const auto& t : before) {
      if (std::max({height_[t[0]], height_[t[1]], height_[t[2]]}) <= 0.0) continue;
      std::vector<int> polygon;
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        if (height_[a] >= 0.0) polygon.push_back(a);
        if (height_[a] * height_[b] < 0.0) polygon.push_back(crossing(a, b));
      }
      for (std::size_t k = 2; k < polygon.size(); ++k) s_.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
    }
  }

 private:
  int crossing(int a, int b) {
    if (a > b) std::swap(a, b);
    const auto [at, isNew] = made_.try_emplace({a, b}, static_cast<int>(s_.vertices.size()));
    if (isNew) s_.vertices.push_back(s_.vertices[a] + height_[a] / (height_[a] - height_[b]) * (s_.vertices[b] - s_.vertices[a]));
    return at->second;
  }

  Surface& s_;
  std::vector<double> height_;                 // [m]
  std::map<std::array<int, 2>, int> made_;
};

/// Keeps the connected piece of `keep` and renumbers.
Surface pieceWith(const Surface& s, int keep) {
  std::vector<std::vector<int>> trianglesOf(s.vertices.size());
  for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t)
    for (int v : s.triangles[t]) trianglesOf[v].push_back(t);
  std::vector<int> number(s.vertices.size(), -1), queue{keep};
  number[keep] = 0;
  Surface out;
  out.groups.assign(1, "");
  out.vertices.push_back(s.vertices[keep]);
  std::vector<char> seen(s.triangles.size(), 0);
  for (std::size_t at = 0; at < queue.size(); ++at)
    for (int t : trianglesOf[queue[at]]) {
      if (seen[t]++) continue;
      for (int v : s.triangles[t]) {
        if (number[v] >= 0) continue;
        number[v] = static_cast<int>(out.vertices.size());
        out.vertices.push_back(s.vertices[v]);
        queue.push_back(v);
      }
      out.triangles.push_back({number[s.triangles[t][0]], number[s.triangles[t][1]], number[s.triangles[t][2]]});
    }
  return out;
}

/// The outlines of the open edges, each a loop of vertices that runs against its triangles.
std::vector<std::vector<int>> openLoops(const Surface& s, const std::string& origin) {
  std::map<std::array<int, 2>, int> sides;
  for (const auto& t : s.triangles)
    for (int k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  std::map<int, int> after;                    // along an open edge, against the direction of its triangle
  for (const auto& [side, count] : sides)
    if (!sides.count({side[1], side[0]}) && !after.emplace(side[1], side[0]).second)
      throw InputError(origin + ": the outline of a cut touches itself; move the plane a little");
  std::vector<std::vector<int>> loops;
  while (!after.empty()) {
    std::vector<int> loop{after.begin()->first};
    for (auto at = after.begin(); at != after.end(); at = after.find(loop.back())) {
      const int next = at->second;
      after.erase(at);
      if (next != loop.front()) loop.push_back(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Points round a closed outline by the share of its length, 0 to 1.
struct Outline {
  std::vector<Vec3> points;                    // [m]
  std::vector<double> share;                   // [1] where each begins; one more entry, 1, at the end
  double length = 0.0;                         // [m]

  Vec3 at(double where) const {                // [1]
    const auto next = std::upper_bound(share.begin() + 1, share.end() - 1, where);
    const std::size_t k = next - share.begin() - 1;
    const double part = (where - share[k]) / std::max(share[k + 1] - share[k], 1e-300);   // [1]
    return points[k] + part * (points[(k + 1) % points.size()] - points[k]);
  }
};

Outline outlineOf(const Surface& s, const std::vector<int>& loop) {
  Outline o;
  for (int v : loop) o.points.push_back(s.vertices[v]);
  const std::size_t n = loop.size();
  for (std::size_t k = 0; k < n; ++k) {
    o.share.push_back(o.length);
    o.length += (o.points[(k + 1) % n] - o.points[k]).norm();
  }
  for (double& x : o.share) x /= o.length;
  o.share.push_back(1.0);
  return o;
}

struct Ring { std::vector<int> vertex; std::vector<double> share; };   // share [1] of the outline

/// Triangles between two rings with different numbers of vertices: always the side whose next vertex comes first.
void zip(const Ring& outer, const Ring& inner, Surface& s) {
  const std::size_t n = outer.vertex.size(), m = inner.vertex.size();
  for (std::size_t i = 0, j = 0; i < n || j < m;) {
    const int a = outer.vertex[i % n], b = inner.vertex[j % m];
    const double nextOuter = i + 1 < n ? outer.share[i + 1] : 1.0, nextInner = j + 1 < m ? inner.share[j + 1] : 1.0;   // [1]
    if (j == m || (i < n && nextOuter <= nextInner)) s.triangles.push_back({a, outer.vertex[++i % n], b});
    else s.triangles.push_back({a, inner.vertex[++j % m], b});
  }
}

/// Rings from the outline to a top, along a quarter of an ellipse, so that the dome goes straight on from the outline; as many
/// vertices in a ring as its size asks for.
void closeLoop(Surface& s, const std::vector<int>& loop, const Vec3& outward, double side) {   // outward [1], side [m]
  const Outline outline = outlineOf(s, loop);
  Vec3 centre = Vec3::Zero();                  // [m]
  for (int k = 0; k < 100; ++k) centre += 0.01 * outline.at(0.01 * k);
  const double radius = outline.length / (2.0 * kPi);   // [m]
  const int rings = std::clamp(static_cast<int>(0.5 * kPi * radius / side), 3, 40);
  Ring outer{loop, {outline.share.begin(), outline.share.end() - 1}};
  for (int k = 1; k < rings; ++k) {
    const double angle = 0.5 * kPi * k / rings;          // [rad]
    const int count = std::max(6, static_cast<int>(outline.length * cosine(angle) / side));
    Ring inner;
    for (int i = 0; i < count; ++i) {
      inner.share.push_back(i / static_cast<double>(count));
      inner.vertex.push_back(static_cast<int>(s.vertices.size()));
      s.vertices.push_back(centre + cosine(angle) * (outline.at(inner.share[i]) - centre) + kDome * radius * sine(angle) * outward);
    }
    zip(outer, inner, s);
    outer = std::move(inner);
  }
  const int top = static_cast<int>(s.vertices.size()), n = static_cast<int>(outer.vertex.size());
  s.vertices.push_back(centre + kDome * radius * outward);
  for (int i = 0; i < n; ++i) s.triangles.push_back({outer.vertex[i], outer.vertex[(i + 1) % n], top});
}

/// Side of an equilateral triangle of the surface's median area.
double usualSide(const Surface& s) {           // [m]
  std::vector<double> area;                    // [m^2]
  for (const auto& [a, b, c] : s.triangles)
    area.push_back(0.5 * (s.vertices[b] - s.vertices[a]).cross(s.vertices[c] - s.vertices[a]).norm());
  std::nth_element(area.begin(), area.begin() + area.size() / 2, area.end());
  return std::sqrt(4.0 * area[area.size() / 2] / std::sqrt(3.0));
}

int nearestVertex(const Surface& s, const Vec3& place) {
  std::vector<char> used(s.vertices.size(), 0);
  for (const auto& t : s.triangles) for (int v : t) used[v] = 1;
  int best = -1;
  for (int v = 0; v < static_cast<int>(used.size()); ++v)
    if (used[v] && (best < 0 || (s.vertices[v] - place).squaredNorm() < (s.vertices[best] - place).squaredNorm())) best = v;
  return best;
}

}  // namespace

Surface cutRegion(const Surface& whole, const std::vector<CutPlane>& planes, const Vec3& inside, const std::string& origin) {
  Surface s = whole;
  for (const CutPlane& given : planes) {
    const CutPlane plane{given.point, given.normal.normalized()};
    const double side = usualSide(s);          // [m]
    Cutter(s, plane, side).run();
    const int keep = nearestVertex(s, inside);
    if (keep < 0) throw InputError(origin + ": the cut planes leave nothing");
    s = pieceWith(s, keep);
    for (const std::vector<int>& loop : openLoops(s, origin)) closeLoop(s, loop, -plane.normal, side);
  }
  s.groups.assign(1, "");
  s.triangleGroup.assign(s.triangles.size(), 0);
  return s;
}

}  // namespace halsted::scenes
