#include "sim/strand/tool_winding.h"

namespace halsted {
namespace {

struct Flat { double x, y; };                  // [m] in the plane normal to the tool, from the axis

class Plane {
 public:
  explicit Plane(const ToolAxis& axis) : tip_(axis.tip) {
    const Vec3& w = axis.along;
    const Vec3 helper = w.x() * w.x() < 0.5 ? Vec3(Vec3::UnitX()) : Vec3(Vec3::UnitY());
    right_ = helper.cross(w).normalized();
    up_ = w.cross(right_);
  }
  Flat flat(const Vec3& p) const { return {right_.dot(p - tip_), up_.dot(p - tip_)}; }

 private:
  Vec3 tip_, right_, up_;
};

/// Fractions at which two flat segments meet; false when they do not.
bool meet(const Flat& a, const Flat& b, const Flat& c, const Flat& d, double& s) {
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y, cross = ux * vy - uy * vx;   // [m], [m^2]
  if (cross == 0.0) return false;
  s = ((c.x - a.x) * vy - (c.y - a.y) * vx) / cross;
  const double t = ((c.x - a.x) * uy - (c.y - a.y) * ux) / cross;   // [1]
  return s >= 0.0 && s < 1.0 && t >= 0.0 && t < 1.0;
}

/// +1 or -1 when the segment crosses the ray from the axis to the right, by its way.
int rayCrossing(const Flat& a, const Flat& b) {
  if ((a.y > 0.0) == (b.y > 0.0) || a.x + (b.x - a.x) * (-a.y) / (b.y - a.y) <= 0.0) return 0;
  return b.y > a.y ? 1 : -1;
}

/// Of the loop that starts and ends where pairs i and j meet; odd by the even-odd rule when the axis lies inside.
int turnsOfLoop(std::span<const Vec3> nodes, const Plane& plane, int i, int j, double s) {
  const Flat a = plane.flat(nodes[i]), b = plane.flat(nodes[i + 1]);
  const Flat crossing{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
  Flat from = crossing;
  int turns = 0;
  for (int k = i + 1; k <= j; ++k) {
    const Flat to = plane.flat(nodes[k]);
    turns += rayCrossing(from, to);
    from = to;
  }
  return turns + rayCrossing(from, crossing);
}

bool touches(const Vec3& node, const ToolAxis& axis) {
  const Vec3 from = node - axis.tip;           // [m]
  const double along = axis.along.dot(from);   // [m]
  return along >= 0.0 && along <= axis.length && (from - along * axis.along).squaredNorm() <= axis.near * axis.near;
}

bool pairTouches(std::span<const Vec3> nodes, const ToolAxis& axis, int i) { return touches(nodes[i], axis) && touches(nodes[i + 1], axis); }

}  // namespace

ToolLoop findToolLoop(std::span<const Vec3> nodes, const ToolAxis& axis, double reach) {
  const Plane plane(axis);
  ToolLoop found;
  const int pairs = static_cast<int>(nodes.size()) - 1;
  for (int i = 0; i < pairs; ++i) {
    if (!pairTouches(nodes, axis, i)) continue;
    for (int j = i + 2; j < pairs; ++j) {
      double s = 0.0;                          // [1]
      if (!pairTouches(nodes, axis, j)) continue;
      if (!meet(plane.flat(nodes[i]), plane.flat(nodes[i + 1]), plane.flat(nodes[j]), plane.flat(nodes[j + 1]), s)) continue;
      const bool closed = (nodes[i + 1] - nodes[j]).squaredNorm() <= reach * reach;
      const ToolLoop loop{i + 1, j, turnsOfLoop(nodes, plane, i, j, s), true, closed};
      if (loop.valid()) return loop;
      if (!found.encirclesTool()) found = loop;
    }
  }
  return found;
}

int woundTurns(std::span<const Vec3> nodes, const ToolAxis& axis, double reach) {
  int turns = 0;
  for (std::size_t from = 0; from < nodes.size();) {
    const ToolLoop loop = findToolLoop(nodes.subspan(from), axis, reach);
    if (!loop.valid()) break;
    turns += loop.turns;
    from += static_cast<std::size_t>(loop.last);
  }
  return turns;
}

}  // namespace halsted
