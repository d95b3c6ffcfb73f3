#include "sim/needling/body_picture.h"

#include <algorithm>
#include <cmath>

#include "sim/portable_math.h"

namespace halsted {
namespace {

constexpr int kSectors = 48;                   // an even number: the cutaway takes the first half of them
constexpr double kFinest = 0.04e-3, kGrowth = 1.17;   // [m], [1] of the rings' radii
constexpr double kFloor = 16e-3;               // [m] of muscle that the cutaway shows
constexpr double kStep[kLayers] = {34e-3, 24e-3, 15e-3};   // [m] radius to which each layer is cut away

/// One metre along e1 and e2 of the tangent plane in terms of the sphere's directions: columns are the tangents.  [m]
Eigen::Matrix2d tangentsAt(const SurfaceFrame& f, const Vec3& e1) {
  const Vec3 e2 = f.normal.cross(e1);
  Eigen::Matrix2d t;                           // [m]
  t << f.tangent1.dot(e1), f.tangent2.dot(e1), f.tangent1.dot(e2), f.tangent2.dot(e2);
  return t;
}

Vec3 alongSkin(const SurfaceFrame& f, const Vec3& way) { return (way - way.dot(f.normal) * f.normal).normalized(); }

/// Rings of the sphere round the target, evenly spread round it on the skin where they are small.
struct Rings {
  std::vector<double> radius;                  // [m] on the skin near the target
  std::vector<Vec3> unit;                      // ring by ring; first the centre, last the far side

  Rings(const SurfaceFrame& f, const Vec3& e1) {
    const Eigen::Matrix2d tangents = tangentsAt(f, e1);   // [m]
    const double mean = std::sqrt(tangents.determinant());   // [m] per radian
    const Eigen::Matrix2d toSphere = mean * tangents.inverse();   // [1]
    const Eigen::Vector2d turn = Eigen::Vector2d(toSphere(0, 0) + toSphere(1, 1), toSphere(1, 0) - toSphere(0, 1)).normalized();
    Eigen::Matrix2d onSphere;                  // [1] the rotation nearest to it, for the far rings
    onSphere << turn.x(), -turn.y(), turn.y(), turn.x();
    unit.push_back(f.unit);
    for (double r = kFinest; r < 0.97 * kPi * mean; r *= kGrowth) {
      radius.push_back(r);
      const double far = r / (kPi * mean);     // [1]
      for (int k = 0; k < kSectors; ++k) {
        const double phi = 2.0 * kPi * k / kSectors;   // [rad] counter-clockwise seen from outside
        const Eigen::Vector2d round(cosine(phi), sine(phi));
        const Eigen::Vector2d way = ((1.0 - far) * toSphere + far * onSphere) * round;   // [1] round on the skin near, on the sphere far
        const double size = way.norm(), angle = std::min(r / mean * size, 0.985 * kPi);   // [1], [rad]
        const Vec3 d = (way.x() * f.direction1 + way.y() * f.direction2) / size;
        unit.push_back(cosine(angle) * f.unit + sine(angle) * d);
      }
    }
    unit.push_back(-f.unit);
  }
  int count() const { return static_cast<int>(radius.size()); }
  int until(double r) const { return static_cast<int>(std::lower_bound(radius.begin(), radius.end(), r) - radius.begin()); }
};

/// Index within a surface. Ring -1 is the centre, ring `count` the far side.
struct Grid {
  int rings = 0;
  int at(int ring, int sector) const { return ring < 0 ? 0 : ring >= rings ? 1 + rings * kSectors : 1 + ring * kSectors + sector % kSectors; }
};

class Builder {
 public:
  Builder(BodyPicture& picture, const Rings& rings) : p_(picture), grid_{rings.count()} {}

