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
  bool everted = false;                                   // mucosa that faces away from the axis lies in the light
};

RestShape restShape(const RenderScene& scene) {
  RestShape r{-1e9, 1e9, 0.0, scene.perineum};
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

/// Of a bowel turned inside out: it lies in the light, swollen and deeper red toward the tip.
Shading evertedMucosa(const Vec3& p, const RestShape& rest) {                          // [m]
  const Vec3 q = 110.0 * p;
  const double blush = fractalNoise(q.x() + 40, q.y(), q.z(), 3), speckle = fractalNoise(4.0 * q.x(), 4.0 * q.y() + 9, 4.0 * q.z(), 2);   // [1]
  const double up = (p.z() - rest.bottom) / std::max(rest.top - rest.bottom, 1e-6);    // [1] 0 at the base
  Vec3 color = mixed(Vec3(0.70, 0.26, 0.21), Vec3(0.58, 0.12, 0.11), smoothStep(0.3, 0.7, blush));
  color = mixed(color, Vec3(0.52, 0.075, 0.085), 0.55 * smoothStep(0.35, 0.95, up));   // congested
  color = mixed(color, Vec3(0.42, 0.05, 0.06), 0.35 * smoothStep(0.60, 0.72, speckle));
  return {color, 0.35 + 0.65 * smoothStep(0.0, 0.25, up), 0.55, 1.0, 1.0};
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

/// A corner of the drawn skin at rest.
struct RestPoint { Vec3 place, normal; };                                              // [m], [1]

/// How far mucosa lies outside the bowel: 0 in the lumen, 1 on the outside of a prolapse.
double evertedShare(const RestPoint& at, const RestShape& shape) {                     // [1]
  if (!shape.everted) return 0.0;
  const double r = std::hypot(at.place.x(), at.place.y());                             // [m]
  return r > 0.0 ? smoothStep(-0.9, 0.1, (at.place.x() * at.normal.x() + at.place.y() * at.normal.y()) / r) : 0.0;
}

Shading mucosaOf(const RestPoint& at, double outside, const RestShape& shape) {
  const Shading in = mucosa(at.place, shape);
  if (outside <= 0.0) return in;
  const Shading out = evertedMucosa(at.place, shape);
  const auto mix = [&](double a, double b) { return a + outside * (b - a); };          // [1]
  return {mixed(in.color, out.color, outside), mix(in.sky, out.sky), mix(in.vessels, out.vessels), 1.0, 1.0};
}

Look lookOf(const SkinCorner& corner, const RestPoint& at, const RestShape& shape) {
  const bool inner = corner.layer == kMucosa;
  const double outside = inner ? evertedShare(at, shape) : 0.0;                        // [1]
  const Shading s = inner ? mucosaOf(at, outside, shape) : corner.layer == kCut ? cutEdge(at.place) : serosa(at.place, corner.uv[0], shape);
  float u = 3.0f * corner.uv[0], v = static_cast<float>(corner.uv[1] / kTile);         // [1]
  if (corner.layer == kCut) { u = static_cast<float>(at.place.x() / kTile); v = static_cast<float>(at.place.y() / kTile); }   // seen end on
  return {{u, v},
          {rootByteOf(s.color.x()), rootByteOf(s.color.y()), rootByteOf(s.color.z()), byteOf(s.sky)},
          {byteOf(s.vessels), byteOf(s.bumps), byteOf(s.gloss), byteOf(inner ? 1.0 - outside : 0.0)}};
}

}  // namespace

TissueSurface::TissueSurface(const RenderScene& scene, std::size_t triangleBudget)
    : surface_(scene.surface.begin(), scene.surface.begin() + static_cast<std::ptrdiff_t>(boundaryTriangles(scene))),
      skin_(buildSkin(surface_, scene.triangleLayer, scene.surfaceUv, scene.tissueRest.size(), triangleBudget)), pose_(skin_),
      mesh_{makeArray(), makeBuffer(), {}, 0}, coarse_{makeArray(), makeBuffer(), {}, 0}, cut_(scene),
      bruiseOfParticle_(scene.tissueRest.size(), 0.0f), looks_(makeBuffer()), stream_(6 * skin_.corners.size()) {
  pose_.update(skin_, scene.tissueRest);
  const RestShape rest = restShape(scene);
  openingAtRest_ = std::numbers::pi * rest.radius * rest.radius;
  std::vector<Look> looks;
  looks.reserve(skin_.corners.size());
  for (const SkinCorner& c : skin_.corners) {
    const float *p = pose_.point(c.point), *n = pose_.normal(c.normalSlot);   // [m], [1]
    looks.push_back(lookOf(c, {Vec3(p[0], p[1], p[2]), Vec3(n[0], n[1], n[2])}, rest));
  }
  glBindVertexArray(mesh_.array);
  describe(mesh_.vertices, 6 * sizeof(float), {{0, 3, 0}, {1, 3, 3 * sizeof(float)}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(stream_.size() * sizeof(float)), nullptr, GL_STREAM_DRAW);
  describe(looks_, sizeof(Look), {{2, 2, offsetof(Look, uv)}, {3, 4, offsetof(Look, color), GL_UNSIGNED_BYTE},
           {4, 4, offsetof(Look, surface), GL_UNSIGNED_BYTE}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(looks.size() * sizeof(Look)), looks.data(), GL_STATIC_DRAW);
  bruise_ = perCorner(6);
  std::vector<std::uint32_t> indices;
  for (const auto& t : skin_.triangles) indices.insert(indices.end(), t.begin(), t.end());
  uploadIndices(mesh_, indices);

  glBindVertexArray(coarse_.array);
  describe(coarse_.vertices, 4 * sizeof(float), {{0, 3, 0}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(pose_.particles().size() * sizeof(float)), nullptr, GL_STREAM_DRAW);
  indices.clear();
  for (const auto& t : surface_) indices.insert(indices.end(), t.begin(), t.end());
  uploadIndices(coarse_, indices);
  if (!cut_.present()) return;
  allowCuts(surface_, scene.tissueRest.size(), skin_);
  makeRoomForCuts();
}

void TissueSurface::makeRoomForCuts() {
  fineShown_.reserve(3 * skin_.triangles.size());
  coarseShown_.reserve(3 * surface_.size());
  fineRoom_ = makeIndexRoom(3 * skin_.triangles.size());
  coarseRoom_ = makeIndexRoom(3 * surface_.size());
  glBindVertexArray(mesh_.array);
  char_ = perCorner(5);
}

void TissueSurface::dropWhatIsGone() {
  fineShown_.clear();
  coarseShown_.clear();
  isCut_ = false;
  for (std::size_t t = 0; t < skin_.triangles.size(); ++t) {
    if (!cut_.shown()[skin_.surfaceTriangleOf(t)]) { isCut_ = true; continue; }
    fineShown_.insert(fineShown_.end(), skin_.triangles[t].begin(), skin_.triangles[t].end());
  }
  for (std::size_t t = 0; t < surface_.size(); ++t)
    if (cut_.shown()[t]) coarseShown_.insert(coarseShown_.end(), surface_[t].begin(), surface_[t].end());
  pose_.tear(skin_, surface_, cut_.shown());
}

TissueSurface::PerCorner TissueSurface::perCorner(unsigned location) const {
  PerCorner q{makeBuffer(), std::vector<float>(skin_.corners.size(), 0.0f)};
  describe(q.buffer, sizeof(float), {{location, 1, 0}});
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(q.value.size() * sizeof(float)), q.value.data(), GL_STREAM_DRAW);
  return q;
}

void TissueSurface::stream(const std::vector<float>& ofParticle, PerCorner& q) const {
  for (std::size_t i = 0; i < skin_.corners.size(); ++i) q.value[i] = pose_.at(skin_, skin_.corners[i].point, ofParticle);
  glBindBuffer(GL_ARRAY_BUFFER, q.buffer);
  glBufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(q.value.size() * sizeof(float)), q.value.data());
}

void TissueSurface::streamBruises(const RenderSnapshot& snapshot, bool anew) {
  if (snapshot.bruised.size() != bruiseOfParticle_.size()) return;
  const auto same = [](double now, float before) { return static_cast<float>(now) == before; };
  if (!anew && std::equal(snapshot.bruised.begin(), snapshot.bruised.end(), bruiseOfParticle_.begin(), same)) return;
  std::transform(snapshot.bruised.begin(), snapshot.bruised.end(), bruiseOfParticle_.begin(), [](double b) { return static_cast<float>(b); });
  stream(bruiseOfParticle_, bruise_);
}

void TissueSurface::update(const RenderSnapshot& snapshot) {
  bool changed = false;
  const bool canBeCut = cut_.update(snapshot, changed);
  if (canBeCut && changed) dropWhatIsGone();
  pose_.update(skin_, snapshot.tissue);
  for (std::size_t i = 0; i < skin_.corners.size(); ++i) {
    std::copy_n(pose_.point(skin_.corners[i].point), 3, &stream_[6 * i]);
    std::copy_n(pose_.normal(skin_.corners[i].normalSlot), 3, &stream_[6 * i + 3]);
  }
  mesh_.stream(stream_.data(), stream_.size() * sizeof(float));
  coarse_.stream(pose_.particles().data(), pose_.particles().size() * sizeof(float));
  if (canBeCut) stream(cut_.charOfParticles(), char_);
  streamBruises(snapshot, canBeCut && changed);
}

void TissueSurface::draw() const {
  if (!isCut_) { mesh_.draw(); return; }
  mesh_.drawOnly(fineShown_, fineRoom_);
  cut_.draw();
}

void TissueSurface::drawCoarse() const {
  if (!isCut_) coarse_.draw();
  else coarse_.drawOnly(coarseShown_, coarseRoom_);
}

}  // namespace halsted::render
