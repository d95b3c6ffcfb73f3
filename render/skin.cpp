#include "render/skin.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "render/subdivide.h"

namespace halsted::render {
namespace {

constexpr double kLeastWeight = 2e-3;        // [1] smaller ones move nothing that a pixel could show
constexpr int kMostLevels = 3;

ControlMesh controlMesh(const std::vector<std::array<int, 3>>& surface, const std::vector<int>& layers,
                        const std::vector<Eigen::Vector2d>& uv, std::size_t particles) {
  ControlMesh mesh;
  mesh.rows.resize(particles);
  for (std::uint32_t v = 0; v < particles; ++v) mesh.rows[v] = {{v, 1.0}};
  for (std::size_t t = 0; t < surface.size(); ++t) {
    std::array<std::uint32_t, 3> corner{};
    std::array<std::array<double, 2>, 3> at{};           // (turn [1], length [m])
    for (int k = 0; k < 3; ++k) {
      if (surface[t][k] < 0 || surface[t][k] >= static_cast<int>(particles))
        throw std::invalid_argument("surface triangle " + std::to_string(t) + " names a particle that does not exist");
      corner[k] = static_cast<std::uint32_t>(surface[t][k]);
      if (corner[k] < uv.size()) at[k] = {uv[corner[k]].x(), uv[corner[k]].y()};
    }
    const double most = std::max({at[0][0], at[1][0], at[2][0]});                        // [1]
    for (auto& p : at)
      if (most - p[0] > 0.5) p[0] += 1.0;                // across the seam: go on counting
    mesh.triangles.push_back(corner);
    mesh.uv.push_back(at);
    mesh.layers.push_back(t < layers.size() ? layers[t] : 0);
  }
  return mesh;
}

/// Moves the control points out by as much as subdivision pulls them in, so that a needle hole stays on the drawn surface.
void interpolateOnce(ControlMesh& fine, std::size_t particles) {
  std::vector<WeightRow> control(particles);
  for (std::uint32_t v = 0; v < particles; ++v) {
    control[v] = {{v, 2.0}};
    addRow(control[v], fine.rows[v], -1.0);
  }
  for (WeightRow& row : fine.rows) {
    WeightRow sum;
    for (const auto& [particle, weight] : row) addRow(sum, control[particle], weight);
    row = std::move(sum);
  }
}

SkinWeights pack(const ControlMesh& fine) {
  SkinWeights out;
  out.start.push_back(0);
  for (const WeightRow& row : fine.rows) {
    double kept = 0.0;                                   // [1]
    for (const auto& [particle, weight] : row) kept += std::abs(weight) >= kLeastWeight ? weight : 0.0;
    for (const auto& [particle, weight] : row) {
      if (std::abs(weight) < kLeastWeight) continue;
      out.particle.push_back(particle);
      out.weight.push_back(static_cast<float>(weight / kept));
    }
    out.start.push_back(static_cast<std::uint32_t>(out.particle.size()));
  }
  return out;
}

/// Corners that differ in layer or by a turn across the seam are drawn apart.
void addCorners(const ControlMesh& fine, Skin& skin) {
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> slots;
  std::map<std::array<std::int64_t, 3>, std::uint32_t> known;
  for (std::size_t t = 0; t < fine.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> triangle{};
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t point = fine.triangles[t][k];
      const auto& uv = fine.uv[t][k];
      const auto slot = slots.try_emplace({point, fine.layers[t]}, static_cast<std::uint32_t>(slots.size())).first->second;
      const auto [found, fresh] = known.try_emplace({point, fine.layers[t], std::llround(uv[0] * 4096.0)},
                                                    static_cast<std::uint32_t>(skin.corners.size()));
      if (fresh)
        skin.corners.push_back({point, slot, {static_cast<float>(uv[0]), static_cast<float>(uv[1])}, fine.layers[t]});
      triangle[k] = found->second;
    }
    skin.triangles.push_back(triangle);
  }
  skin.normalSlots = static_cast<std::uint32_t>(slots.size());
}

}  // namespace

