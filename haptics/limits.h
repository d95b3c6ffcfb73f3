#pragma once
/// What a force must pass on its way to a device, in this order: finite, rate, magnitude, thermal, fault (DESIGN 8).
/// Pure functions on one hand's own state; haptic thread; noexcept, bounded, no heap, lock or log. They report in bits.
#include <cstdint>

#include "haptics/device.h"

namespace halsted::haptics {

/// Bits of HandLoopOutput::faults. The first six cut the force; the others say which limit shaped it.
enum FaultCode : std::uint32_t {
  kFaultNone = 0,
  kFaultNonFinite = 1u << 0,                   // NaN or infinity in the model: force is zero in the same tick
  kFaultBadReading = 1u << 1,                  // NaN or infinity from the device: the last good position stands, force zero
  kFaultDeviceGone = 1u << 2,                  // not connected, or it refused the force
  kFaultVelocity = 1u << 3,                    // faster than a hand: force cut, then ramped in again
  kFaultStale = 1u << 4,                       // physics stalled: force is fading or zero
  kFaultDeviceSilent = 1u << 5,                // a transfer failed, or no reading for 10 ms: the last good position stands, force zero
  kFaultRate = 1u << 8,                        // limited: change per millisecond
  kFaultMagnitude = 1u << 9,                   // limited: the device's peak
  kFaultThermal = 1u << 10,                    // limited: the motors are warm
  kFaultPassivity = 1u << 11,                  // damping added: the loop had given more energy than it took
};
inline constexpr std::uint32_t kFaultCutMask = 0xff;

/// "non-finite force", ... for the recorder and the panels; one bit at a time.
const char* faultName(FaultCode) noexcept;

struct LimitConfig {
  double rate = 1000.0;                        // [N/s] 1 N/ms lets a puncture pop through; tuned: peak force in 3.3 ms
  double speed = 1.5;                          // [m/s] of the device; tuned: no hand in surgery is near it
  double holdAfterFault = 50e-3;               // [s] force stays zero after a cut
  double ramp = 100e-3;                        // [s] from zero to full force at the start and after a cut
  double thermalTime = 60.0;                   // [s] of the motor's winding and case; tuned: peak force lasts 3 s from cold
  double warm = 0.7;                           // [1] heat at which the derating starts; at 1 only the continuous force is left
};

struct LimitState {
  Vec3 lastForce = Vec3::Zero();               // [N] last force that left, device frame
  double heat = 0.0;                           // [1] 0 cold, 1 warm: the level that the continuous force keeps up for ever
  double hold = 0.0;                           // [s] left of a cut
  double ramp = 0.0;                           // [1] engagement
};

/// Scales `v` to length `limit` when it is longer; exact for any finite vector, also where its square overflows.
Vec3 clampLength(const Vec3& v, double limit) noexcept;                                             // [N]
bool allFinite(const Vec3& v) noexcept;                                                             // [N] or [m]

Vec3 limitFinite(const Vec3& force, std::uint32_t& faults) noexcept;                                // [N] NaN, infinity -> zero
Vec3 limitRate(const Vec3& force, const Vec3& last, double step, std::uint32_t& faults) noexcept;   // [N] [N] [N]
Vec3 limitMagnitude(const Vec3& force, double peak, std::uint32_t& faults) noexcept;                // [N] [N] keeps the direction

/// I2t model: heat follows (F/Fc)^2 with one time constant; from `warm` on the allowed force falls from the peak to Fc.
/// With `heat` at 1 a steady Fc keeps it at 1, so the motors never get warmer than they do at their rated force.
double allowedForce(double heat, const DeviceLimits&, const LimitConfig&) noexcept;                 // [1] -> [N]
Vec3 limitThermal(const Vec3& force, const DeviceLimits&, const LimitConfig&, double heat, std::uint32_t& faults) noexcept;  // [N] [1]
double nextHeat(double heat, const Vec3& force, const DeviceLimits&, const LimitConfig&, double dt) noexcept;  // [1] [N] [s]

/// All of them in order. `faults` holds what the loop already knows (bad reading, device gone, ...) and gains what happens here.
/// `wanted` [N] in the device frame, `dt` [s]. Returns the force to write [N]; a cut is zero in the same tick, whatever the rate says.
Vec3 limitForce(const Vec3& wanted, const DeviceLimits&, const LimitConfig&, double dt, LimitState&, std::uint32_t& faults) noexcept;

}  // namespace halsted::haptics
