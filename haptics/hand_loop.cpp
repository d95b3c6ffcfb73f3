#include "haptics/hand_loop.h"

#include <algorithm>
#include <cmath>

namespace halsted::haptics {

Pose toWorld(const WorkspaceMapping& mapping, const Pose& device) noexcept {
  return {mapping.origin.apply(device.position * mapping.scale), mapping.origin.orientation * device.orientation};
}

Pose toDevice(const WorkspaceMapping& mapping, const Pose& world) noexcept {
  return {mapping.origin.inverseApply(world.position) / mapping.scale, mapping.origin.orientation.conjugate() * world.orientation};
}

namespace {

constexpr double kLargestReading = 1.0;  // [m] no device reaches farther: a larger number is a broken one

/// A usable pose: finite, within reach of a device, and a quaternion long enough to be normalised.
bool usablePose(const Pose& pose) noexcept {
  const double size = pose.orientation.squaredNorm();  // [1]
  return allFinite(pose.position) && pose.position.cwiseAbs().maxCoeff() < kLargestReading && size > 0.25 && size < 4.0;
}

constexpr std::uint64_t kMaxPeriods = 20;  // longest gap that is taken at its length

double usableJaw(double jaw) noexcept { return jaw >= 0.0 ? std::min(jaw, 1.0) : 0.0; }  // [1] NaN closes

void sendTarget(Device& device, const WorkspaceMapping& mapping, const HandTarget& target) noexcept {
  HandTarget local = target;
  if (target.valid) local.pose = toDevice(mapping, target.pose);
  local.valid = target.valid && usablePose(local.pose);
  device.setTarget(local);
}

/// The reading in the world, or the last good one with a fault.
Pose readPose(const DeviceReading& reading, const HandLoopConfig& config, const HandLoopState& state,
              std::uint32_t& faults) noexcept {
  if (!reading.connected) faults |= kFaultDeviceGone;
  else if (!reading.fresh) faults |= kFaultDeviceSilent;
  else if (usablePose(reading.pose)) return toWorld(config.mapping, reading.pose);
  else faults |= kFaultBadReading;
  return {state.lastPosition, state.lastOrientation};
}

/// A device that comes back is somewhere else than its tool. The tool does not jump there through the tissue: it goes, slowly.
Vec3 rejoined(const HandLoopConfig& config, const Vec3& device, double dt, std::uint32_t faults, HandLoopState& state) noexcept {  // [m] [s]
  const bool away = (faults & (kFaultDeviceGone | kFaultDeviceSilent)) != 0;
  const bool back = state.away && !away;
  state.away = away;
  if (away || (faults & kFaultBadReading) != 0) return device;   // stands where it was, on its way or not
  if (back) state.rejoin = state.lastPosition - device;
  if (state.rejoin == Vec3::Zero()) return device;               // to the bit
  const double left = std::sqrt(state.rejoin.dot(state.rejoin));  // [m]
  const double step = config.rejoinSpeed * dt;                    // [m]
  state.rejoin = left > step ? Vec3(state.rejoin * (1.0 - step / left)) : Vec3(Vec3::Zero());
  return device + state.rejoin;
}

/// First-order filter on the difference of positions; its last trace is cut off before it reaches denormals.
Vec3 filterVelocity(const HandLoopConfig& config, const HandLoopState& state, const Vec3& moved, double dt) noexcept {  // [m] [s]
  const double share = dt / (config.velocityTime + dt);  // [1]
  const Vec3 next = state.velocity + (moved / dt - state.velocity) * share;
  return next.dot(next) > 1e-18 ? next : Vec3(Vec3::Zero());
}

double modelFreshness(const HandLoopConfig& config, const HandLoopState& state) noexcept {
  return freshness(static_cast<double>(state.ageTicks) * config.period, config.fadeAfter, config.fadeOver);
}

/// What the way from the last position to this one changes in the force of the model in use.
Vec3 modelDrift(const HandLoopState& state, const Vec3& position) noexcept {  // [m]
  if (!state.started) return Vec3::Zero();
  const Vec3 here = modelForce(state.model, position, state.velocity, state.caps);
  const Vec3 change = here - modelForce(state.model, state.lastPosition, state.velocity, state.caps);
  return allFinite(change) ? change : Vec3(Vec3::Zero());
}

/// Takes the pull out of a force, beside what was rendered in the last tick.
Vec3 pushOnly(const HandLoopConfig& config, const HandLoopState& state, const Vec3& force) noexcept {  // [N]
  return withoutAdhesion(state.model, force, carriedOn(state.model, state.lastRendered, state.drift), config.blendStep);
}

/// What the model in use and the blend say here and now.
Vec3 currentForce(const HandLoopConfig& config, const HandLoopState& state, const Vec3& position) noexcept {  // [m]
  const Vec3 model = modelForce(state.model, position, state.velocity, state.caps);
  return (model + state.offset) * modelFreshness(config, state);
}

/// A new step replaces the model. What that would change in this instant goes into the offset, and from there decays.
/// A puncture is meant to be felt: it jumps.
void takeModel(const LocalContact& contact, const HandLoopConfig& config, const Vec3& position, HandLoopState& state) noexcept {
  state.offset = decayedOffset(state.offset, config.blendStep, config.blendShare);
  state.replaced = false;
  if (contact.step == state.lastStep) return;
  state.lastStep = contact.step;
  state.modelUsable = usable(contact);
  if (!state.modelUsable) return;
  const Vec3 before = pushOnly(config, state, currentForce(config, state, position));
  const Vec3 after = modelForce(contact, position, state.velocity, state.caps);
  state.offset = contact.puncture || !allFinite(before - after) ? Vec3(Vec3::Zero()) : Vec3(before - after);
  state.replaced = !contact.puncture && allFinite(before);
  state.before = before;
  state.model = contact;
  state.ageTicks = 1;
}

bool pulls(const LocalContact& model, const Vec3& force) noexcept {  // [N]
  constexpr double kTrace = 1e-9;              // [N]
  const Vec3 pull = force - withoutAdhesion(model, force, Vec3::Zero(), 0.0);
  return pull.dot(pull) > kTrace * kTrace;
}

/// No new model changes the force by more than a step: the blend fades as the old planes had it and pull is taken out as the new ones have it, each by a step
/// at most, and where their normals differ both together went to twice that (0.083 N, as a hand left a wall that it had pinched). But what leaves never sticks.
Vec3 withinAStep(const HandLoopConfig& config, const HandLoopState& state, const Vec3& before, const Vec3& force) noexcept {  // [N]
  const Vec3 change = force - before;          // [N]
  if (!state.replaced || !(change.dot(change) > config.blendStep * config.blendStep)) return force;
  const Vec3 near = before + clampLength(change, config.blendStep);
  return pulls(state.model, near) && !pulls(state.model, force) ? force : near;
}

/// The wanted force before the limits; never more adhesive than a tick ago. What is taken out as adhesion is taken out of the
/// blend and of the damping too, so that it does not come back.
Vec3 renderForce(const HandLoopConfig& config, const Vec3& position, HandLoopState& state) noexcept {  // [m]
  const Vec3 blended = currentForce(config, state, position);
  const Vec3 force = withinAStep(config, state, state.before, pushOnly(config, state, blended));
  const Vec3 damped = withinAStep(config, state, state.before + state.passiveForce, pushOnly(config, state, force + state.passiveForce));
  if (!allFinite(damped)) {  // a model of finite numbers whose force overflows: limitForce cuts it, and nothing of it is kept
    state.offset = state.passiveForce = state.lastRendered = Vec3::Zero();
    return damped;
  }
  state.offset += force - blended;
  state.passiveForce = damped - force;
  state.lastRendered = damped;
  return damped;
}

/// Damping that pays an energy deficit back, in the world. Energy counts at the device, where `scale` has shrunk the motion.
void keepPassive(const HandLoopConfig& config, const Vec3& moved, double dt, double count, HandLoopState& state,
                 std::uint32_t& faults) noexcept {  // moved [m], dt [s], count [m] of the encoder
  const double scale = config.mapping.scale;  // [1]
  state.observedEnergy = observeEnergy(state.observedEnergy, state.lastForce, moved / scale, dt, config.passivity);
  Vec3 wanted = Vec3::Zero();
  if (state.model.touching) {
    // A force held from count to count takes half a count less of the hand on its way in: that alone is no reason to speak.
    const double uncounted = count * std::sqrt(state.lastForce.dot(state.lastForce));  // [J]
    const double stored = heldEnergy(state.model.stiffness, state.lastForce) / scale;  // [J]
    const double owed = state.lastForce.dot(moved) > 0.0 ? std::max(0.0, stored - uncounted) : 0.0;  // [J]
    wanted = passivityDamping(state.observedEnergy - owed, state.velocity / scale, dt, config.passivity);
  }
  state.passiveForce += clampLength(wanted - state.passiveForce, config.passivity.forceStep);
  if (state.passiveForce != Vec3::Zero()) faults |= kFaultPassivity;
}

}  // namespace

void tick(Device& device, const HandLoopConfig& config, const LocalContact& contact, const HandTarget& target,
          std::uint64_t tickIndex, HandLoopState& state, HandLoopOutput& output) noexcept {
  // Skipped periods show in the index; a long gap is taken as a short one so that the cost stays bounded.
  const std::uint64_t periods = state.started ? std::clamp<std::uint64_t>(tickIndex - state.lastTick, 1, kMaxPeriods) : 1;
  const double dt = static_cast<double>(periods) * config.period;  // [s]
  state.lastTick = tickIndex;

  std::uint32_t faults = 0;
  sendTarget(device, config.mapping, target);
  const DeviceReading reading = device.read(dt);
  Pose pose = readPose(reading, config, state, faults);
  pose.position = rejoined(config, pose.position, dt, faults, state);
  const Vec3 moved = state.started ? Vec3(pose.position - state.lastPosition) : Vec3(Vec3::Zero());  // [m]
  state.velocity = filterVelocity(config, state, moved, dt);
  if (state.velocity.norm() > config.limits.speed * config.mapping.scale) faults |= kFaultVelocity;

  const DeviceLimits able = device.limits();
  state.caps = couplingCaps(config.caps, able, config.mapping.scale);
  state.ageTicks += periods;
  state.drift = modelDrift(state, pose.position);
  takeModel(contact, config, pose.position, state);
  keepPassive(config, moved, dt, able.positionStep, state, faults);
  if (!state.modelUsable) faults |= kFaultNonFinite;
  output.stale = static_cast<double>(state.ageTicks) * config.period > config.fadeAfter;
  if (output.stale) faults |= kFaultStale;
  const Vec3 wanted = renderForce(config, pose.position, state);

  const Quat& frame = config.mapping.origin.orientation;
  const Vec3 sent = limitForce(frame.conjugate() * wanted, able, config.limits, dt, state.limits, faults);
  if (!device.write(sent)) faults |= kFaultDeviceGone;

  state.lastForce = frame * sent;
  state.lastPosition = pose.position;
  state.lastOrientation = pose.orientation;
  state.started = true;
  output.sample = {tickIndex, pose, state.velocity, usableJaw(reading.jaw), reading.presses};
  output.force = state.lastForce;
  output.faults = faults;
}

}  // namespace halsted::haptics
