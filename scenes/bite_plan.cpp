#include "scenes/bite_plan.h"

#include <cmath>

#include "sim/contact/surface.h"
#include "sim/cutting/edge.h"
#include "sim/portable_math.h"
#include "sim/strand/strand_model.h"

namespace halsted::scenes {
namespace {

constexpr double kBeside = 8.0;                // [deg] an edge so near to a bite counts for it
constexpr double kClockwiseStep = 0.25;        // [deg] when walking along the rim to the exit

struct Hit { TissuePlace place; double reach = -1.0; };   // [m] from the axis of the opening

/// The line from the opening's axis outward through one triangle.
void intersect(const Model& m, int triangle, const Vec3& from, const Vec3& direction, Hit& best) {
  const auto& v = m.surface.triangles[triangle];
  const Vec3 &a = m.mesh.vertices[v[0]], &b = m.mesh.vertices[v[1]], &c = m.mesh.vertices[v[2]];
  const Vec3 e1 = b - a, e2 = c - a, p = direction.cross(e2);
  const double det = e1.dot(p);
  if (std::fabs(det) < 1e-18) return;
  const Vec3 s = from - a, q = s.cross(e1);
  const double u = s.dot(p) / det, w = direction.dot(q) / det, reach = e2.dot(q) / det;
  constexpr double kSeam = -1e-9;              // [1] an edge belongs to both its triangles
  if (u < kSeam || w < kSeam || u + w > 1.0 - kSeam || reach <= best.reach) return;
  best = {{triangle, {1.0 - u - w, u, w}}, reach};
}

}  // namespace

TissuePlace placeOnWall(const Model& m, const WallSpot& spot) {
  if (spot.bowel >= m.bowels.count) return {};
  const double angle = spot.angleDegrees * kPi / 180.0;
  const Opening& o = m.bowels.opening[spot.bowel];
  const Vec3 direction = cosine(angle) * o.right + sine(angle) * o.up, from = o.centre - spot.depth * o.axis;
  Hit best;
  for (std::size_t f = 0; f < m.surface.triangles.size(); ++f)
    if (m.mesh.triangleLayer[f] == spot.layer && m.bowels.of[m.surface.triangles[f][0]] == spot.bowel) intersect(m, static_cast<int>(f), from, direction, best);
  return best.place;
}

double edgeBehindRim(const Model& m, const State& s, int bowel, double angleDegrees) {
  const double angle = angleDegrees * kPi / 180.0, beside = cosine(kBeside * kPi / 180.0);   // [rad], [1]
  const Opening& o = m.bowels.opening[bowel];
  const Vec3 direction = cosine(angle) * o.right + sine(angle) * o.up;
  double deepest = 0.0;                        // [m]
  for (int v : edgeOf(m, s, bowel)) {
    const Vec3 from = m.mesh.vertices[v] - o.centre, round = from - from.dot(o.axis) * o.axis;
    if (round.dot(direction) > beside * round.norm()) deepest = std::fmax(deepest, -from.dot(o.axis));
  }
  return deepest;
}

Vec3 positionOf(const Model& m, const State& s, const TissuePlace& p) { return pointOn(m.surface, s.tissue.position, p.triangle, p.weight); }

Vec3 normalOf(const Model& m, const State& s, const TissuePlace& p) {
  const auto& v = m.surface.triangles[p.triangle];
  const auto& x = s.tissue.position;
  return (x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]).normalized();
}

