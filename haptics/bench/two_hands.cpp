/// 2: both hands stir at random in real tissue; what each device was given that it had not put in.
#include <algorithm>
#include <memory>

#include "haptics/bench/bench.h"
#include "sim/step.h"

namespace halsted::haptics::bench {

namespace {

constexpr double kCreated = 1e-4;              // [J] devices.md

/// Where a random hand goes: a new place, turn and jaw every quarter of a second or so.
class Wanderer {
 public:
  Wanderer(const Pose& start, std::uint64_t seed) : start_(start), state_(seed) { target_.pose = start; }

  const HandTarget& next() {
    if (left_-- > 0) return target_;
    left_ = 250 + static_cast<int>(150.0 * uniform());
    target_.valid = true;
    const double z = uniform(), y = uniform(), x = uniform();    // [1] one after the other: a call's arguments are drawn in no fixed order
    target_.pose.position = Vec3(22e-3 * x, 22e-3 * y, 12e-3 * z);   // [m] about the opening
    const double k = uniform(), j = uniform(), i = uniform();    // [1]
    const Quat turn(3.0, i, j, k);
    target_.pose.orientation = (turn.normalized() * start_.orientation).normalized();
    target_.jaw = uniform() > 0.0 ? 1.0 : 0.0;
    return target_;
  }

 private:
  double uniform() {                           // [1] in [-1, 1)
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state_ >> 11) / 4503599627370496.0 - 1.0;
  }
  Pose start_;
  HandTarget target_;
  std::uint64_t state_;
  int left_ = 0;
};

/// One hand at its device, with the books of the energy that went through it.
struct Stirrer {
  Stirrer(const Pose& start, const HandLoopConfig& c, std::uint64_t seed)
      : config(c), device(toDevice(c.mapping, start), TouchDynamics{}, threeHands()[1].dynamics), wanderer(start, seed) {
    state.lastPosition = start.position;
    state.lastOrientation = start.orientation;
  }

  /// What the simulation says that its tool took: exact for a force that is linear between its steps, and free of hold, blend and age.
  void follow(const LocalContact& contact) {
    if (contact.step == 0) return;
    inPhysics -= 0.5 * (contact.force + lastForce).dot(contact.position - lastPosition) / config.mapping.scale;
    lastForce = contact.force;
    lastPosition = contact.position;
  }

  void tick(const LocalContact& contact, std::uint64_t index) {
    const Vec3 motor = config.mapping.origin.orientation.conjugate() * output.force, from = device.position();
    haptics::tick(device, config, contact, wanderer.next(), index, state, output);
    taken -= motor.dot(device.position() - from);
    follow(contact);
    least = std::min(least, taken);
    if (!state.model.touching && output.force == Vec3::Zero()) atTouch = highest = taken, physicsAtTouch = inPhysics;
    highest = std::max(highest, taken);
    const double given = atTouch - taken, owed = std::max(0.0, physicsAtTouch - inPhysics);   // [J]
    delivered = std::max(delivered, given);
    created = std::max(created, given - owed);
    returned = std::max(returned, highest - taken);
    touching += contact.touching;
    peak = std::max(peak, output.force.norm());
    damped += (output.faults & kFaultPassivity) != 0;
  }

  HandLoopConfig config;
  VirtualDevice device;
  Wanderer wanderer;
  HandLoopState state;
  HandLoopOutput output;
  double taken = 0.0, least = 0.0;             // [J] by the forces from the hand; the least that it ever was
  double inPhysics = 0.0;                      // [J] by the simulated tool
  double atTouch = 0.0, physicsAtTouch = 0.0, highest = 0.0;       // [J] both when this contact began; most of `taken` since
  double created = 0.0, delivered = 0.0, returned = 0.0;           // [J] largest of any contact, see the rows
  Vec3 lastForce = Vec3::Zero(), lastPosition = Vec3::Zero();      // [N] [m] of the last step
  double peak = 0.0;                           // [N]
  int touching = 0, damped = 0;                // ticks
};

}  // namespace

Measurements measureTwoHands(const Model& model, const std::array<Pose, kHands>& start, const HandLoopConfig& config, double seconds,
                             std::uint64_t seed, const std::function<void(double)>& progress) {
  State state = initialState(model, start);
  StepInput input;
  const auto output = std::make_unique<StepOutput>();
  Stirrer hands[kHands] = {{start[kLeft], config, 2 * seed + 1}, {start[kRight], config, 2 * seed + 2}};
  const int ticks = static_cast<int>(seconds / config.period + 0.5);
  for (int i = 0; i < ticks; ++i) {
    for (int hand = 0; hand < kHands; ++hand) {
      hands[hand].tick(output->contact[hand], static_cast<std::uint64_t>(i));
      input.tools[hand] = hands[hand].output.sample;
    }
    step(model, input, state, *output);
    if (progress && i % 100 == 0) progress(i * config.period);
  }
  Measurements all;
  for (const Stirrer& hand : hands) {
    const std::string condition = std::string(&hand == hands ? "left" : "right") + " hand, " + std::to_string(static_cast<int>(seconds)) + " s, seed " + std::to_string(seed);
    all.push_back({"most energy ever created", condition, -hand.least, "J", Bound::kAtMost, kCreated});
    all.push_back({"most created within a contact", condition, hand.created, "J", Bound::kAtMost, kCreated});
    all.push_back({"most a contact gave with what others put in", condition, hand.delivered, "J"});
    all.push_back({"most given back within a contact", condition, hand.returned, "J"});
    all.push_back({"energy left in the tissue", condition, hand.taken, "J"});
    all.push_back({"time in contact", condition, hand.touching * config.period, "s", Bound::kAtLeast, 0.1 * seconds});
    all.push_back({"time with damping added", condition, hand.damped * config.period, "s"});
    all.push_back({"largest force", condition, hand.peak, "N", Bound::kAtMost, 3.3 + 1e-9});
  }
  return all;
}

}  // namespace halsted::haptics::bench
