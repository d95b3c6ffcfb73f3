#include "sim/strand/piece_spheres.h"

#include <algorithm>

namespace halsted {
namespace {

__attribute__((target("avx2"))) int nearWide(const PieceSpheres& s, int begin, int end, const Vec3& centre, double reach, int* found) {   // [m]
  int count = 0;
  for (int q = begin; q < end; q += 4) {
    const Lanes4 x = loadLanes<Lanes4>(&s.x[q]) - centre.x(), y = loadLanes<Lanes4>(&s.y[q]) - centre.y(), z = loadLanes<Lanes4>(&s.z[q]) - centre.z();
    const Lanes4 sum = loadLanes<Lanes4>(&s.radius[q]) + reach;
    const auto near = x * x + (y * y + z * z) <= sum * sum;
    if ((near[0] | near[1] | near[2] | near[3]) == 0) continue;
    for (int k = 0; k < std::min(4, end - q); ++k)
      if (near[k]) found[count++] = q + k;
  }
  return count;
}

int nearSerial(const PieceSpheres& s, int begin, int end, const Vec3& centre, double reach, int* found) {   // [m]
  int count = 0;
  for (int q = begin; q < end; ++q) {
    const double sum = s.radius[q] + reach;    // [m]
    if ((s.centre(q) - centre).squaredNorm() <= sum * sum) found[count++] = q;
  }
  return count;
}

}  // namespace

void PieceSpheres::resize(int count) {
  for (LineVector<double>* v : {&x, &y, &z, &radius}) v->assign(count + 4, 0.0);
}

void PieceSpheres::set(int p, const Vec3& centre, double r) {   // [m]
  x[p] = centre.x();
  y[p] = centre.y();
  z[p] = centre.z();
  radius[p] = r;
}

int spheresNear(const PieceSpheres& s, int begin, int end, const Vec3& centre, double reach, int* found, LanePath path) {   // [m]
  return path == LanePath::kWide ? nearWide(s, begin, end, centre, reach, found) : nearSerial(s, begin, end, centre, reach, found);
}

}  // namespace halsted
