#include "scenes/harmonics/sphere_map.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "scenes/input_text.h"

namespace halsted::scenes {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr int kMostFlowSteps = 100;
constexpr double kFlowStep = 0.0005;             // [1] of the surface's area; tuned: the torso is star-shaped after a few steps
constexpr double kLeastSlope = 0.03;           // [1] cosine between a triangle's normal and its direction from the centre
constexpr double kMostHidden = 1e-3;           // [1] of the area

/// Cotangent stiffness of the original surface (Pinkall and Polthier 1993). Slivers are held to |cot| <= 50.
Triplets cotangents(const Surface& s) {
  Triplets entries;
  for (const auto& t : s.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const Vec3 u = s.vertices[a] - s.vertices[t[k]], v = s.vertices[b] - s.vertices[t[k]];   // [m]
      const double twice = u.cross(v).norm();  // [m^2]
      const double w = 0.5 * std::clamp(u.dot(v) / std::max(twice, 1e-30), -50.0, 50.0);       // [1]
      entries.insert(entries.end(), {{a, b, -w}, {b, a, -w}, {a, a, w}, {b, b, w}});
    }
  return entries;
}

/// Consistent mass of the present surface, as in the paper.
Triplets masses(const Surface& s) {
  Triplets entries;
  for (const auto& t : s.triangles) {
    const double area = 0.5 * (s.vertices[t[1]] - s.vertices[t[0]]).cross(s.vertices[t[2]] - s.vertices[t[0]]).norm();   // [m^2]
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) entries.emplace_back(t[i], t[j], area / (i == j ? 6.0 : 12.0));
  }
  return entries;
}

double totalArea(const Surface& s) {
  double sum = 0.0;                            // [m^2]
  for (double a : vertexAreas(s)) sum += a;
  return sum;
}

/// Moves the centre of the surface's area to the origin and makes the area 1.
void normalise(Surface& s) {
  const std::vector<double> area = vertexAreas(s);   // [m^2]
  double total = 0.0;                          // [m^2]
  Vec3 centre = Vec3::Zero();                  // [m^3]
  for (std::size_t v = 0; v < area.size(); ++v) { total += area[v]; centre += area[v] * s.vertices[v]; }
  centre /= total;
  const double scale = 1.0 / std::sqrt(total);   // [1/m]
  for (Vec3& p : s.vertices) p = scale * (p - centre);
}

/// Share of the original area whose triangles do not face away from the origin: almost none when the surface is star-shaped. A sliver's
/// normal is noise, so a thousandth is let pass.
double hiddenShare(const Surface& s, const std::vector<double>& original) {   // original [1] share of each triangle
  double hidden = 0.0;                         // [1]
  for (std::size_t t = 0; t < original.size(); ++t) {
    const auto& [a, b, c] = s.triangles[t];
    const Vec3 n = (s.vertices[b] - s.vertices[a]).cross(s.vertices[c] - s.vertices[a]), middle = s.vertices[a] + s.vertices[b] + s.vertices[c];
    if (!(n.dot(middle) > kLeastSlope * n.norm() * middle.norm())) hidden += original[t];
  }
  return hidden;
}

std::vector<double> triangleShares(const Surface& s) {   // [1]
  std::vector<double> share;                   // [1]
  const double total = totalArea(s);           // [m^2]
  for (const auto& [a, b, c] : s.triangles)
    share.push_back(0.5 * (s.vertices[b] - s.vertices[a]).cross(s.vertices[c] - s.vertices[a]).norm() / total);
  return share;
}

/// Outward triangles: a surface turned inside out is turned back for the map.
Surface outward(const Surface& s) {
  double volume = 0.0;                         // [m^3]
  for (const auto& [a, b, c] : s.triangles) volume += s.vertices[a].dot(s.vertices[b].cross(s.vertices[c]));
  Surface out = s;
  if (volume < 0.0) for (auto& t : out.triangles) std::swap(t[1], t[2]);
  return out;
}

int countFlipped(const Surface& s, const std::vector<Vec3>& unit) {
  int flipped = 0;
  for (const auto& [a, b, c] : s.triangles) flipped += !(unit[a].dot(unit[b].cross(unit[c])) > 0.0);
  return flipped;
}

double areaSpread(const Surface& s, const std::vector<Vec3>& unit) {
  Surface sphere = s;
  sphere.vertices = unit;
  const std::vector<double> area = vertexAreas(s), image = vertexAreas(sphere);   // [m^2], [1]
  const double ratio = totalArea(s) / totalArea(sphere);   // [m^2]
  double sum = 0.0, total = 0.0;               // [m^2]
  for (std::size_t v = 0; v < area.size(); ++v) {
    const double off = image[v] * ratio / std::max(area[v], 1e-300) - 1.0;   // [1]
    sum += area[v] * off * off;
    total += area[v];
  }
  return std::sqrt(sum / total);
}

}  // namespace

std::vector<Vec3> flowToSphere(const Surface& original, const std::string& origin, int& steps) {
  Surface s = original;
  normalise(s);
  const int n = static_cast<int>(s.vertices.size());
  Sparse stiffness(n, n);
  const Triplets weights = cotangents(s);
  stiffness.setFromTriplets(weights.begin(), weights.end());
  Eigen::SimplicialLDLT<Sparse> solver;
  solver.analyzePattern(stiffness);
  const std::vector<double> share = triangleShares(original);   // [1]
  for (steps = 0; hiddenShare(s, share) > kMostHidden; ++steps) {
    if (steps == kMostFlowSteps) throw InputError(origin + ": the surface does not open into a sphere");
    Sparse mass(n, n);
    const Triplets entries = masses(s);
    mass.setFromTriplets(entries.begin(), entries.end());
    solver.factorize(mass + kFlowStep * stiffness);
    if (solver.info() != Eigen::Success) throw InputError(origin + ": the surface has degenerate triangles");
    for (int axis = 0; axis < 3; ++axis) {
      Eigen::VectorXd x(n);
      for (int v = 0; v < n; ++v) x[v] = s.vertices[v][axis];
      const Eigen::VectorXd moved = solver.solve(mass * x);
      for (int v = 0; v < n; ++v) s.vertices[v][axis] = moved[v];
    }
    normalise(s);
  }
  for (Vec3& p : s.vertices) p.normalize();
  return s.vertices;
}

SphereMap mapToSphere(const Surface& surface, const std::string& origin) {
  requireSphereLike(surface, origin);
  const Surface s = outward(surface);
  SphereMap map;
  map.unit = flowToSphere(s, origin, map.flowSteps);
  map.areaSteps = equaliseArea(vertexAreas(s), map.unit);
  map.flipped = countFlipped(s, map.unit);
  map.areaSpread = areaSpread(s, map.unit);
  return map;
}

}  // namespace halsted::scenes
