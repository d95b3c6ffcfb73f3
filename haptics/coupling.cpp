#include "haptics/coupling.h"

#include <algorithm>
#include <cmath>

#include "haptics/limits.h"

namespace halsted::haptics {

namespace {

constexpr int kPlaneSweeps = 4;  // two planes settle in one sweep when square, three in a few when they are not

int planeCount(const LocalContact& contact) noexcept { return std::clamp(contact.planeCount, 0, LocalContact::kMaxPlanes); }

/// Largest row sum of absolute values: never below the largest eigenvalue.
double stiffnessBound(const Mat3& k) noexcept {
  double bound = 0.0;  // [N/m]
  for (int row = 0; row < 3; ++row) bound = std::max(bound, std::abs(k(row, 0)) + std::abs(k(row, 1)) + std::abs(k(row, 2)));
  return bound;
}

}  // namespace

Vec3 withoutAdhesion(const LocalContact& contact, const Vec3& force, const Vec3& last, double step) noexcept {  // [N] all
  Vec3 kept = force;
  for (int sweep = 0; sweep < kPlaneSweeps; ++sweep) {
    for (int i = 0; i < planeCount(contact); ++i) {
      const Vec3& normal = contact.planes[i].normal;
      const double floor = std::min(0.0, last.dot(normal) + step);  // [N]
      const double along = kept.dot(normal);                       // [N]
      if (along < floor) kept += normal * (floor - along);
    }
  }
  return kept;
}

Vec3 modelForce(const LocalContact& contact, const Vec3& x, const Vec3& v, double stiffnessCap) noexcept {  // [m] [m/s] [N/m]
  if (!contact.touching) return Vec3::Zero();
  const double bound = stiffnessBound(contact.stiffness);               // [N/m]
  const double share = bound > stiffnessCap ? stiffnessCap / bound : 1.0;  // [1]
  const Vec3 force = contact.force - contact.stiffness * (x - contact.position) * share - contact.damping * v;
  return withoutAdhesion(contact, force, Vec3::Zero(), 0.0);
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

double observeEnergy(double energy, const Vec3& heldForce, const Vec3& moved, double dt,
                     const PassivityConfig& config) noexcept {  // energy [J], dt [s]
  const double taken = -heldForce.dot(moved);                     // [J]
  double next = std::min(config.storage, energy + taken);         // [J]
  if (next < 0.0) next -= next * std::min(1.0, dt / config.forget);
  if (!std::isfinite(next) || std::abs(next) < 1e-15) return 0.0;  // hostile input or the way to denormals
  return next;
}

Vec3 passivityDamping(double energy, const Vec3& v, double dt, const PassivityConfig& config) noexcept {  // [J] [m/s] [s]
  const double speedSquared = v.dot(v);  // [m^2/s^2]
  if (energy >= 0.0 || !(speedSquared > config.minSpeed * config.minSpeed)) return Vec3::Zero();
  const double damping = std::min(config.maxDamping, -energy / (dt * speedSquared));  // [N s/m]
  return clampLength(-damping * v, config.maxForce);
}

}  // namespace halsted::haptics
