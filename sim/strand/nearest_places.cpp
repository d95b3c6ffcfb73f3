#include "sim/strand/nearest_places.h"

#include "sim/lanes.h"

namespace halsted {
namespace {

using Mask = decltype(Lanes4{} < Lanes4{});    // all bits of a lane or none

HALSTED_INLINE bool any(const Mask& m) { return (m[0] | m[1] | m[2] | m[3]) != 0; }

struct Lanes3 { Lanes4 x, y, z; };

/// As Eigen adds three.
HALSTED_INLINE Lanes4 dot(const Lanes3& a, const Vec3& b) { return a.x * b.x() + (a.y * b.y() + a.z * b.z()); }

HALSTED_INLINE Lanes4 nearestFour(const PieceShape& s, const Lanes3& point, const Sphere& within) {   // [m] -> [1]
  const Lanes3 off{point.x - within.centre.x(), point.y - within.centre.y(), point.z - within.centre.z()};   // [m]
  const Lanes3 q{s.start.x() - point.x, s.start.y() - point.y, s.start.z() - point.z};   // [m]
  const Lanes4 squared = off.x * off.x + (off.y * off.y + off.z * off.z);   // [m^2]
  const Lanes4 c0 = dot(q, s.along), c1 = dot(q, s.turn) + s.c1;       // [m^2]
  const double c2 = s.c2, c3 = s.c3;                                   // [m^2]
  const Lanes4 zero{};
  Mask open = (squared <= within.reach * within.reach) & (c0 <= 0.0) & (c0 + c1 + c2 + c3 > 0.0);
  const Mask found = open;
  Lanes4 low = zero, high = zero + 1.0, v = -c0 / (c1 + c2 + c3);      // [1]
  for (int k = 0; k < 64 && any(open); ++k) {
    const Lanes4 value = c0 + v * (c1 + v * (c2 + v * c3));            // [m^2]
    const Lanes4 slope = c1 + v * (2.0 * c2 + v * 3.0 * c3);           // [m^2]
    open = open & ~(magnitude(value) <= 1e-13 * slope);
    const Mask above = value > 0.0;
    high = (open & above) ? v : high;
    low = (open & ~above) ? v : low;
    const Lanes4 newton = slope > 0.0 ? v - value / slope : low;       // [1]
    const Lanes4 next = ((newton > low) & (newton < high)) ? newton : 0.5 * (low + high);   // [1]
    v = open ? next : v;
  }
  return found ? v : zero - 1.0;
}

using Places = std::array<double, PointRow::kMost>;   // [1]

__attribute__((target("avx2"))) void placesWide(const PieceShape& s, const PointRow& p, int count, const Sphere& within, Places& place) {
  for (int k = 0; k < count; k += 4)
    storeLanes(&place[k], nearestFour(s, {loadLanes<Lanes4>(&p.x[k]), loadLanes<Lanes4>(&p.y[k]), loadLanes<Lanes4>(&p.z[k])}, within));
}

void placesSerial(const PieceShape& s, const PointRow& p, int count, const Sphere& within, Places& place) {
  for (int k = 0; k < count; ++k) {
    const bool near = (p.at(k) - within.centre).squaredNorm() <= within.reach * within.reach;
    place[k] = near ? nearestOn(s, p.at(k)) : -1.0;
  }
}

}  // namespace

void nearestPlaces(const PieceShape& s, const PointRow& p, int count, const Sphere& within, Places& place, LanePath path) {
  if (path == LanePath::kWide) placesWide(s, p, count, within, place);
  else placesSerial(s, p, count, within, place);
}

}  // namespace halsted
