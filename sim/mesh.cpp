#include "sim/mesh.h"

#include <algorithm>
#include <stdexcept>

namespace halsted {
namespace {

/// Corners of the face opposite to corner f, counter-clockwise seen from outside a tet of positive volume.
constexpr int kFaceCorners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

/// A face of a tet with its corners sorted, so that both owners of a shared face compare equal.
struct Face {
  std::array<int, 3> corners;
  int tet, opposite;

  bool operator<(const Face& other) const {
    if (corners != other.corners) return corners < other.corners;
    return tet != other.tet ? tet < other.tet : opposite < other.opposite;
  }
};

std::vector<Face> sortedFaces(const std::vector<std::array<int, 4>>& tets) {
  std::vector<Face> faces;
  faces.reserve(4 * tets.size());
  for (int t = 0; t < static_cast<int>(tets.size()); ++t) {
    for (int f = 0; f < 4; ++f) {
      Face face{{tets[t][kFaceCorners[f][0]], tets[t][kFaceCorners[f][1]], tets[t][kFaceCorners[f][2]]}, t, f};
      std::sort(face.corners.begin(), face.corners.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// The six tets of a cell share its main diagonal 000-111; corner bits are x = 1, y = 2, z = 4. Odd permutations are swapped so
/// that all six have positive volume. The pattern repeats from cell to cell, so neighbouring cells agree on every face diagonal.
constexpr int kKuhnTets[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};

}  // namespace

std::array<int, 3> faceCorners(const std::array<int, 4>& tet, int opposite) {
  const auto& c = kFaceCorners[opposite];
  return {tet[c[0]], tet[c[1]], tet[c[2]]};
}

double volume(const TetMesh& mesh, int tet) {
  const auto& [a, b, c, d] = mesh.tets[tet];
  const Vec3& origin = mesh.vertices[a];
  const Vec3 area = (mesh.vertices[b] - origin).cross(mesh.vertices[c] - origin);
  return area.dot(mesh.vertices[d] - origin) / 6.0;
}

double volume(const TetMesh& mesh) {
  double sum = 0.0;  // [m^3]
  for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) sum += volume(mesh, t);
  return sum;
}

std::vector<std::array<int, 4>> faceNeighbours(const std::vector<std::array<int, 4>>& tets) {
  const std::vector<Face> faces = sortedFaces(tets);
  std::vector<std::array<int, 4>> neighbours(tets.size(), {-1, -1, -1, -1});
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
    if (faces[i].corners != faces[i + 1].corners) continue;
    if (i + 2 < faces.size() && faces[i].corners == faces[i + 2].corners)
      throw std::invalid_argument("tet mesh: three tets share one face");
    neighbours[faces[i].tet][faces[i].opposite] = faces[i + 1].tet;
    neighbours[faces[i + 1].tet][faces[i + 1].opposite] = faces[i].tet;
    ++i;
  }
  return neighbours;
}

std::vector<std::array<int, 3>> boundaryTriangles(const std::vector<std::array<int, 4>>& tets) {
  const std::vector<std::array<int, 4>> neighbours = faceNeighbours(tets);
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    for (int f = 0; f < 4; ++f) {
      if (neighbours[t][f] >= 0) continue;
      triangles.push_back({tets[t][kFaceCorners[f][0]], tets[t][kFaceCorners[f][1]], tets[t][kFaceCorners[f][2]]});
    }
  }
  return triangles;
}

TetMesh blockMesh(int nx, int ny, int nz, const Vec3& size) {
  if (nx < 1 || ny < 1 || nz < 1 || !(size.minCoeff() > 0.0)) throw std::invalid_argument("blockMesh: empty block");
  TetMesh mesh;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const Vec3 at(size.x() * i / nx, size.y() * j / ny, size.z() * k / nz);
        mesh.vertices.push_back(at);
        mesh.uv.emplace_back(at.x() / size.x(), at.z());
      }

  const auto index = [&](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int cell = 0; cell < nx * ny * nz; ++cell) {
    const int i = cell % nx, j = cell / nx % ny, k = cell / (nx * ny);
    std::array<int, 8> corner;
    for (int c = 0; c < 8; ++c) corner[c] = index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
    for (const auto& tet : kKuhnTets) mesh.tets.push_back({corner[tet[0]], corner[tet[1]], corner[tet[2]], corner[tet[3]]});
  }
  mesh.surface = boundaryTriangles(mesh.tets);
  mesh.triangleLayer.assign(mesh.surface.size(), 0);
  return mesh;
}

}  // namespace halsted
