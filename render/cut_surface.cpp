#include "render/cut_surface.h"

#include <algorithm>
#include <cstddef>

#include "render/color.h"

namespace halsted::render {

namespace {

constexpr double kTile = 22e-3;              // [m] of the texture that roughens a burnt face
constexpr float kLeastChar = 0.45f;          // [1] of a face that a blade has just gone along: what it touched is not raw
const Vec3 kRaw(0.60, 0.26, 0.20);           // linear reflectance of muscle cut across [1]

}  // namespace

std::size_t boundaryTriangles(const RenderScene& scene) {
  const auto first = std::find(scene.triangleLayer.begin(), scene.triangleLayer.end(), kCutFaceLayer);
  if (first == scene.triangleLayer.end()) return scene.surface.size();   // a scene may name no layers
  return std::min(scene.surface.size(), static_cast<std::size_t>(first - scene.triangleLayer.begin()));
}

CutSurface::CutSurface(const RenderScene& scene)
    : triangles_(scene.surface), boundary_(boundaryTriangles(scene)),
      exposed_(boundary_, 1), mesh_{makeArray(), makeBuffer(), {}, 0} {
  if (!present()) return;
  ofParticle_.resize(scene.tissueRest.size());
  onFaces_.resize(scene.tissueRest.size());
  const std::size_t faces = triangles_.size() - boundary_;
  stream_.reserve(3 * faces);
  glBindVertexArray(mesh_.array);
  describe(mesh_.vertices, sizeof(Vertex), {{0, 3, offsetof(Vertex, position)}, {1, 3, offsetof(Vertex, normal)}, {2, 2, offsetof(Vertex, uv)},
           {3, 4, offsetof(Vertex, color), GL_UNSIGNED_BYTE}, {4, 4, offsetof(Vertex, surface), GL_UNSIGNED_BYTE}, {5, 1, offsetof(Vertex, charred)}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(3 * faces * sizeof(Vertex)), nullptr, GL_STREAM_DRAW);
}

void CutSurface::charParticles(const RenderSnapshot& snapshot) {
  std::fill(ofParticle_.begin(), ofParticle_.end(), 0.0f);
  std::fill(onFaces_.begin(), onFaces_.end(), Mean{});
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const float heat = std::min(1.0f, static_cast<float>(snapshot.charred[t]));   // [1]
    const bool face = t >= boundary_ && snapshot.exposed[t];
    if (heat <= 0.0f && !face) continue;
    for (int v : triangles_[t]) {
      const auto at = static_cast<std::size_t>(v);
      ofParticle_[at] = std::max(ofParticle_[at], heat);
      if (face) onFaces_[at] = {onFaces_[at].sum + heat, onFaces_[at].count + 1.0f};
    }
  }
}

void CutSurface::addFace(std::size_t triangle, const RenderSnapshot& snapshot) {
  const auto& corners = triangles_[triangle];
  const Vec3 &a = snapshot.tissue[corners[0]], &b = snapshot.tissue[corners[1]], &c = snapshot.tissue[corners[2]];
  const Vec3 normal = (b - a).cross(c - a).normalized();
  for (int corner : corners) {
    const Vec3& p = snapshot.tissue[corner];
    Vertex v{};
    for (int k = 0; k < 3; ++k) {
      v.position[k] = static_cast<float>(p[k]);
      v.normal[k] = static_cast<float>(normal[k]);
      v.color[k] = rootByteOf(kRaw[k]);
    }
    v.uv[0] = static_cast<float>((p.x() + p.z()) / kTile);
    v.uv[1] = static_cast<float>((p.y() - 0.5 * p.z()) / kTile);
    v.color[3] = byteOf(0.7);
    v.surface[1] = byteOf(0.9);
    v.surface[2] = byteOf(0.6);
    const Mean& heat = onFaces_[static_cast<std::size_t>(corner)];
    v.charred = std::clamp(heat.sum / heat.count, kLeastChar, 1.0f);
    stream_.push_back(v);
  }
}

bool CutSurface::update(const RenderSnapshot& snapshot, bool& changed) {
  changed = false;
  if (!present() || snapshot.exposed.size() != triangles_.size() || snapshot.charred.size() != triangles_.size()) return false;
  changed = !std::equal(exposed_.begin(), exposed_.end(), snapshot.exposed.begin());
  std::copy_n(snapshot.exposed.begin(), boundary_, exposed_.begin());
  charParticles(snapshot);
  stream_.clear();
  for (std::size_t t = boundary_; t < triangles_.size(); ++t)
    if (snapshot.exposed[t]) addFace(t, snapshot);
  mesh_.stream(stream_.data(), stream_.size() * sizeof(Vertex));
  return true;
}

void CutSurface::draw() const {
  if (stream_.empty()) return;
  glBindVertexArray(mesh_.array);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(stream_.size()));
}

}  // namespace halsted::render