  /// The part of a surface between two rings, over a range of sectors; (from, to].
  void sheet(int surface, std::array<int, 2> rings, std::array<int, 2> sectors, TissueLook look, Shown shown) {
    for (int r = rings[0]; r < rings[1]; ++r)
      for (int k = sectors[0]; k < sectors[1]; ++k)
        quad(vertex(surface, r, k), vertex(surface, r + 1, k), vertex(surface, r + 1, k + 1), vertex(surface, r, k + 1), look, shown);
  }
  /// Walls of the cut through layer `k`: both meridians, and the arc at its outer ring.
  void walls(int k, int ring, TissueLook look) {
    constexpr int h = kSectors / 2;
    for (int r = -1; r < ring; ++r) {
      quad(vertex(k, r, 0), vertex(k, r + 1, 0), vertex(k + 1, r + 1, 0), vertex(k + 1, r, 0), look, Shown::kCutaway);
      quad(vertex(k, r, h), vertex(k + 1, r, h), vertex(k + 1, r + 1, h), vertex(k, r + 1, h), look, Shown::kCutaway);
    }
    for (int s = 0; s < h; ++s)
      quad(vertex(k, ring, s), vertex(k, ring, s + 1), vertex(k + 1, ring, s + 1), vertex(k + 1, ring, s), look, Shown::kCutaway);
  }

