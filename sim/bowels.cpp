#include "sim/bowels.h"

#include <numeric>

#include "sim/union_find.h"

namespace halsted {
namespace {

/// The mesh's own word, else the connected pieces in the order of their first vertex.
void numberPieces(const TetMesh& mesh, Bowels& b) {
  if (!mesh.bowel.empty()) {
    b.of = mesh.bowel;
    for (int bowel : b.of) b.count = bowel >= b.count ? bowel + 1 : b.count;
    return;
  }
  std::vector<int> parent(mesh.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const auto& tet : mesh.tets)
    for (int c = 1; c < 4; ++c) join(parent, tet[0], tet[c]);
  std::vector<int> number(parent.size(), -1);
  for (std::size_t v = 0; v < parent.size(); ++v) {
    const int root = rootOf(parent, static_cast<int>(v));
    if (number[root] < 0) number[root] = b.count++;
    b.of.push_back(number[root]);
  }
}

/// One bowel alone lies round the world's axes by construction; of two, the top is the world's.
Opening openingOf(const Bowels& b, int bowel, std::span<const Vec3> x) {
  Opening o;
  if (b.count < 2 || b.rim[bowel].size() < 3) return o;
  const auto& rim = b.rim[bowel];
  o.centre = centreOf(rim, x);
  Vec3 area = Vec3::Zero();                    // [m^2] twice
  for (std::size_t i = 0; i < rim.size(); ++i) area += (x[rim[i]] - o.centre).cross(x[rim[(i + 1) % rim.size()]] - o.centre);
  o.axis = area.normalized();
  o.up = (Vec3::UnitY() - o.axis.y() * o.axis).normalized();
  o.right = o.up.cross(o.axis);
  return o;
}

}  // namespace

Bowels findBowels(const TetMesh& mesh) {
  Bowels b;
  numberPieces(mesh, b);
  b.rim.resize(static_cast<std::size_t>(b.count));
  for (int v : mesh.rim) b.rim[b.of[v]].push_back(v);
  for (int bowel = 0; bowel < b.count; ++bowel) b.opening.push_back(openingOf(b, bowel, mesh.vertices));
  b.wallDepth.assign(mesh.vertices.size(), 0.5);
  for (const int layer : {1, 0}) {             // a corner of both, at a cut edge of a wall that is one tet thin, counts as serosa
    for (std::size_t f = 0; f < mesh.surface.size() && f < mesh.triangleLayer.size(); ++f) {   // a mesh may name none
      if (mesh.triangleLayer[f] != layer) continue;
      for (int v : mesh.surface[f]) b.wallDepth[v] = layer;
    }
  }
  return b;
}

Vec3 centreOf(std::span<const int> rim, std::span<const Vec3> x) {
  Vec3 sum = Vec3::Zero();
  for (int v : rim) sum += x[v];
  return sum / static_cast<double>(rim.size());
}

double enclosedArea(std::span<const int> rim, std::span<const Vec3> x) {
  const Vec3 centre = centreOf(rim, x);
  Vec3 area = Vec3::Zero();                    // [m^2] twice
  for (std::size_t i = 0; i < rim.size(); ++i) area += (x[rim[i]] - centre).cross(x[rim[(i + 1) % rim.size()]] - centre);
  return 0.5 * area.norm();
}

}  // namespace halsted
