#include "scenes/hand_motion.h"

#include <cmath>

namespace halsted::scenes {
namespace {

constexpr double kLookGain = 4.0;              // [1/s] a visual correction takes a quarter of a second
constexpr double kLookLimit = 6e-3;            // [m] nobody aims farther past what he sees

}  // namespace

bool travel(HandMotion& h, const Pose& goal, double speed, double turn, double dt) {
  const Vec3 way = goal.position - h.command.position;
  const double distance = way.norm(), step = speed * dt;
  const bool there = distance <= step;
  h.command.position = there ? goal.position : Vec3(h.command.position + step / distance * way);
  Quat rest = goal.orientation * h.command.orientation.conjugate();
  if (rest.w() < 0.0) rest.coeffs() = -rest.coeffs();
  const double half = std::sqrt(rest.x() * rest.x() + rest.y() * rest.y() + rest.z() * rest.z());   // sine of half the angle
  const double halfStep = 0.5 * turn * dt;     // [rad]
  if (half <= halfStep) {
    h.command.orientation = goal.orientation;
    return there;
  }
  const double share = halfStep / half;        // a small turn about the same axis
  const Quat small(1.0, share * rest.x(), share * rest.y(), share * rest.z());
  h.command.orientation = (small * h.command.orientation).normalized();
  return false;
}

HandTarget look(HandMotion& h, const Pose& seen, double dt) {
  h.correction += kLookGain * dt * (h.command.position - seen.position);
  const double size = h.correction.norm();
  if (size > kLookLimit) h.correction *= kLookLimit / size;
  return {{h.command.position + h.correction, h.command.orientation}, h.jaw, true};
}

}  // namespace halsted::scenes
