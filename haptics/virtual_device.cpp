#include "haptics/virtual_device.h"

#include <algorithm>
#include <cmath>

#include "haptics/limits.h"

namespace halsted::haptics {

namespace {

constexpr double kSubstep = 0.25e-3;   // [s] a tenth of the period of 45 g on stop plus grip
constexpr double kLongestRead = 20e-3; // [s] a longer gap is taken as this one, so that the cost stays bounded

double length(const Vec3& v) noexcept { return std::sqrt(v.dot(v)); }

/// Force of the soft stops: a spring beyond the box, damped on the way out and in, never pulling.
Vec3 stopForce(const TouchDynamics& touch, const Vec3& x, const Vec3& v) noexcept {  // [m] [m/s]
  Vec3 force = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    const double out = x[axis] - touch.workspaceCentre[axis];         // [m]
    const double beyond = std::abs(out) - touch.halfExtent[axis];     // [m]
    if (beyond <= 0.0) continue;
    const double side = out > 0.0 ? 1.0 : -1.0;  // [1]
    force[axis] = -side * std::max(0.0, touch.stopStiffness * beyond + touch.stopDamping * side * v[axis]);
  }
  return force;
}

/// The reading of an encoder: the nearest multiple of the step.
Vec3 quantised(const Vec3& x, double step) noexcept {  // [m] [m]
  if (!(step > 0.0)) return x;
  return {std::floor(x.x() / step + 0.5) * step, std::floor(x.y() / step + 0.5) * step, std::floor(x.z() / step + 0.5) * step};
}

}  // namespace

VirtualDevice::VirtualDevice(const Pose& start, const TouchDynamics& touch, const HandDynamics& hand, const char* kind) noexcept
    : touch_(touch), hand_(hand), kind_(kind), position_(start.position), velocity_(Vec3::Zero()), aim_(start.position),
      aimVelocity_(Vec3::Zero()), visual_(Vec3::Zero()), motor_(Vec3::Zero()), handForce_(Vec3::Zero()),
      orientation_(start.orientation) {
  target_.pose = start;
}

DeviceLimits VirtualDevice::limits() const noexcept {
  return {touch_.peakForce, touch_.continuousForce, touch_.stiffness, touch_.positionStep};
}

void VirtualDevice::setTarget(const HandTarget& target) noexcept {
  if (target.valid && allFinite(target.pose.position) && std::isfinite(target.jaw)) target_ = target;
  else target_.pose.position = aim_;  // the hand holds still: it brakes from where it is
}

bool VirtualDevice::write(const Vec3& force) noexcept {
  motor_ = connected_ && allFinite(force) ? clampLength(force, touch_.peakForce) : Vec3(Vec3::Zero());
  return connected_;
}

DeviceReading VirtualDevice::read(double dt) noexcept {  // [s]
  const double span = dt > 0.0 ? std::min(dt, kLongestRead) : 0.0;            // [s]
  const int substeps = static_cast<int>(std::ceil(span / kSubstep - 1e-9));
  for (int i = 0; i < substeps; ++i) {
    const double h = span / substeps;  // [s]
    moveAim(h);
    look(h);
    moveTip(h);
  }
  turn(span);
  const double wanted = std::clamp(target_.jaw, 0.0, 1.0);                    // [1]
  jaw_ += std::clamp(wanted - jaw_, -hand_.jawRate * span, hand_.jawRate * span);
  return {{quantised(position_, touch_.positionStep), orientation_}, jaw_, 0, connected_};
}

void VirtualDevice::moveAim(double h) noexcept {  // [s]
  const Vec3 toGo = target_.pose.position - aim_;
  const double distance = length(toGo);  // [m]
  Vec3 wanted = Vec3::Zero();            // [m/s]
  if (distance > 1e-9) {
    // Near: first order. Farther: the speed from which half the acceleration brakes to the target. Farthest: the hand's own limit.
    const double speed = std::min({distance / hand_.aimTime, std::sqrt(hand_.maxAcceleration * distance), hand_.maxSpeed});
    wanted = toGo * (speed / distance);
  }
  aimVelocity_ += clampLength(wanted - aimVelocity_, hand_.maxAcceleration * h);
  aim_ += aimVelocity_ * h;
}

void VirtualDevice::look(double h) noexcept {  // [s]
  const Vec3 error = aim_ - position_;
  if (length(error) < hand_.visualDeadband) return;
  visual_ = clampLength(visual_ + error * (hand_.visualGain * h), hand_.visualForce);
}

void VirtualDevice::moveTip(double h) noexcept {  // [s]
  // Springs act where the tip is, dampers on the velocity that the step ends with (semi-implicit: stable for any damping).
  handForce_ = (aim_ - position_) * hand_.stiffness + (aimVelocity_ - velocity_) * hand_.damping + visual_;
  const Vec3 force = motor_ + stopForce(touch_, position_, velocity_) + handForce_ + velocity_ * hand_.damping;
  const double mass = touch_.mass + hand_.mass;                                  // [kg]
  const double inertia = mass + h * (hand_.damping + touch_.viscosity);          // [kg]
  Vec3 next = (velocity_ * mass + force * h) / inertia;

  // Coulomb friction takes away speed until there is none: it holds exactly below its threshold and never pushes back.
  const double loss = touch_.friction * h / inertia;  // [m/s]
  const double speed = length(next);                  // [m/s]
  next = speed > loss ? Vec3(next * (1.0 - loss / speed)) : Vec3(Vec3::Zero());
  velocity_ = next;
  position_ += velocity_ * h;
}

void VirtualDevice::turn(double dt) noexcept {  // [s]
  Quat goal = target_.pose.orientation;
  const double size = goal.squaredNorm();  // [1]
  if (!(size > 0.25 && size < 4.0) || !(dt > 0.0)) return;
  goal.coeffs() /= std::sqrt(size);
  if (goal.dot(orientation_) < 0.0) goal.coeffs() = -goal.coeffs();

  // A step along the chord, at most `maxTurnRate`: the chord of two unit quaternions is half the angle for small ones.
  const Eigen::Vector4d chord = goal.coeffs() - orientation_.coeffs();
  const double chordLength = std::sqrt(chord.dot(chord));  // [1]
  if (!(chordLength > 1e-12)) return;
  const double share = std::min(dt / (hand_.turnTime + dt), hand_.maxTurnRate * dt / (2.0 * chordLength));
  orientation_.coeffs() += chord * share;
  orientation_.coeffs() /= std::sqrt(orientation_.squaredNorm());
}

}  // namespace halsted::haptics
