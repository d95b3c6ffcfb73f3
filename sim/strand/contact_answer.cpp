#include "sim/strand/contact_answer.h"

namespace halsted {
namespace {

constexpr double kBond = 0.7;                  // [1] stiffness of the friction bond over that of the squeeze (Mindlin, nu = 0.4)

struct Touch {
  double normalForce = 0.0;                    // [N]; 0: they do not touch
  double soft = 0.0, share = 1.0;              // [1] of the squeeze; of the bond that has not given way
  Vec3 friction = Vec3::Zero();                // [N]
};

Touch touchAt(const Vec3& relative, const TouchingPoint& c) {   // [m]
  Touch t;
  const double squeeze = c.reach - c.normal.dot(relative);   // [m]
  if (squeeze <= 0.0) return t;
  // A squeezed braid stiffens; this keeps the centre lines apart up to the load at which thread breaks.
  t.soft = c.reach < 1e-3 ? 2.0 * squeeze / c.reach : 0.0;
  t.normalForce = c.stiffness * squeeze * (1.0 + t.soft * t.soft);
  Vec3 slide = relative - c.start;
  slide -= slide.dot(c.normal) * c.normal;
  t.friction = c.carried - (kBond * c.stiffness) * slide;
  const double size = t.friction.norm(), limit = c.coefficient * t.normalForce;   // [N]
  if (size > limit) t.share = limit / size;
  t.friction *= t.share;
  return t;
}

Vec3 forceOf(const Touch& t, const TouchingPoint& c) { return t.normalForce * c.normal + t.friction; }   // [N]

bool answerOf(const Touch& t, const TouchingPoint& c, ContactAnswer& out) {
  if (t.normalForce == 0.0) return false;
  const Mat3 nn = c.normal * c.normal.transpose();
  out.force = forceOf(t, c);
  out.stiffness = c.stiffness * (1.0 + 3.0 * t.soft * t.soft) * nn + t.share * (kBond * c.stiffness) * (Mat3::Identity() - nn);
  return true;
}

}  // namespace

Vec3 relativePoint(const std::vector<Vec3>& x, const TouchingPoint& c, const GivingTools& hands) {
  const Vec3 own = curvePoint(x, c.sample);
  if (!c.solid) return own - curvePoint(x, c.partner);
  return c.owner < 0 ? Vec3(own - c.anchor) : Vec3(own - c.anchor - hands.tool[c.owner].shift);
}

Vec3 forceAt(const Vec3& relative, const TouchingPoint& c) { return forceOf(touchAt(relative, c), c); }   // [m]

bool wouldAnswer(const Vec3& relative, const TouchingPoint& c, ContactAnswer& out) { return answerOf(touchAt(relative, c), c, out); }   // [m]

bool answerAt(const Vec3& relative, TouchingPoint& c, ContactAnswer& out) {   // [m]
  const Touch t = touchAt(relative, c);
  c.normalForce = t.normalForce;
  c.friction = t.friction;
  return answerOf(t, c, out);
}

}  // namespace halsted