 private:
  int vertex(int surface, int ring, int sector) const { return surface * p_.perSurface + grid_.at(ring, sector); }
  void triangle(int a, int b, int c, TissueLook look, Shown shown) {
    if (a == b || b == c || c == a) return;
    p_.triangles.push_back({a, b, c});
    p_.look.push_back(static_cast<int>(look));
    p_.shown.push_back(static_cast<std::uint8_t>(shown));
  }
  void quad(int a, int b, int c, int d, TissueLook look, Shown shown) {
    triangle(a, b, c, look, shown);
    triangle(a, c, d, look, shown);
  }
  BodyPicture& p_;
  Grid grid_;
};

PicturePatch patchAt(const HarmonicSurface& surface, const Vec3& unit, const Vec3& e1Wanted) {
  const SurfaceFrame f = frameAt(surface, unit);
  const SurfaceBend bend = bendAt(surface, f);
  PicturePatch p;
  p.centre = f.position;
  p.normal = f.normal;
  p.e1 = alongSkin(f, e1Wanted);
  p.e2 = f.normal.cross(p.e1);
  const Eigen::Matrix2d toSphere = tangentsAt(f, p.e1).inverse();   // [1/m]
  Eigen::Matrix2d second;                      // [m]
  second << bend.along11.dot(f.normal), bend.along12.dot(f.normal), bend.along12.dot(f.normal), bend.along22.dot(f.normal);
  const Eigen::Matrix2d h = toSphere.transpose() * second * toSphere;   // [1/m]
  p.xx = h(0, 0);
  p.xy = h(0, 1);
  p.yy = h(1, 1);
  return p;
}

void addTriangles(const Rings& rings, BodyPicture& p) {
  Builder build(p, rings);
  constexpr int h = kSectors / 2;
  constexpr TissueLook kTop[] = {TissueLook::kSkin, TissueLook::kFat, TissueLook::kMuscle};
  constexpr TissueLook kSection[] = {TissueLook::kSkinSection, TissueLook::kFatSection, TissueLook::kMuscleSection};
  int cut[kLayers];
  for (int k = 0; k < kLayers; ++k) cut[k] = rings.until(kStep[k]);
  build.sheet(0, {-1, cut[0]}, {0, h}, TissueLook::kSkin, Shown::kWhole);
  build.sheet(0, {-1, cut[0]}, {h, kSectors}, TissueLook::kSkin, Shown::kAlways);
  build.sheet(0, {cut[0], rings.count()}, {0, kSectors}, TissueLook::kSkin, Shown::kAlways);
  for (int k = 1; k < kLayers; ++k) build.sheet(k, {cut[k], cut[k - 1]}, {0, h}, kTop[k], Shown::kCutaway);
  for (int k = 0; k < kLayers; ++k) build.walls(k, cut[k], kSection[k]);
  build.sheet(kLayers, {-1, cut[kLayers - 1]}, {0, h}, TissueLook::kMuscleSection, Shown::kCutaway);
}

double share(const ForceNet& net, double radius, double r, double depth) {   // [1], [m]
  if (net.profile == NetProfile::kInverseDistance) return r <= radius ? 1.0 : radius / r;
  return depth > 0.0 ? std::max(0.0, 1.0 - net.slope * r / depth) : 0.0;
}

/// Moves the finest rings to where the needle is: vertices slide along the surface, less the farther out.
Vec3 slid(const PicturePatch& p, const Vec3& rest, double dx, double dy, double size) {   // [m]
  const Vec3 from = rest - p.centre;
  const double x = from.dot(p.e1), y = from.dot(p.e2);                 // [m]
  const double w = 1.0 - std::sqrt(x * x + y * y) / (3.0 * size);      // [1]
  if (!(w > 0.0)) return rest;
  const double nx = x + w * dx, ny = y + w * dy;                       // [m]
  const double rise = 0.5 * (p.xx * (nx * nx - x * x) + 2.0 * p.xy * (nx * ny - x * y) + p.yy * (ny * ny - y * y));   // [m]
  return rest + w * (dx * p.e1 + dy * p.e2) + rise * p.normal;
}

}  // namespace

BodyPicture bodyPicture(const NeedlingModel& m, const SurfaceFrame& target) {
  const Vec3 left = std::abs(target.normal.x()) < 0.9 ? Vec3(-Vec3::UnitX()) : Vec3(Vec3::UnitY());   // so that the cut faces the surgeon
  const Rings rings(target, alongSkin(target, left));
  BodyPicture p;
  p.perSurface = static_cast<int>(rings.unit.size());
  for (int k = 0; k < kLayers; ++k) {
    for (const Vec3& u : rings.unit) p.rest.push_back(positionAt(m.surface[k], u));
    p.patch[k] = patchAt(m.surface[k], target.unit, left);
  }
  for (const Vec3& u : rings.unit) {
    const SurfaceFrame f = frameAt(m.surface[kLayers - 1], u);
    p.rest.push_back(f.position - kFloor * f.normal);
  }
  p.patch[kLayers] = p.patch[kLayers - 1];
  p.patch[kLayers].centre -= kFloor * p.patch[kLayers].normal;
  p.cutNormal = p.patch[0].e2;
  addTriangles(rings, p);
  return p;
}

void fillPicture(const NeedlingModel& m, const BodyPicture& p, const NeedlingState& s, std::span<Vec3> vertices) {
  constexpr double kFarthest = 20e-3;          // [m] a needle farther from the target dents coarse triangles
  for (int k = 0; k < BodyPicture::kSurfaces; ++k) {
    const bool dented = k < kLayers && s.layers[k].phase != LayerPhase::kFree;
    const Vec3 middle = dented ? s.layers[k].rest[0] : p.patch[k].centre, offset = middle - p.patch[k].centre;
    const double dx = offset.dot(p.patch[k].e1), dy = offset.dot(p.patch[k].e2), size = std::sqrt(dx * dx + dy * dy);   // [m]
    const double depth = dented ? dimple(s, k) : 0.0;                  // [m]
    for (int i = k * p.perSurface; i < (k + 1) * p.perSurface; ++i) {
      Vec3 x = size > 1e-9 && size < kFarthest ? slid(p.patch[k], p.rest[i], dx, dy, size) : p.rest[i];
      const double pressed = pressedDepth(m, s, x);                    // [m]
      if (dented) x += depth * share(m.net[k], m.params.needleRadius, (x - middle).norm(), depth) * s.axis;
      vertices[i] = x - pressed * s.fingerNormal;
    }
  }
}

}  // namespace halsted
