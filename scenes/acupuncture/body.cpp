#include "scenes/acupuncture/body.h"

#include <cmath>

#include "scenes/acupuncture/body_table.h"
#include "scenes/acupuncture/ct_layers.h"
#include "scenes/harmonics/fit.h"
#include "scenes/harmonics/layers.h"
#include "scenes/input_text.h"
#include "scenes/mesh_path.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

/// The skin as a closed surface, and the name that messages about it begin with.
Surface skinSurface(const SceneFile& scene, const BodyTable& table, double scale, std::string& origin) {   // scale [m per mesh unit]
  const bool given = !scene.params.anatomy.mesh.empty();
  const std::string file = given ? scene.params.anatomy.mesh : table.mesh.empty() ? "" : meshPathInFile(table.mesh, scene.folder, table.path + ": mesh");
  if (file.empty()) {
    origin = placeOf(scene, "anatomy.order");
    return superellipsoid(table.slab);
  }
  const Surface whole = readSurface(file, scale);
  origin = quoted(file) + ": " + placeOf(scene, given ? "anatomy.mesh" : "anatomy.body");
  if (table.cuts.empty()) return whole;
  std::vector<CutPlane> cuts;
  for (const CutPlane& cut : table.cuts) cuts.push_back({scale * cut.point, cut.normal.normalized()});
  return cutRegion(whole, cuts, scale * table.inside, origin);
}

/// On the line through the landmarks.  [m]
struct AxisPlace { Vec3 at = Vec3::Zero(), along = Vec3::UnitZ(); };   // [m], [1]
AxisPlace axisAt(const BodyTable& t, double scale, double cun) {   // scale [m per mesh unit], cun [cun]
  std::size_t k = 1;
  while (k + 1 < t.landmarks.size() && cun > t.landmarks[k].cun) ++k;
  const Landmark &a = t.landmarks[k - 1], &b = t.landmarks[k];
  const double share = (cun - a.cun) / (b.cun - a.cun);            // [1]
  return {scale * (a.at + share * (b.at - a.at)), (b.at - a.at).normalized()};
}

/// From inside the body outward to where the point lies.
Line rayTo(const BodyTable& t, const PointEntry& p, double scale) {   // scale [m per mesh unit]
  const AxisPlace axis = axisAt(t, scale, p.along);
  const Vec3 front = (t.front - t.front.dot(axis.along) * axis.along).normalized();
  Vec3 left = axis.along.cross(front);
  if (left.dot(t.head.cross(t.front)) < 0.0) left = -left;
  const double angle = p.around * kPi / 180.0;                     // [rad]
  return {axis.at + p.side * t.sideCun * left, cosine(angle) * front + sine(angle) * left};
}

/// Where the ray leaves the skin: Newton from the nearest of many places, the outermost when there are several.
Vec3 unitOnSkin(const HarmonicSurface& skin, const Line& ray, const std::string& where) {
  double best = 1e300;                         // [m]
  Vec3 start = Vec3::UnitZ();
  for (const Vec3& u : spreadDirections(4000)) {
    const Vec3 r = positionAt(skin, u) - ray.origin;
    const double along = r.dot(ray.direction), across = (r - along * ray.direction).norm();   // [m]
    if (along > 0.0 && across < best) { best = across; start = u; }
  }
  const LineHit hit = meetLine(skin, ray, start);
  if (!hit.found || hit.distance < 0.0) throw InputError(where + ": this point does not lie on the skin");
  return hit.frame.unit;
}

/// Rigid motion to the operating field: the target at the origin, its normal up, the head to the surgeon's left.
struct Placement {
  Mat3 turn = Mat3::Identity();
  Vec3 origin = Vec3::Zero();                  // [m]

  Placement(const SurfaceFrame& target, const Vec3& head) : origin(target.position) {
    const Vec3 y = target.normal, x = -(head - head.dot(y) * y).normalized();
    turn.row(0) = x;
    turn.row(1) = y;
    turn.row(2) = x.cross(y);
  }
  std::vector<Vec3> apply(const HarmonicSurface& surface) const {   // [m]
    constexpr double kRootFourPi = 3.5449077018110321;              // [1] Y_00 = 1 / it
    std::vector<Vec3> c = coefficients(surface);
    c[0] -= kRootFourPi * origin;
    for (Vec3& x : c) x = turn * x;
    return c;
  }
};

int targetOf(const SceneFile& scene, const BodyTable& t) {
  const std::string& wanted = scene.params.anatomy.point;
  if (wanted.empty()) return 0;
  std::string known;
  for (std::size_t i = 0; i < t.points.size(); ++i) {
    if (t.points[i].id == wanted) return static_cast<int>(i);
    known += (i ? ", " : "") + t.points[i].id;
  }
  throw InputError(placeOf(scene, "anatomy.point") + ": '" + quoted(wanted) + "' is not one of " + known);
}

Acupoint acupoint(const BodyTable& t, const PointEntry& p, const HarmonicSurface& skin, double scale) {   // scale [m per mesh unit]
  return {p.id, p.name, unitOnSkin(skin, rayTo(t, p, scale), t.path + ": point." + p.id), p.depth, p.angle * kPi / 180.0,
          p.lean.norm() > 0.0 ? Vec3(p.lean.normalized()) : Vec3(-t.head.normalized())};
}

/// The scene's, or a CT's. No CT shows the skin apart from the fat.
std::array<double, kLayers> thicknesses(const SceneFile& scene) {   // [m]
  std::array<double, kLayers> t{};             // [m]
  for (int k = 0; k < kLayers; ++k) t[k] = scene.params.needling.layers[k].thickness;
  const AnatomyParams& anatomy = scene.params.anatomy;
  if (anatomy.layersFrom.empty()) return t;
  const CtLayers ct = measureLayers(anatomy.layersFrom, anatomy.layersAngle, placeOf(scene, "anatomy.layers_from"));
  t[1] = ct.fat;
  t[2] = ct.muscle;
  return t;
}

}  // namespace

Body buildBody(const SceneFile& scene) {
  const BodyTable table = chooseBodyTable(scene);
  const bool ownScale = scene.origins.count("anatomy.scale") > 0;
  const double scale = ownScale ? scene.params.anatomy.scale : table.scale;   // [m per mesh unit]
  std::string origin;
  const Surface surface = skinSurface(scene, table, scale, origin);
  const HarmonicSurface skin = fitSurface(surface, scene.params.anatomy.order, origin).surface;
  Body body;
  body.order = scene.params.anatomy.order;
  body.target = targetOf(scene, table);
  for (const PointEntry& p : table.points) body.points.push_back(acupoint(table, p, skin, scale));
  body.thickness = thicknesses(scene);
  std::vector<double> depths;                  // [m]
  double depth = 0.0;                          // [m]
  for (int k = 0; k < kLayers; ++k) {
    depths.push_back(depth);
    depth += body.thickness[k];
  }
  const std::vector<HarmonicSurface> nested = nestedSurfaces(skin, depths, origin);
  const Placement placement(frameAt(skin, body.points[body.target].unit), table.head);
  for (int k = 0; k < kLayers; ++k) body.surface[k] = placement.apply(nested[k]);
  for (Acupoint& p : body.points) p.lean = placement.turn * p.lean;
  return body;
}

}  // namespace halsted::scenes
