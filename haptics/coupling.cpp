#include "haptics/coupling.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/limits.h"

namespace halsted::haptics {

namespace {

constexpr double kRounding = 1e-9;  // [N] what a projection may leave of a pull
constexpr int kPlaneSweeps = 64;    // two square planes settle in one sweep, corners in a few; planes 25 degrees apart need some 50
constexpr double kSettled = 1e-7;   // [1] of the force: what a sweep changes less than this has settled

/// A force as pushes along the planes' normals and a rest that none of them can explain (friction, or a pull).
struct PlaneLoad {
  std::array<double, LocalContact::kMaxPlanes> push{};  // [N] never negative
  Vec3 rest;                                            // [N]
};

/// Non-negative least squares by coordinate descent. A tool pinched between two walls is pushed by one of them even where the force
/// points into the other, so a plane must not be judged alone.
PlaneLoad explain(const LocalContact& contact, const Vec3& force) noexcept {
  PlaneLoad load;
  load.rest = force;
  const double settled = kSettled * (std::abs(force.x()) + std::abs(force.y()) + std::abs(force.z()));  // [N]
  double largest = settled + 1.0;  // [N]
  for (int sweep = 0; sweep < kPlaneSweeps && largest > settled; ++sweep) {
    largest = 0.0;
    for (int i = 0; i < contact.planeCount; ++i) {
      const Vec3& normal = contact.planes[i].normal;
      const double change = std::max(-load.push[i], load.rest.dot(normal));  // [N]
      load.push[i] += change;
      load.rest -= change * normal;
      largest = std::max(largest, std::abs(change));
    }
  }
  return load;
}

/// Takes the pull of the planes that pushed when the model was made out of what no plane explains. What is left is never longer than
/// the force was: planes that are nearly parallel would else turn friction into push, and the blend would keep it and feed it back.
Vec3 withoutPull(const LocalContact& contact, const PlaneLoad& made, const Vec3& force) noexcept {
  if (contact.planeCount == 0) return force;
  const Vec3 unexplained = explain(contact, force).rest;
  Vec3 rest = unexplained;
  for (int sweep = 0; sweep < kPlaneSweeps; ++sweep) {
    for (int i = 0; i < contact.planeCount; ++i) {
      const double along = rest.dot(contact.planes[i].normal);  // [N]
      if (made.push[i] > 0.0 && along < 0.0) rest -= contact.planes[i].normal * along;
    }
  }
  return clampLength(force + (rest - unexplained), std::sqrt(force.dot(force)));
}

/// What `gain` must be scaled with so that its largest row sum of absolute values, and with it every eigenvalue, is within `cap`.
double shareWithin(const Mat3& gain, double cap) noexcept {  // [N/m] or [N s/m]
  double bound = 0.0;
  for (int row = 0; row < 3; ++row)
    bound = std::max(bound, std::abs(gain(row, 0)) + std::abs(gain(row, 1)) + std::abs(gain(row, 2)));
  return bound > cap ? cap / bound : 1.0;
}

}  // namespace

Vec3 withoutAdhesion(const LocalContact& contact, const Vec3& force, const Vec3& last, double step) noexcept {  // [N] all
  if (contact.planeCount == 0) return force;
  const PlaneLoad made = explain(contact, contact.force);
  const Vec3 kept = withoutPull(contact, made, force);
  const Vec3 pulled = last - withoutPull(contact, made, last);
  return pulled.dot(pulled) > kRounding * kRounding ? Vec3(last + clampLength(kept - last, step)) : kept;
}

Vec3 carriedOn(const LocalContact& contact, const Vec3& last, const Vec3& drift) noexcept {  // [N] both
  if (contact.planeCount == 0) return last + drift;
  const PlaneLoad made = explain(contact, contact.force);
  const Vec3 kept = withoutPull(contact, made, last);
  return last + (withoutPull(contact, made, kept + drift) - withoutPull(contact, made, kept));
}

CouplingCaps couplingCaps(const CouplingCaps& configured, const DeviceLimits& device, double scale) noexcept {  // [1]
  CouplingCaps caps = configured;
  if (!(caps.stiffness > 0.0)) caps.stiffness = 2.0 * device.stiffness / scale;
  return caps;
}

bool usable(const LocalContact& contact) noexcept {
  if (contact.planeCount < 0 || contact.planeCount > LocalContact::kMaxPlanes) return false;
  for (int i = 0; i < contact.planeCount; ++i) {
    const double size = contact.planes[i].normal.squaredNorm();  // [1]
    if (!(size > 0.99 && size < 1.01) || !allFinite(contact.planes[i].point)) return false;
  }
  return allFinite(contact.position) && allFinite(contact.force) && contact.stiffness.allFinite() && contact.damping.allFinite();
}

namespace {

/// Nothing is touched yet, but the planes are where it would be: beyond one the model's spring pushes back along its normal.
Vec3 onsetForce(const LocalContact& contact, const Vec3& x, double share) noexcept {  // [m] [1]
  Vec3 force = Vec3::Zero();
  for (int i = 0; i < contact.planeCount; ++i) {
    const Vec3& normal = contact.planes[i].normal;
    const double gap = normal.dot(x - contact.planes[i].point);  // [m]
    if (gap < 0.0) force -= normal * (gap * share * normal.dot(contact.stiffness * normal));
  }
  return force;
}

}  // namespace

Vec3 modelForce(const LocalContact& contact, const Vec3& x, const Vec3& v, const CouplingCaps& caps) noexcept {  // [m] [m/s]
  if (!contact.touching && !contact.ahead) return Vec3::Zero();
  if (!contact.touching) return clampLength(onsetForce(contact, x, shareWithin(contact.stiffness, caps.stiffness)), caps.force);
  const Vec3 spring = contact.stiffness * shareWithin(contact.stiffness, caps.stiffness) * (x - contact.position);
  const Vec3 damper = contact.damping * shareWithin(contact.damping, caps.damping) * v;
  return clampLength(withoutAdhesion(contact, contact.force - spring - damper, Vec3::Zero(), 0.0), caps.force);
}

Vec3 decayedOffset(const Vec3& offset, double step, double share) noexcept {  // [N] [N] [1]
  const double length = std::sqrt(offset.dot(offset));  // [N]
  if (!(length > 1e-6)) return Vec3::Zero();
  const double less = std::min(step, length * share);  // [N]
  return offset * (1.0 - less / length);
}

double freshness(double age, double fadeAfter, double fadeOver) noexcept {  // [s] all
  if (age <= fadeAfter) return 1.0;
  if (!(fadeOver > 0.0)) return 0.0;
  return std::clamp(1.0 - (age - fadeAfter) / fadeOver, 0.0, 1.0);
}

}  // namespace halsted::haptics
