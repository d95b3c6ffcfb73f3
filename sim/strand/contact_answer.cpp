#include "sim/strand/contact_answer.h"

namespace halsted {
namespace {

constexpr double kBond = 0.7;                  // [1] stiffness of the friction bond over that of the squeeze (Mindlin, nu = 0.4)

}  // namespace

Vec3 relativePoint(const std::vector<Vec3>& x, const TouchingPoint& c, const ToolBorder& border) {
  const Vec3 own = curvePoint(x, c.sample);
  if (!c.solid) return own - curvePoint(x, c.partner);
  return c.owner < 0 ? Vec3(own - c.anchor) : Vec3(own - c.anchor - border.tool[c.owner].shift);
}

bool answerAt(const Vec3& relative, TouchingPoint& c, ContactAnswer& out) {   // [m]
  const double squeeze = c.reach - c.normal.dot(relative);   // [m]
  c.normalForce = 0.0;
  c.friction.setZero();
  if (squeeze <= 0.0) return false;
  // A squeezed braid stiffens; this keeps the centre lines apart up to the load at which thread breaks.
  const double soft = c.reach < 1e-3 ? 2.0 * squeeze / c.reach : 0.0;   // [1]
  c.normalForce = c.stiffness * squeeze * (1.0 + soft * soft);
  const double bond = kBond * c.stiffness;                   // [N/m]
  Vec3 slide = relative - c.start;
  slide -= slide.dot(c.normal) * c.normal;
  c.friction = c.carried - bond * slide;
  const double size = c.friction.norm(), limit = c.coefficient * c.normalForce;   // [N]
  const double share = size > limit ? limit / size : 1.0;    // [1]
  c.friction *= share;
  const Mat3 nn = c.normal * c.normal.transpose();
  out.force = c.normalForce * c.normal + c.friction;
  out.stiffness = c.stiffness * (1.0 + 3.0 * soft * soft) * nn + share * bond * (Mat3::Identity() - nn);
  return true;
}

}  // namespace halsted
