#pragma once
/// A closed piece of a larger closed surface: a limb, a back. What lies on the wrong side of the planes is cut away and each cut is
/// closed by a dome of rings that leaves the surface smoothly, because harmonics ring at a crease.
#include <string>
#include <vector>

#include "scenes/mesh_readers/surface.h"

namespace halsted::scenes {

struct CutPlane { Vec3 point = Vec3::Zero(), normal = Vec3::UnitZ(); };   // [m], [1]; the side the normal points to is kept

/// The piece that holds the vertex nearest to `inside` [m], cut at the planes one after the other.
/// Throws InputError "origin: ..." when nothing is left or a cut's outline is not a simple loop.
Surface cutRegion(const Surface&, const std::vector<CutPlane>&, const Vec3& inside, const std::string& origin);

/// |x/a|^n + |y/b|^n + |z/c|^n = 1, sampled evenly: a slab with rounded edges, n from 2 (ellipsoid) to about 10.
struct Superellipsoid {
  Vec3 halfSize = Vec3(0.1, 0.1, 0.03);        // [m]
  double power = 4.0;                          // [1] n
  int divisions = 40;                          // of the side of each of the 8 faces of the sphere it is projected from
};
/// Throws std::invalid_argument naming the parameter that makes no sense.
Surface superellipsoid(const Superellipsoid&);

}  // namespace halsted::scenes
