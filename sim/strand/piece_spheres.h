#pragma once
/// Bounding spheres of the pieces of the thread's curve, component by component: which of them come near one, asked of four at a time. Physics
/// thread; no heap after `resize`.
#include "sim/lane_math.h"
#include "sim/line_vector.h"
#include "sim/types.h"

namespace halsted {

struct PieceSpheres {
  LineVector<double> x, y, z, radius;          // [m] room for four more behind the last

  void resize(int count);
  void set(int p, const Vec3& centre, double r);   // [m]
  Vec3 centre(int p) const { return Vec3(x[p], y[p], z[p]); }   // [m]
};

/// Those of pieces [begin, end) within `reach` of `centre`, in their order, into `found`, which has room for all; how many they are. Same
/// answer with and without AVX2.
int spheresNear(const PieceSpheres&, int begin, int end, const Vec3& centre, double reach, int* found, LanePath = widestLanes());   // [m]

}  // namespace halsted
