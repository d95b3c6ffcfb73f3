#include "render/shape.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>

#include "render/color.h"

namespace halsted::render {
namespace {

constexpr double kCreaseCosine = 0.766;      // [1] 40 degrees
constexpr double kTurn = 2.0 * std::numbers::pi;   // [rad]

struct Corners {
  std::vector<Vec3> points;                  // [m]
  std::vector<std::array<int, 3>> triangles;
};

void addQuad(Corners& c, int p, int q, int r, int s) {
  c.triangles.push_back({p, q, r});
  c.triangles.push_back({p, r, s});
}

Corners gridOf(const Loft& loft) {
  Corners c;
  for (int i = 0; i < loft.rings; ++i)
    for (int k = 0; k < loft.sides; ++k) c.points.push_back(loft.point(i, k));
  const auto at = [&](int i, int k) { return i * loft.sides + k % loft.sides; };
  for (int i = 0; i + 1 < loft.rings; ++i)
    for (int k = 0; k < loft.sides; ++k) addQuad(c, at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i + 1, k));
  for (int k = 1; k + 1 < loft.sides; ++k) {
    c.triangles.push_back({at(0, 0), at(0, k + 1), at(0, k)});
    c.triangles.push_back({at(loft.rings - 1, 0), at(loft.rings - 1, k), at(loft.rings - 1, k + 1)});
  }
  return c;
}

/// Corners that are the same to the bit are one vertex: each is transformed once per frame and pass.
class VertexPool {
 public:
  explicit VertexPool(Shape& shape) : shape_(shape) {}
  void add(const ShapeVertex& vertex) {
    const auto [found, fresh] = known_.try_emplace(vertex, static_cast<std::uint32_t>(shape_.vertices.size()));
    if (fresh) shape_.vertices.push_back(vertex);
    shape_.indices.push_back(found->second);
  }

 private:
  struct ByBits {
    bool operator()(const ShapeVertex& a, const ShapeVertex& b) const { return std::memcmp(&a, &b, sizeof a) < 0; }
  };
  Shape& shape_;
  std::map<ShapeVertex, std::uint32_t, ByBits> known_;
};

}  // namespace

void addLoft(Shape& shape, const Loft& loft) {
  const Corners c = gridOf(loft);
  std::vector<Vec3> face(c.triangles.size());            // [m^2]
  std::vector<std::vector<int>> around(c.points.size());
  for (std::size_t t = 0; t < c.triangles.size(); ++t) {
    const auto& [p, q, r] = c.triangles[t];
    face[t] = (c.points[q] - c.points[p]).cross(c.points[r] - c.points[p]);
    for (int v : c.triangles[t]) around[v].push_back(static_cast<int>(t));
  }
  VertexPool pool(shape);
  for (std::size_t t = 0; t < c.triangles.size(); ++t) {
    const Vec3 own = face[t].normalized();
    for (int v : c.triangles[t]) {
      Vec3 sum = Vec3::Zero();                           // [m^2]
      for (int other : around[v])
        if (face[other].dot(own) >= kCreaseCosine * face[other].norm()) sum += face[other];
      const Vec3 n = sum.norm() > 0.0 ? Vec3(sum.normalized()) : Vec3(Vec3::UnitZ());
      const int ring = v / loft.sides, side = v % loft.sides;
      const auto color = loft.color(ring, side);
      ShapeVertex vertex{};
      for (int k = 0; k < 3; ++k) {
        vertex.position[k] = static_cast<float>(c.points[v][k]);
        vertex.normal[k] = static_cast<float>(n[k]);
        vertex.color[k] = rootByteOf(color[k]);
      }
      vertex.uv[0] = static_cast<float>(side) / static_cast<float>(loft.sides);
      vertex.uv[1] = static_cast<float>(c.points[v].z());
      vertex.color[3] = 255;
      pool.add(vertex);
    }
  }
}

void addRevolved(Shape& shape, const std::vector<std::array<double, 2>>& profile, const Pose& pose,
                 const std::array<double, 3>& color) {
  constexpr int kSides = 20;
  Loft loft{static_cast<int>(profile.size()), kSides, {}, [&](int, int) { return color; }};
  loft.point = [&](int i, int k) {
    const double a = kTurn * k / kSides;                 // [rad]
    return pose.apply(Vec3(profile[i][0] * std::cos(a), profile[i][0] * std::sin(a), profile[i][1]));
  };
  addLoft(shape, loft);
}

void addRing(Shape& shape, double radius, double wire, const Pose& pose, const std::array<double, 3>& color) {
  constexpr int kRings = 28, kSides = 8;
  Loft loft{kRings + 1, kSides, {}, [&](int, int) { return color; }};
  loft.point = [&](int i, int k) {
    const double a = kTurn * i / kRings, b = kTurn * k / kSides;                   // [rad]
    const double r = radius + wire * std::cos(b);                                  // [m]
    return pose.apply(Vec3(r * std::cos(a), wire * std::sin(b), r * std::sin(a)));
  };
  addLoft(shape, loft);
}

}  // namespace halsted::render
