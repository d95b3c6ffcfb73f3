#include "sim/suture/edge_exit.h"

#include <cmath>

namespace halsted {
namespace {

constexpr double kAlong = 0.8;                 // [1] cosine between thread and normal: nearer to the thread's own direction it is of no use
constexpr double kSteep = 0.5;                 // [1] sine: a face that a way out square to the thread may lead through

/// Leaves the tissue through one triangle, square to the thread, and nearer than what was found before.
void tryTriangle(const SurfaceModel& s, const SurfaceNow& now, const PressedIn& in, int triangle, SurfacePoint& best) {
  const auto& t = s.triangles[triangle];
  const Vec3 &a = now.position[t[0]], &b = now.position[t[1]], &c = now.position[t[2]];
  const Vec3 area = (b - a).cross(c - a);      // [m^2] twice
  const double size = area.norm();             // [m^2]
  if (size < 1e-14) return;
  const Vec3 normal = area / size;
  Vec3 out = normal - normal.dot(in.along) * in.along;
  const double sine = out.norm();              // [1]
  if (sine < kSteep) return;
  out /= sine;
  const double way = (a - in.point).dot(normal) / out.dot(normal);             // [m]
  if (way < 0.0 || way >= -best.distance) return;
  const Vec3 hit = in.point + way * out;
  const double wb = (hit - a).cross(c - a).dot(normal) / size, wc = (b - a).cross(hit - a).dot(normal) / size;   // [1]
  constexpr double kSeam = -1e-6;              // [1] an edge belongs to both its triangles
  if (wb < kSeam || wc < kSeam || wb + wc > 1.0 - kSeam) return;
  best = {triangle, {1.0 - wb - wc, wb, wc}, hit, normal, -way};
}

/// The nearest way out through those of the bare triangles round the vertex that are allowed; none: triangle -1.
template <class Allowed> SurfacePoint wayOut(const SurfaceModel& s, const SurfaceNow& now, const PressedIn& in, double most, Allowed allowed) {   // [m]
  SurfacePoint best;
  best.distance = -most;
  const auto tryAround = [&](int v) {
    for (int e = s.triangleStart[v]; e < s.triangleStart[v + 1]; ++e)
      if (allowed(s.triangleOf[e]) && exposed(s, now.gone, s.triangleOf[e])) tryTriangle(s, now, in, s.triangleOf[e], best);
  };
  tryAround(in.vertex);
  for (int e = s.neighbourStart[in.vertex]; e < s.neighbourStart[in.vertex + 1]; ++e) tryAround(s.neighbour[e]);
  return best;
}

}  // namespace

SurfacePoint exitAcross(const SurfaceModel& s, const SurfaceNow& now, const PressedIn& in, double most) {
  if (in.nearest.distance >= 0.0 || std::fabs(in.nearest.normal.dot(in.along)) < kAlong) return in.nearest;
  const SurfacePoint out = wayOut(s, now, in, most, [](int) { return true; });
  return out.triangle >= 0 ? out : in.nearest;
}

SurfacePoint exitOverEdge(const SurfaceModel& s, const std::vector<int>& layer, const SurfaceNow& now, const PressedIn& in, double most) {
  return wayOut(s, now, in, most, [&](int triangle) { return layer[triangle] == kEdgeFace; });
}

}  // namespace halsted
