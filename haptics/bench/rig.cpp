#include "haptics/bench/rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halsted::haptics::bench {

namespace {

LocalContact planeContact(const ToolSample& sample, double surface) {  // [m]
  LocalContact contact;
  contact.position = sample.pose.position;
  contact.touching = true;
  contact.planeCount = 1;
  contact.planes[0] = {Vec3(sample.pose.position.x(), surface, sample.pose.position.z()), Vec3::UnitY()};
  return contact;
}

}  // namespace

LocalContact SpringWall::step(const ToolSample& sample, double) const {
  const double depth = -sample.pose.position.y();  // [m]
  LocalContact contact;
  contact.position = sample.pose.position;
  if (depth <= -lookAhead) return contact;
  contact = planeContact(sample, 0.0);
  contact.touching = depth > 0.0;
  contact.ahead = !contact.touching;
  contact.force.y() = std::max(0.0, stiffness * depth);
  contact.stiffness(1, 1) = stiffness;
  contact.damping(1, 1) = damping;
  return contact;
}

LocalContact SoftTissue::step(const ToolSample& sample, double dt) {  // [s]
  const double tool = sample.pose.position.y(), toolVelocity = sample.velocity.y();  // [m] [m/s]
  double force = coupling * (y - tool) + couplingDamping * (velocity - toolVelocity);  // [N] on the tool
  const bool touching = y > tool && force > 0.0;
  if (!touching) force = 0.0;
  constexpr int kSubsteps = 10;
  for (int i = 0; i < kSubsteps; ++i) {
    const double h = dt / kSubsteps;  // [s]
    if (touching) force = std::max(0.0, coupling * (y - tool) + couplingDamping * (velocity - toolVelocity));
    velocity += h / mass * (-stiffness * y - damping * velocity - force);
    y += h * velocity;
  }
  LocalContact none;
  none.position = sample.pose.position;
  if (!touching) return none;
  LocalContact contact = planeContact(sample, y);
  // The damper acts in the model, so the published force is the spring's.
  contact.force.y() = std::max(0.0, coupling * (y - tool));
  contact.stiffness(1, 1) = coupling * stiffness / (coupling + stiffness);
  contact.damping(1, 1) = couplingDamping;
  return contact;
}

namespace {

/// A device whose motors get each force some ticks late, as behind a slow cable.
class LateForce final : public Device {
 public:
  explicit LateForce(Rig& rig) noexcept : rig_(rig) {}
  DeviceReading read(double dt) noexcept override { return rig_.device.read(dt); }   // [s]
  bool write(const Vec3& force) noexcept override {                                   // [N]
    const auto ticks = static_cast<std::uint64_t>(rig_.forceDelay);
    rig_.lateForces[rig_.index % Rig::kLine] = force;
    rig_.held = rig_.index > ticks ? rig_.lateForces[(rig_.index - ticks) % Rig::kLine] : Vec3(Vec3::Zero());
    return rig_.device.write(rig_.held);
  }
  void setTarget(const HandTarget& target) noexcept override { rig_.device.setTarget(target); }
  DeviceLimits limits() const noexcept override { return rig_.device.limits(); }
  const char* kind() const noexcept override { return rig_.device.kind(); }

 private:
  Rig& rig_;
};

}  // namespace

void Rig::tickOnly() noexcept {
  const Vec3 before = output.force, motor = held, from = device.position();
  LateForce late(*this);
  tick(late, config, contact, target, ++index, state, output);
  energyTaken -= motor.dot(device.position() - from);
  leastEnergy = std::min(leastEnergy, energyTaken);
  largestStep = std::max(largestStep, (output.force - before).norm());
  peak = std::max(peak, output.force.norm());
}

double rmsAbove30Hz(const std::vector<double>& values, double rate, std::size_t skip) {  // [N] [Hz]
  const double warped = std::tan(std::numbers::pi * 30.0 / rate);  // [1]
  const double scale = 1.0 / (1.0 + std::numbers::sqrt2 * warped + warped * warped);  // [1]
  const double a1 = 2.0 * (warped * warped - 1.0) * scale;                            // [1]
  const double a2 = (1.0 - std::numbers::sqrt2 * warped + warped * warped) * scale;   // [1]
  double x1 = values.front(), x2 = x1, y1 = 0.0, y2 = 0.0, sum = 0.0;                 // [N], sum [N^2]
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double out = scale * (values[i] - 2.0 * x1 + x2) - a1 * y1 - a2 * y2;       // [N]
    x2 = x1, x1 = values[i], y2 = y1, y1 = out;
    if (i >= skip) sum += out * out;
  }
  return std::sqrt(sum / static_cast<double>(values.size() - skip));
}

}  // namespace halsted::haptics::bench
