#pragma once
/// Where many points are nearest to one piece of the thread's curve: what `nearestOn` (thread_curve.h) finds for each, to the bit, four at a time. Physics
/// thread; no heap.
#include "sim/lane_math.h"
#include "sim/strand/thread_curve.h"

namespace halsted {

/// Points along a piece, component by component.
struct PointRow {
  static constexpr int kMost = 24;             // whole lanes of four
  std::array<double, kMost> x{}, y{}, z{};     // [m]
  Vec3 at(int k) const { return Vec3(x[k], y[k], z[k]); }   // [m]
  void set(int k, const Vec3& p) { x[k] = p.x(); y[k] = p.y(); z[k] = p.z(); }   // [m]
};

/// Points that lie farther than `reach` from `centre` are near nothing.
struct Sphere { Vec3 centre; double reach; };  // [m]

/// Writes the place [1] of each of the first `count` points; negative where there is none.
void nearestPlaces(const PieceShape&, const PointRow&, int count, const Sphere&, std::array<double, PointRow::kMost>& place, LanePath = widestLanes());

}  // namespace halsted
