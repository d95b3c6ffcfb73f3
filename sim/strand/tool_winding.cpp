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

/// Whether the ray from the axis to the right crosses the segment.
bool rayCrosses(const Flat& a, const Flat& b) {
  if ((a.y > 0.0) == (b.y > 0.0)) return false;
  return a.x + (b.x - a.x) * (-a.y) / (b.y - a.y) > 0.0;
}

/// Even-odd rule for the loop that starts and ends where pairs i and j meet.
bool axisInside(std::span<const Vec3> nodes, const Plane& plane, int i, int j, double s) {
  const Flat a = plane.flat(nodes[i]), b = plane.flat(nodes[i + 1]);
  const Flat crossing{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
  Flat from = crossing;
  int count = 0;
  for (int k = i + 1; k <= j; ++k) {
    const Flat to = plane.flat(nodes[k]);
    count += rayCrosses(from, to) ? 1 : 0;
    from = to;
  }
  count += rayCrosses(from, crossing) ? 1 : 0;
  return count % 2 == 1;
}

}  // namespace

ToolLoop findToolLoop(std::span<const Vec3> touching, const ToolAxis& axis, double reach) {
  const Plane plane(axis);
  ToolLoop found;
  const int pairs = static_cast<int>(touching.size()) - 1;
  for (int i = 0; i < pairs; ++i)
    for (int j = i + 2; j < pairs; ++j) {
      double s = 0.0;                          // [1]
      if (!meet(plane.flat(touching[i]), plane.flat(touching[i + 1]), plane.flat(touching[j]), plane.flat(touching[j + 1]), s)) continue;
      const bool closed = (touching[i + 1] - touching[j]).squaredNorm() <= reach * reach;
      const ToolLoop loop{i + 1, j, true, axisInside(touching, plane, i, j, s), closed};
      if (loop.valid()) return loop;
      if (!found.encirclesTool) found = loop;
    }
  return found;
}

int turnsAbout(std::span<const Vec3> nodes, const ToolAxis& axis) {
  const Plane plane(axis);
  int turns = 0;
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const Flat a = plane.flat(nodes[k]), b = plane.flat(nodes[k + 1]);
    if (rayCrosses(a, b)) turns += b.y > a.y ? 1 : -1;
  }
  return turns;
}

}  // namespace halsted