Skin buildSkin(const std::vector<std::array<int, 3>>& surface, const std::vector<int>& layers,
               const std::vector<Eigen::Vector2d>& uv, std::size_t particles, std::size_t triangleBudget) {
  Skin skin;
  ControlMesh mesh = controlMesh(surface, layers, uv, particles);
  while (skin.levels < kMostLevels && 4 * mesh.triangles.size() <= triangleBudget) {
    mesh = subdivide(mesh);
    ++skin.levels;
  }
  if (skin.levels > 0) interpolateOnce(mesh, particles);
  skin.weights = pack(mesh);
  addCorners(mesh, skin);
  return skin;
}

void allowCuts(const std::vector<std::array<int, 3>>& surface, std::size_t particles, Skin& skin) {
  ControlMesh mesh = controlMesh(surface, {}, {}, particles);
  for (int level = 0; level < skin.levels; ++level) mesh = subdivide(mesh, Rule::kFlat);
  skin.flat = pack(mesh);
}

SkinPose::SkinPose(const Skin& skin) : points_(4 * (skin.weights.start.size() - 1)), normals_(4 * skin.normalSlots) {}

float SkinPose::at(const Skin& skin, std::uint32_t row, const std::vector<float>& ofParticle) const {
  const SkinWeights& w = weightsOf(skin, row);
  float sum = 0.0f;                                      // [1]
  for (std::uint32_t j = w.start[row]; j < w.start[row + 1]; ++j) sum += w.weight[j] * ofParticle[w.particle[j]];
  return sum;
}

void SkinPose::tear(const Skin& skin, const std::vector<std::array<int, 3>>& surface, const std::vector<std::uint8_t>& shown) {
  shown_ = shown;
  atCut_.assign(particles_.size() / 4, 0);
  for (std::size_t t = 0; t < surface.size(); ++t)
    if (!shown[t])
      for (int v : surface[t]) atCut_[static_cast<std::size_t>(v)] = 1;
  torn_.assign(points_.size() / 4, 0);
  for (std::size_t t = 0; t < skin.triangles.size(); ++t) {
    const std::size_t whole = skin.surfaceTriangleOf(t);
    const auto& v = surface[whole];
    if (!shown[whole] || !(atCut_[v[0]] || atCut_[v[1]] || atCut_[v[2]])) continue;
    for (std::uint32_t corner : skin.triangles[t]) torn_[skin.corners[corner].point] = 1;
  }
}

void SkinPose::update(const Skin& skin, const std::vector<Vec3>& particles) {
  particles_.resize(4 * particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (int k = 0; k < 3; ++k) particles_[4 * i + k] = static_cast<float>(particles[i][k]);

  const std::size_t rows = skin.weights.start.size() - 1;
  for (std::size_t r = 0; r < rows; ++r) {
    const SkinWeights& w = weightsOf(skin, r);
    float sum[4] = {};                                   // [m] four lanes, so that the compiler uses one vector register
    for (std::uint32_t j = w.start[r]; j < w.start[r + 1]; ++j) {
      const float* p = &particles_[4 * w.particle[j]];   // [m]
      for (int k = 0; k < 4; ++k) sum[k] += w.weight[j] * p[k];
    }
    std::copy(sum, sum + 4, &points_[4 * r]);
  }

  // Area-weighted face normals, gathered per layer so that the cut rim keeps its edges.
  std::fill(normals_.begin(), normals_.end(), 0.0f);
  for (std::size_t i = 0; i < skin.triangles.size(); ++i) {
    if (!shown_.empty() && !shown_[skin.surfaceTriangleOf(i)]) continue;
    const auto& t = skin.triangles[i];
    const float *a = point(skin.corners[t[0]].point), *b = point(skin.corners[t[1]].point), *c = point(skin.corners[t[2]].point);
    const float u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};   // [m]
    const float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};         // [m^2]
    for (const std::uint32_t corner : t)
      for (int k = 0; k < 3; ++k) normals_[4 * skin.corners[corner].normalSlot + k] += n[k];
  }
  for (std::size_t i = 0; i < normals_.size(); i += 4) {
    float* n = &normals_[i];
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);   // [m^2]
    if (length > 0.0f)
      for (int k = 0; k < 3; ++k) n[k] /= length;
  }
}

}  // namespace halsted::render
