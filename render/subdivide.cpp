#include "render/subdivide.h"

#include <algorithm>
#include <cmath>

namespace halsted::render {
namespace {

struct Edge {
  std::uint32_t a = 0, b = 0;                // a < b
  std::vector<std::uint32_t> triangles, opposite;
  bool crease = false;                       // layers meet here, or the surface ends
};

std::vector<Edge> edgesOf(const ControlMesh& mesh) {
  struct Use { std::uint32_t a, b, triangle, opposite; };
  std::vector<Use> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t p = mesh.triangles[t][k], q = mesh.triangles[t][(k + 1) % 3];
      uses.push_back({std::min(p, q), std::max(p, q), t, mesh.triangles[t][(k + 2) % 3]});
    }
  std::stable_sort(uses.begin(), uses.end(),
                   [](const Use& x, const Use& y) { return std::pair(x.a, x.b) < std::pair(y.a, y.b); });
  std::vector<Edge> edges;
  for (const Use& use : uses) {
    if (edges.empty() || edges.back().a != use.a || edges.back().b != use.b) edges.push_back({use.a, use.b, {}, {}, false});
    edges.back().triangles.push_back(use.triangle);
    edges.back().opposite.push_back(use.opposite);
  }
  for (Edge& e : edges)
    e.crease = e.triangles.size() != 2 || mesh.layers[e.triangles[0]] != mesh.layers[e.triangles[1]];
  return edges;
}

/// Warren's weight, Loop 1987 for valence 3 and 6 alike in the limit: smooth, and cheaper than the cosine.
double ringWeight(std::size_t valence) { return valence == 3 ? 3.0 / 16.0 : 3.0 / (8.0 * static_cast<double>(valence)); }

WeightRow edgePoint(const ControlMesh& mesh, const Edge& e, Rule rule) {
  WeightRow row;
  const bool straight = e.crease || rule == Rule::kFlat;
  const double own = straight ? 0.5 : 3.0 / 8.0;         // [1]
  addRow(row, mesh.rows[e.a], own);
  addRow(row, mesh.rows[e.b], own);
  if (!straight)
    for (std::uint32_t v : e.opposite) addRow(row, mesh.rows[v], 1.0 / 8.0);
  return row;
}

struct Ring { std::vector<std::uint32_t> all, crease; };

WeightRow vertexPoint(const ControlMesh& mesh, std::uint32_t v, const Ring& ring) {
  if (ring.all.empty() || (!ring.crease.empty() && ring.crease.size() != 2)) return mesh.rows[v];   // a corner stays
  WeightRow row;
  const auto& from = ring.crease.empty() ? ring.all : ring.crease;
  const double each = ring.crease.empty() ? ringWeight(ring.all.size()) : 1.0 / 8.0;                // [1]
  addRow(row, mesh.rows[v], 1.0 - each * static_cast<double>(from.size()));
  for (std::uint32_t n : from) addRow(row, mesh.rows[n], each);
  return row;
}

std::array<double, 2> middle(const std::array<double, 2>& p, const std::array<double, 2>& q) {
  return {0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])};
}

void splitTriangle(const ControlMesh& mesh, std::uint32_t t, const std::array<std::uint32_t, 3>& mid, ControlMesh& out) {
  const auto& v = mesh.triangles[t];
  const auto& uv = mesh.uv[t];
  const std::array<std::array<double, 2>, 3> m{middle(uv[0], uv[1]), middle(uv[1], uv[2]), middle(uv[2], uv[0])};
  for (int k = 0; k < 3; ++k) {
    const int last = (k + 2) % 3;
    out.triangles.push_back({v[k], mid[k], mid[last]});
    out.uv.push_back({uv[k], m[k], m[last]});
  }
  out.triangles.push_back(mid);
  out.uv.push_back(m);
  out.layers.insert(out.layers.end(), 4, mesh.layers[t]);
}

}  // namespace

void addRow(WeightRow& out, const WeightRow& row, double factor) {
  WeightRow sum;
  sum.reserve(out.size() + row.size());
  auto x = out.begin();
  for (const auto& [particle, weight] : row) {
    while (x != out.end() && x->first < particle) sum.push_back(*x++);
    const double before = x != out.end() && x->first == particle ? (x++)->second : 0.0;   // [1]
    sum.emplace_back(particle, before + factor * weight);
  }
  sum.insert(sum.end(), x, out.end());
  out = std::move(sum);
}

ControlMesh subdivide(const ControlMesh& mesh, Rule rule) {
  const std::vector<Edge> edges = edgesOf(mesh);
  std::vector<Ring> rings(mesh.rows.size());
  for (const Edge& e : edges)
    for (const auto& [v, n] : {std::pair(e.a, e.b), std::pair(e.b, e.a)}) {
      rings[v].all.push_back(n);
      if (e.crease) rings[v].crease.push_back(n);
    }

  ControlMesh out;
  out.rows.reserve(mesh.rows.size() + edges.size());
  for (std::uint32_t v = 0; v < mesh.rows.size(); ++v) out.rows.push_back(rule == Rule::kFlat ? mesh.rows[v] : vertexPoint(mesh, v, rings[v]));
  std::vector<std::array<std::uint32_t, 3>> mid(mesh.triangles.size());
  for (const Edge& e : edges) {
    const auto point = static_cast<std::uint32_t>(out.rows.size());
    out.rows.push_back(edgePoint(mesh, e, rule));
    for (std::uint32_t t : e.triangles)
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t p = mesh.triangles[t][k], q = mesh.triangles[t][(k + 1) % 3];
        if (std::min(p, q) == e.a && std::max(p, q) == e.b) mid[t][k] = point;
      }
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) splitTriangle(mesh, t, mid[t], out);
  return out;
}

}  // namespace halsted::render
