#include "haptics/limits.h"

#include <algorithm>
#include <cmath>

namespace halsted::haptics {

const char* faultName(FaultCode code) noexcept {
  switch (code) {
    case kFaultNone: return "none";
    case kFaultNonFinite: return "non-finite force";
    case kFaultBadReading: return "bad device reading";
    case kFaultDeviceGone: return "device gone";
    case kFaultVelocity: return "device too fast";
    case kFaultStale: return "physics stalled";
    case kFaultDeviceSilent: return "device silent";
    case kFaultRate: return "rate limited";
    case kFaultMagnitude: return "peak limited";
    case kFaultThermal: return "motors warm";
    case kFaultPassivity: return "damping added";
  }
  return "unknown fault";
}

bool allFinite(const Vec3& v) noexcept { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }

Vec3 clampLength(const Vec3& v, double limit) noexcept {
  // Scaled by the largest component first, so that neither the square of 1e200 nor that of 1e-200 spoils the length.
  const double largest = std::max({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});  // [N]
  if (!(largest > 0.0) || largest * std::sqrt(3.0) <= limit) return v;
  const Vec3 unit = v / largest;
  const double length = std::sqrt(unit.dot(unit));  // [1]
  return length <= limit / largest ? v : Vec3(unit * (limit / length));
}

Vec3 limitFinite(const Vec3& force, std::uint32_t& faults) noexcept {
  if (allFinite(force)) return force;
  faults |= kFaultNonFinite;
  return Vec3::Zero();
}

Vec3 limitRate(const Vec3& force, const Vec3& last, double step, std::uint32_t& faults) noexcept {
  const Vec3 change = force - last;
  const Vec3 allowed = clampLength(change, step);
  if (allowed == change) return force;
  faults |= kFaultRate;
  return last + allowed;
}

Vec3 limitMagnitude(const Vec3& force, double peak, std::uint32_t& faults) noexcept {
  const Vec3 allowed = clampLength(force, peak);
  if (allowed != force) faults |= kFaultMagnitude;
  return allowed;
}

double allowedForce(double heat, const DeviceLimits& device, const LimitConfig& config) noexcept {
  const double warmth = std::clamp((heat - config.warm) / (1.0 - config.warm), 0.0, 1.0);  // [1]
  return device.peakForce - (device.peakForce - device.continuousForce) * warmth;
}

Vec3 limitThermal(const Vec3& force, const DeviceLimits& device, const LimitConfig& config, double heat,
                  std::uint32_t& faults) noexcept {  // heat [1]
  const Vec3 allowed = clampLength(force, allowedForce(heat, device, config));
  if (allowed != force) faults |= kFaultThermal;
  return allowed;
}

double nextHeat(double heat, const Vec3& force, const DeviceLimits& device, const LimitConfig& config,
                double dt) noexcept {  // heat [1], dt [s]
  const double load = force.dot(force) / (device.continuousForce * device.continuousForce);  // [1]
  const double next = heat + (load - heat) * (dt / config.thermalTime);                      // [1]
  return next > 1e-12 ? next : 0.0;  // a decaying heat must not end in denormals
}

namespace {

/// Counts a cut down and ramps the force in afterwards; returns the share of the force that may pass.
double engage(LimitState& state, const LimitConfig& config, double dt, bool cut) noexcept {  // dt [s]
  if (cut) {
    state.hold = config.holdAfterFault;
    state.ramp = 0.0;
  } else if (state.hold > 0.0) {
    state.hold = std::max(0.0, state.hold - dt);
  } else {
    state.ramp = std::min(1.0, state.ramp + dt / config.ramp);
  }
  return state.ramp;
}

}  // namespace

Vec3 limitForce(const Vec3& wanted, const DeviceLimits& device, const LimitConfig& config, double dt, LimitState& state,
                std::uint32_t& faults) noexcept {  // wanted [N], dt [s]
  Vec3 force = limitFinite(wanted, faults);
  force = limitRate(force, state.lastForce, config.rate * dt, faults);
  force = limitMagnitude(force, device.peakForce, faults);
  force = limitThermal(force, device, config, state.heat, faults);

  // Stale models fade before they come here; every other cutting fault is zero now and eases in later.
  const bool cut = (faults & kFaultCutMask & ~static_cast<std::uint32_t>(kFaultStale)) != 0;
  const double share = engage(state, config, dt, cut);  // [1]
  force = cut ? Vec3(Vec3::Zero()) : Vec3(force * share);

  state.heat = nextHeat(state.heat, force, device, config, dt);
  state.lastForce = force;
  return force;
}

}  // namespace halsted::haptics
