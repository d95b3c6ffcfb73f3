#include "render/tissue_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/color.h"
#include "render/noise.h"

namespace halsted::render {
namespace {

enum Layer : int { kSerosa = 0, kMucosa = 1, kCut = 2 };
constexpr double kTile = 38e-3;                           // [m] side of a texture tile: three go around a colon

struct Look {
  float uv[2];                                            // [1] in tiles
  std::uint8_t color[4];                                  // square root of reflectance; sky
  std::uint8_t surface[4];                                // vessels, bumps, gloss, 1 in the lumen
};

struct RestShape {                                        // of the whole organ, for colours that vary over it
  double top = 0.0, bottom = 0.0;                         // [m] along z
  double radius = 0.0;                                    // [m] mean of the lumen at the rim
};

RestShape restShape(const RenderScene& scene) {
  RestShape r{-1e9, 1e9, 0.0};
  for (const Vec3& p : scene.tissueRest) { r.top = std::max(r.top, p.z()); r.bottom = std::min(r.bottom, p.z()); }
  double sum = 0.0;                                       // [m]
  int count = 0;
  for (std::size_t t = 0; t < scene.surface.size(); ++t) {
    if (t >= scene.triangleLayer.size() || scene.triangleLayer[t] != kMucosa) continue;
    for (int v : scene.surface[t]) {
      const Vec3& p = scene.tissueRest[v];
      if (p.z() < r.top - 0.2 * (r.top - r.bottom)) continue;
      sum += std::hypot(p.x(), p.y());
      ++count;
    }
  }
  r.radius = count ? sum / count : 0.0;
  return r;
}

struct Shading { Vec3 color; double sky, vessels, bumps, gloss; };                     // all [1]

Shading serosa(const Vec3& p, double turn, const RestShape& rest) {                    // [m], [1]
  const Vec3 q = 90.0 * p;                                                             // features of a centimetre
  const double blush = fractalNoise(q.x(), q.y(), q.z(), 3);                           // [1]
  Vec3 color = mixed(Vec3(0.66, 0.32, 0.26), Vec3(0.56, 0.16, 0.14), smoothStep(0.32, 0.68, blush));
  const double third = std::abs(turn * 3.0 - std::round(turn * 3.0)) / 3.0;            // [1] turn to the nearest taenia coli
  color = mixed(color, Vec3(0.76, 0.46, 0.38), 0.55 * smoothStep(0.035, 0.015, third));
  const double fat = smoothStep(0.56, 0.66, fractalNoise(1.3 * q.x() + 7, 1.3 * q.y(), 0.8 * q.z(), 3)) * smoothStep(0.10, 0.05, third);
  color = mixed(color, Vec3(0.74, 0.50, 0.20), 0.55 * fat);                            // a few fatty tags beside the taeniae
  const double down = smoothStep(rest.bottom + 0.02 * (rest.top - rest.bottom), rest.bottom + 0.45 * (rest.top - rest.bottom), p.z());
  return {color, 0.25 + 0.75 * down, 0.95 * (1.0 - 0.6 * fat), 0.42 + 0.4 * fat, 1.0};
}

Shading mucosa(const Vec3& p, const RestShape& rest) {
  const Vec3 q = 120.0 * p;
  const double blush = fractalNoise(q.x() + 40, q.y(), q.z(), 3);                      // [1]
  const double depth = rest.top - p.z();                                               // [m]
  const Vec3 color = mixed(Vec3(0.72, 0.25, 0.19), Vec3(0.58, 0.10, 0.09), smoothStep(0.3, 0.7, blush));
  const double sky = std::exp(-depth / std::max(0.9 * rest.radius, 1e-3));             // [1] what a deep tube sees of the sky
  return {color, 0.05 + 0.90 * sky, 0.35, 1.0, 1.0};
}

Shading cutEdge(const Vec3& p) {
  const Vec3 q = 260.0 * p;
  const double blood = smoothStep(0.48, 0.66, fractalNoise(q.x(), q.y(), q.z(), 3));   // [1]
  return {mixed(Vec3(0.74, 0.42, 0.33), Vec3(0.45, 0.045, 0.035), 0.9 * blood), 0.95, 0.35, 0.55, 0.85};
}

Look lookOf(const SkinCorner& corner, const Vec3& rest, const RestShape& shape) {      // [m]
  const Shading s = corner.layer == kMucosa ? mucosa(rest, shape) : corner.layer == kCut ? cutEdge(rest) : serosa(rest, corner.uv[0], shape);
  float u = 3.0f * corner.uv[0], v = static_cast<float>(corner.uv[1] / kTile);         // [1]
  if (corner.layer == kCut) { u = static_cast<float>(rest.x() / kTile); v = static_cast<float>(rest.y() / kTile); }   // seen end on
  return {{u, v},
          {rootByteOf(s.color.x()), rootByteOf(s.color.y()), rootByteOf(s.color.z()), byteOf(s.sky)},
          {byteOf(s.vessels), byteOf(s.bumps), byteOf(s.gloss), byteOf(corner.layer == kMucosa)}};
}

}  // namespace

TissueSurface::TissueSurface(const RenderScene& scene, std::size_t triangleBudget)
    : skin_(buildSkin(scene.surface, scene.triangleLayer, scene.surfaceUv, scene.tissueRest.size(), triangleBudget)),
      pose_(skin_), mesh_{makeArray(), makeBuffer(), {}, 0}, coarse_{makeArray(), makeBuffer(), {}, 0}, looks_(makeBuffer()), stream_(6 * skin_.corners.size()) {
  pose_.update(skin_, scene.tissueRest);
  const RestShape rest = restShape(scene);
  openingAtRest_ = std::numbers::pi * rest.radius * rest.radius;
  std::vector<Look> looks;
  looks.reserve(skin_.corners.size());
  for (const SkinCorner& c : skin_.corners) {
    const float* p = pose_.point(c.point);                // [m]
    looks.push_back(lookOf(c, Vec3(p[0], p[1], p[2]), rest));
  }
  glBindVertexArray(mesh_.array);
  describe(mesh_.vertices, 6 * sizeof(float), {{0, 3, 0}, {1, 3, 3 * sizeof(float)}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(stream_.size() * sizeof(float)), nullptr, GL_STREAM_DRAW);
  describe(looks_, sizeof(Look), {{2, 2, offsetof(Look, uv)}, {3, 4, offsetof(Look, color), GL_UNSIGNED_BYTE},
           {4, 4, offsetof(Look, surface), GL_UNSIGNED_BYTE}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(looks.size() * sizeof(Look)), looks.data(), GL_STATIC_DRAW);
  std::vector<std::uint32_t> indices;
  for (const auto& t : skin_.triangles) indices.insert(indices.end(), t.begin(), t.end());
  uploadIndices(mesh_, indices);

  glBindVertexArray(coarse_.array);
  describe(coarse_.vertices, 4 * sizeof(float), {{0, 3, 0}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(pose_.particles().size() * sizeof(float)), nullptr, GL_STREAM_DRAW);
  indices.clear();
  for (const auto& t : scene.surface) indices.insert(indices.end(), t.begin(), t.end());
  uploadIndices(coarse_, indices);
}

void TissueSurface::update(const std::vector<Vec3>& particles) {
  pose_.update(skin_, particles);
  for (std::size_t i = 0; i < skin_.corners.size(); ++i) {
    std::copy_n(pose_.point(skin_.corners[i].point), 3, &stream_[6 * i]);
    std::copy_n(pose_.normal(skin_.corners[i].normalSlot), 3, &stream_[6 * i + 3]);
  }
  mesh_.stream(stream_.data(), stream_.size() * sizeof(float));
  coarse_.stream(pose_.particles().data(), pose_.particles().size() * sizeof(float));
}

}  // namespace halsted::render
