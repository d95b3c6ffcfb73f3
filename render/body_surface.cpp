#include "render/body_surface.h"

#include <algorithm>
#include <cmath>

#include "render/body_look.h"
#include "render/color.h"
#include "render/light.h"
#include "render/noise.h"

namespace halsted::render {
namespace {

constexpr double kNear = 0.08;                           // [m] from the target: where marks are laid on the moving skin
constexpr std::size_t kFloats = 8;                       // of a corner

struct Look { std::uint8_t color[4]; };                  // linear reflectance under a square root; what the shader knows it as

bool isSkin(int layer) { return layer == static_cast<int>(TissueLook::kSkin); }
bool isSection(int layer) { return layer >= static_cast<int>(TissueLook::kSkinSection); }

/// How near the surface a thing is, and which tissue: see kSectionFragment.
double kindOf(int layer) {                               // [1]
  switch (static_cast<TissueLook>(layer)) {
    case TissueLook::kFat:
    case TissueLook::kFatSection: return 0.0;
    case TissueLook::kMuscle: return 0.35;
    case TissueLook::kMuscleSection: return 0.65;
    default: return 1.0;
  }
}

Vec3 skinColor(const Vec3& p) {                          // [m] -> linear reflectance [1]
  const Vec3 q = 45.0 * p;                               // [1] two centimetres a lobe
  const double blush = smoothStep(0.35, 0.68, fractalNoise(q.x() + 11.0, q.y(), q.z(), 3));   // [1]
  return mixed(kSkinPale, kSkinRosy, blush);
}

Look lookOf(int layer, const Vec3& p) {                  // [m] rest, picture space
  Vec3 color = Vec3::Ones();                             // [1]
  if (isSkin(layer)) color = skinColor(p);
  else color *= 1.0 - 0.55 * std::clamp(-p.z() / 26e-3, 0.0, 1.0);   // a cut is darker in its depth
  Look look{};
  for (int k = 0; k < 3; ++k) look.color[k] = rootByteOf(color[k]);
  look.color[3] = byteOf(kindOf(layer));
  return look;
}

/// Round the target by distance and direction: hardly stretched where one looks, and bounded on the far side.
std::array<float, 2> roundTarget(const float* p) {       // [m]
  const float across = std::sqrt(p[0] * p[0] + p[1] * p[1]), far = std::sqrt(across * across + p[2] * p[2]);   // [m]
  const float scale = across > 1e-9f ? far / across / static_cast<float>(kBodyTile) : 0.0f;   // [1/m]
  return {p[0] * scale, p[1] * scale};
}

/// On a wall of the cut: along it, and down.
std::array<float, 2> onWall(const Vec3& p) {             // [m]
  const double across = std::hypot(p.x(), p.y()), way = p.x() >= 0.0 ? across : -across;   // [m]
  return {static_cast<float>((way + 0.5 * p.y()) / kBodyTile), static_cast<float>(p.z() / kBodyTile)};
}

}  // namespace

BodySurface::BodySurface(const RenderScene& scene, const std::vector<Vec3>& rest)
    : skin_(buildSkin(scene.surface, scene.triangleLayer, scene.surfaceUv, rest.size(), 0)), pose_(skin_),
      mesh_{makeArray(), makeBuffer(), {}, 0}, looks_(makeBuffer()), stream_(kFloats * skin_.corners.size()) {
  std::vector<Look> looks;
  for (std::size_t i = 0; i < skin_.corners.size(); ++i) {
    const SkinCorner& c = skin_.corners[i];
    looks.push_back(lookOf(c.layer, rest[c.point]));
    const auto uv = onWall(rest[c.point]);               // [1]
    stream_[kFloats * i + 6] = uv[0];
    stream_[kFloats * i + 7] = uv[1];
  }
  glBindVertexArray(mesh_.array);
  describe(mesh_.vertices, kFloats * sizeof(float), {{0, 3, 0}, {1, 3, 3 * sizeof(float)}, {2, 2, 6 * sizeof(float)}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(stream_.size() * sizeof(float)), nullptr, GL_STREAM_DRAW);
  describe(looks_, sizeof(Look), {{3, 4, 0, GL_UNSIGNED_BYTE}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(looks.size() * sizeof(Look)), looks.data(), GL_STATIC_DRAW);
  uploadIndices(mesh_, {});
  std::vector<std::uint32_t> whole, cut, inside;
  for (std::size_t t = 0; t < skin_.triangles.size(); ++t) {
    const auto& corners = skin_.triangles[t];
    const auto shown = t < scene.body.shown.size() ? static_cast<Shown>(scene.body.shown[t]) : Shown::kAlways;
    const bool skin = isSkin(skin_.corners[corners[0]].layer);
    if (skin && shown != Shown::kCutaway) whole.insert(whole.end(), corners.begin(), corners.end());
    if (skin && shown != Shown::kWhole) cut.insert(cut.end(), corners.begin(), corners.end());
    if (!skin) inside.insert(inside.end(), corners.begin(), corners.end());
    if (skin && rest[skin_.corners[corners[0]].point].norm() < kNear) nearSkin_.push_back(corners);
  }
  skinWhole_ = uploadOtherIndices(whole);
  skinCut_ = uploadOtherIndices(cut);
  inside_ = uploadOtherIndices(inside);
  shadowed_.reserve(whole.size());
  room_ = makeIndexRoom(std::max(whole.size(), cut.size()));
  skinIndices_ = {std::move(whole), std::move(cut)};
  for (const Vec3& p : rest) lowest_ = std::min(lowest_, p.z());
  update(rest);
}

void BodySurface::update(const std::vector<Vec3>& particles) {
  pose_.update(skin_, particles);
  for (std::size_t i = 0; i < skin_.corners.size(); ++i) {
    const SkinCorner& c = skin_.corners[i];
    float* out = &stream_[kFloats * i];
    std::copy_n(pose_.point(c.point), 3, out);
    std::copy_n(pose_.normal(c.normalSlot), 3, out + 3);
    if (isSection(c.layer)) continue;                    // its texture is of the tissue at rest
    const auto uv = roundTarget(out);                    // [1]
    out[6] = uv[0];
    out[7] = uv[1];
  }
  mesh_.stream(stream_.data(), stream_.size() * sizeof(float));
}

void BodySurface::drawSkin(bool cutaway) const { mesh_.drawAs(cutaway ? skinCut_ : skinWhole_); }
void BodySurface::drawInside(bool cutaway) const {
  if (cutaway) mesh_.drawAs(inside_);
}

void BodySurface::drawShadowed(bool cutaway, const std::vector<CapsuleShape>& casters) {
  const LampPlane plane;
  const auto corner = [&](std::uint32_t c) { return Vec3(stream_[kFloats * c], stream_[kFloats * c + 1], stream_[kFloats * c + 2]); };   // [m]
  const std::vector<std::uint32_t>& all = skinIndices_[cutaway ? 1 : 0];
  shadowed_.clear();
  for (std::size_t t = 0; t + 2 < all.size(); t += 3) {
    const Vec3 a = corner(all[t]), b = corner(all[t + 1]), c = corner(all[t + 2]), middle = (a + b + c) / 3.0;   // [m]
    const double size = std::sqrt(std::max({(a - middle).squaredNorm(), (b - middle).squaredNorm(), (c - middle).squaredNorm()}));   // [m]
    const Eigen::Vector2d at = plane.at(middle);
    for (const CapsuleShape& caster : casters) {
      const Eigen::Vector2d from = plane.at(caster.a), way = plane.at(caster.b) - from;   // [m]
      const double t01 = std::clamp((at - from).dot(way) / std::max(way.squaredNorm(), 1e-18), 0.0, 1.0);   // [1]
      if (!((at - from - t01 * way).norm() < caster.radius + size)) continue;
      shadowed_.insert(shadowed_.end(), &all[t], &all[t] + 3);
      break;
    }
  }
  mesh_.drawOnly(shadowed_, room_);
}

double BodySurface::skinHeight(double x, double y, double otherwise) const {
  double best = -1e9;                                    // [m]
  for (const auto& t : nearSkin_) {
    const float *a = &stream_[kFloats * t[0]], *b = &stream_[kFloats * t[1]], *c = &stream_[kFloats * t[2]];   // [m]
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);                         // [m^2]
    if (!(area > 0.0)) continue;                         // seen from below
    const double u = ((x - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (y - a[1])) / area;                         // [1]
    const double v = ((b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1])) / area;                         // [1]
    if (u >= -1e-6 && v >= -1e-6 && u + v <= 1.0 + 1e-6) best = std::max(best, a[2] + u * (b[2] - a[2]) + v * (c[2] - a[2]));
  }
  return best > -1e8 ? best : otherwise;
}

}  // namespace halsted::render