bool planPlaces(const Model& m, const ExpertAction& a, BitePlan& plan, const State* cut) {
  if (a.width > 1.8 * m.strand.needle.radius) return false;
  if (a.across) {                              // from the mucosa of the first wall to that of the second, which stands inside it
    const auto depth = [&](int wall) { return a.depth + (cut ? edgeBehindRim(m, *cut, wall, a.angleDegrees) : 0.0); };   // [m]
    plan.entry = placeOnWall(m, {0, a.angleDegrees, depth(0), kMucosa});
    plan.exit = placeOnWall(m, {1, a.angleDegrees, depth(1), kMucosa});
    plan.middleDegrees = a.angleDegrees;
    return plan.entry.triangle >= 0 && plan.exit.triangle >= 0;
  }
  plan.entry = placeOnWall(m, {a.bowel, a.angleDegrees, a.depth});
  if (plan.entry.triangle < 0) return false;
  if (a.exitDepth > 0.0) {                     // toward the edge or away from it
    plan.exit = placeOnWall(m, {a.bowel, a.angleDegrees, a.exitDepth});
    plan.middleDegrees = a.angleDegrees;
    return plan.exit.triangle >= 0;
  }
  const Vec3 start = pointOn(m.surface, m.mesh.vertices, plan.entry.triangle, plan.entry.weight);
  const double way = a.counterClockwise ? 1.0 : -1.0;            // [1]
  for (double step = kClockwiseStep; step < 90.0; step += kClockwiseStep) {
    plan.exit = placeOnWall(m, {a.bowel, a.angleDegrees + way * step, a.depth});
    if (plan.exit.triangle < 0) return false;
    if ((pointOn(m.surface, m.mesh.vertices, plan.exit.triangle, plan.exit.weight) - start).norm() >= a.width) {
      plan.middleDegrees = a.angleDegrees + way * 0.5 * step;
      return true;
    }
  }
  return false;
}

void planCircle(const Model& m, const State& s, const ExpertAction& a, double dip, BitePlan& plan) {
  const Vec3 entry = positionOf(m, s, plan.entry), exit = positionOf(m, s, plan.exit);
  plan.along = (exit - entry).normalized();
  // Through two walls, one in the other, the needle passes below both edges: both mucosae face away from each other.
  Vec3 out = a.across ? m.bowels.opening[0].axis : Vec3(normalOf(m, s, plan.entry) + normalOf(m, s, plan.exit));
  out = (out - out.dot(plan.along) * plan.along).normalized();
  const double lean = a.tilt * kPi / 180.0;                      // [rad]
  plan.out = lean == 0.0 ? out : Vec3(cosine(lean) * out + sine(lean) * plan.along.cross(out));
  plan.axis = plan.along.cross(plan.out);
  const double width = a.across ? (exit - entry).norm() : a.exitDepth > 0.0 ? std::fabs(a.depth - a.exitDepth) : a.width;           // [m]
  const double r = m.strand.needle.radius, half = 0.5 * std::fmin(width, (exit - entry).norm());
  plan.centre = 0.5 * (entry + exit) + (std::sqrt(r * r - half * half) - (dip + a.sink)) * plan.out;
  plan.exitAngle = arcSine(half / r);
  plan.entryAngle = -plan.exitAngle;
}

Pose needleOnCircle(const Model& m, const BitePlan& plan, double tipAngle, const Vec3& offset) {
  // The tip lies at the end of the arc: rotate the circle so that it points where tipAngle says.
  const Vec3 toTip = -cosine(tipAngle) * plan.out + sine(tipAngle) * plan.along;
  const Vec3 tipLocal = m.strand.arcPoint.back().normalized();
  const Vec3 sideLocal = Vec3::UnitZ().cross(tipLocal), side = plan.axis.cross(toTip);
  Mat3 world, local;
  world << toTip, side, plan.axis;
  local << tipLocal, sideLocal, Vec3::UnitZ();
  return {plan.centre + offset, Quat(Mat3(world * local.transpose())).normalized()};
}

Pose gripPose(const Model& m, const Pose& needle, double coordinate) {
  Vec3 point, tangent;
  arcAt(m.strand, coordinate, point, tangent);
  Mat3 axes;
  axes << point.normalized(), tangent, Vec3::UnitZ();
  return compose(needle, {point, Quat(axes).normalized()});
}

}  // namespace halsted::scenes
