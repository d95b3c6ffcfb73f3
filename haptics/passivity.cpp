#include "haptics/passivity.h"

#include <algorithm>
#include <cmath>

#include "haptics/limits.h"

namespace halsted::haptics {

namespace {
/// From this speed on all of the damping is there. What holding a force from tick to tick creates grows with the square of the speed;
/// what comes in slowly is another hand's work, or counts.
constexpr double kFullSpeed = 0.05;            // [m/s]
}  // namespace

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
  const double most = config.maxDamping * std::min(1.0, std::sqrt(speedSquared) / kFullSpeed);  // [N s/m]
  const double damping = std::min(most, -energy / (dt * speedSquared));                          // [N s/m]
  return clampLength(-damping * v, config.maxForce);
}

double heldEnergy(const Mat3& stiffness, const Vec3& force) noexcept {  // [N/m] [N]
  const double stiff = force.dot(stiffness * force), size = force.dot(force);  // [N^3/m] [N^2]
  return stiff > size ? 0.5 * size * size / stiff : 0.0;  // softer than 1 N/m holds nothing that could come back
}

}  // namespace halsted::haptics
