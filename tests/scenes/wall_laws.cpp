#include "tests/scenes/wall_laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "scenes/scene.h"
#include "scenes/tube_grid.h"

namespace halsted::testing {
namespace {

using Edge = std::array<int, 2>;

void expectConforming(const TetMesh& mesh) {
  std::map<std::array<int, 3>, int> owners;
  for (const auto& tet : mesh.tets)
    for (int f = 0; f < 4; ++f) {
      std::array<int, 3> face = {tet[(f + 1) % 4], tet[(f + 2) % 4], tet[(f + 3) % 4]};
      std::sort(face.begin(), face.end());
      ++owners[face];
    }
  std::set<std::array<int, 3>> boundary;
  for (auto triangle : mesh.surface) {
    std::sort(triangle.begin(), triangle.end());
    EXPECT_TRUE(boundary.insert(triangle).second) << "a boundary triangle twice";
  }
  for (const auto& [face, count] : owners) EXPECT_EQ(count, boundary.count(face) ? 1 : 2);
  EXPECT_EQ(std::count_if(owners.begin(), owners.end(), [](const auto& face) { return face.second == 1; }),
            static_cast<long>(boundary.size()));
}

/// Each edge is used once in each direction: closed, oriented, no edge with more than two triangles.
void expectClosedSurface(const TetMesh& mesh) {
  std::set<Edge> directed;
  std::set<int> vertices;
  for (const auto& t : mesh.surface)
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(directed.insert({t[k], t[(k + 1) % 3]}).second);
      vertices.insert(t[k]);
    }
  for (const auto& [a, b] : directed) EXPECT_TRUE(directed.count({b, a}));
  const long euler = static_cast<long>(vertices.size()) - static_cast<long>(directed.size() / 2) + static_cast<long>(mesh.surface.size());
  EXPECT_EQ(euler, 0) << "a tube's wall is a torus";
}

void expectOutward(const TetMesh& mesh) {
  double enclosed = 0.0;  // [m^3]
  for (const auto& t : mesh.surface)
    enclosed += mesh.vertices[t[0]].cross(mesh.vertices[t[1]]).dot(mesh.vertices[t[2]]) / 6.0;
  EXPECT_NEAR(enclosed, volume(mesh), 1e-9 * volume(mesh));
}

void expectLayers(const TetMesh& mesh) {
  ASSERT_EQ(mesh.triangleLayer.size(), mesh.surface.size());
  std::array<int, 3> count{};
  for (int layer : mesh.triangleLayer) {
    ASSERT_TRUE(layer >= 0 && layer <= 2);
    ++count[layer];
  }
  EXPECT_EQ(count[0], count[1]);
  EXPECT_EQ(count[2], 4 * static_cast<int>(mesh.rim.size())) << "two cuts, two triangles a column";
}

void expectRimAndFarEnd(const TetMesh& mesh) {
  Vec3 centre = Vec3::Zero();
  double turn = 0.0;  // [m^2] twice the area that the rim encloses, positive when counter-clockwise seen from +z
  for (std::size_t i = 0; i < mesh.rim.size(); ++i) {
    const Vec3 &a = mesh.vertices[mesh.rim[i]], &b = mesh.vertices[mesh.rim[(i + 1) % mesh.rim.size()]];
    centre += a / static_cast<double>(mesh.rim.size());
    turn += a.x() * b.y() - a.y() * b.x();
    EXPECT_NEAR(a.z(), 0.0, 1e-9) << "the rim is a plane cut";
    EXPECT_LT((b - a).norm(), 12e-3) << "neighbours on the rim are neighbours in space";
  }
  EXPECT_LT(centre.norm(), 1e-9);
  EXPECT_GT(turn, 0.0);
  EXPECT_EQ(mesh.fixed.size(), 2 * mesh.rim.size());
  EXPECT_TRUE(std::is_sorted(mesh.fixed.begin(), mesh.fixed.end()));
  double depth = 0.0;  // [m]
  for (int vertex : mesh.fixed) depth += mesh.vertices[vertex].z() / static_cast<double>(mesh.fixed.size());
  EXPECT_LT(depth, -1e-3) << "the tube runs to -z";
}

template <typename T>
void addBytes(const std::vector<T>& values, std::uint64_t& hash) {
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  for (std::size_t i = 0; i < values.size() * sizeof(T); ++i) hash = (hash ^ bytes[i]) * 1099511628211ULL;
}

/// Ericson 2005, Real-Time Collision Detection, 5.1.5.
double distanceToTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {  // [m]
  const auto toSegment = [&](const Vec3& from, const Vec3& to) {
    const double share = std::clamp((p - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);  // [1]
    return (p - from - share * (to - from)).norm();
  };
  const Vec3 normal = (b - a).cross(c - a).normalized();
  const bool inside = normal.dot((b - a).cross(p - a)) >= 0 && normal.dot((c - b).cross(p - b)) >= 0 && normal.dot((a - c).cross(p - c)) >= 0;
  if (inside) return std::abs(normal.dot(p - a));
  return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

std::vector<double> distancesToOuterLayer(const TetMesh& mesh) {  // [m]
  std::vector<double> distances;  // [m]
  for (std::size_t v = 1; v < mesh.vertices.size(); v += 2) {
    double least = 1.0;  // [m]
    for (std::size_t t = 0; t < mesh.surface.size(); ++t) {
      const auto& [a, b, c] = mesh.surface[t];
      if (mesh.triangleLayer[t] == 0)
        least = std::min(least, distanceToTriangle(mesh.vertices[v], mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
    }
    distances.push_back(least);
  }
  return distances;
}

}  // namespace

void expectWholeWall(const TetMesh& mesh) {
  ASSERT_FALSE(mesh.tets.empty());
  ASSERT_EQ(mesh.uv.size(), mesh.vertices.size());
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) EXPECT_GT(volume(mesh, t), 0.0);
  expectConforming(mesh);
  expectClosedSurface(mesh);
  expectOutward(mesh);
  expectLayers(mesh);
  expectRimAndFarEnd(mesh);
}

void expectRefused(const std::function<void()>& read, const std::vector<std::string>& parts) {
  try {
    read();
    ADD_FAILURE() << "accepted, expected a refusal with '" << (parts.empty() ? "" : parts.front()) << "'";
  } catch (const scenes::InputError& error) {
    const std::string line = error.what();
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    for (const std::string& part : parts) EXPECT_NE(line.find(part), std::string::npos) << "'" << part << "' is not in: " << line;
  }
}

std::uint64_t bitsOf(const TetMesh& mesh) {
  std::uint64_t hash = 14695981039346656037ULL;
  addBytes(mesh.vertices, hash);
  addBytes(mesh.tets, hash);
  addBytes(mesh.surface, hash);
  addBytes(mesh.triangleLayer, hash);
  addBytes(mesh.uv, hash);
  addBytes(mesh.fixed, hash);
  addBytes(mesh.rim, hash);
  return hash;
}

double worstQuality(const TetMesh& mesh) {
  double worst = 1.0;  // [1]
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) worst = std::min(worst, scenes::tetQuality(mesh, t));
  return worst;
}

double largestDistanceToOuterLayer(const TetMesh& mesh) {
  const std::vector<double> distances = distancesToOuterLayer(mesh);  // [m]
  return *std::max_element(distances.begin(), distances.end());
}

double leastDistanceToOuterLayer(const TetMesh& mesh) {
  const std::vector<double> distances = distancesToOuterLayer(mesh);  // [m]
  return *std::min_element(distances.begin(), distances.end());
}

}  // namespace halsted::testing
