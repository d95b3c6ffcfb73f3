#include "app/force_check.h"

#include <atomic>
#include <thread>

#include "app/threads/haptic_thread.h"
#include "haptics/hand_loop.h"

namespace halsted::app {
namespace {

constexpr double kPush = 1.5;                  // [N] half of what a Touch can do for a moment, three times the friction of a Falcon
constexpr double kTooFast = 0.3, kTooFar = 40e-3;   // [m/s] [m] the grip runs away: nobody holds it
constexpr int kRest = 500, kRamp = 100, kHold = 300, kSettle = 400;   // ticks
constexpr double kPatience = 40.0;             // [s] for which pushes are begun again after the transport fell silent: the force was cut
constexpr double kSilence = 5.0;               // [s] after which a silent device is given up
constexpr double kLeastMove = 0.1e-3;          // [m]
constexpr double kLeastCosine = 0.7;           // [1] of the angle between push and motion

struct Bench {
  haptics::Device& device;
  ForceCheck& check;
  const CheckClock& clock;
  haptics::HandLoopConfig config;
  haptics::HandLoopState state;
  haptics::HandLoopOutput output;
  LocalContact contact;
  HandTarget still;
  std::uint64_t tick = 0, step = 0;
  Nanoseconds next = clock.now();

  void advance(const Vec3& force) {            // [N]
    next += 1'000'000;
    clock.sleepUntil(next);
    contact.step = ++step;
    contact.touching = true;
    contact.force = force;
    contact.damping = Mat3::Identity() * 2.0;
    haptics::tick(device, config, contact, still, ++tick, state, output);
    ++check.ticks;
  }
  Vec3 position() const { return output.sample.pose.position; }
};

bool waitUntilReady(Bench& bench, double patience) {  // [s]
  const Nanoseconds until = bench.clock.now() + static_cast<Nanoseconds>(patience * 1e9);
  while (bench.clock.now() < until) {
    bench.advance(Vec3::Zero());
    if (!(bench.output.faults & (haptics::kFaultDeviceGone | haptics::kFaultDeviceSilent))) return true;
  }
  return false;
}

/// Mean position over the rest, and how far single readings stray.
Vec3 restingPlace(Bench& bench) {
  std::vector<Vec3> places;
  Vec3 mean = Vec3::Zero();
  for (int i = 0; i < kRest; ++i) {
    bench.advance(Vec3::Zero());
    places.push_back(bench.position());
    mean += bench.position() / kRest;
  }
  for (const Vec3& place : places) bench.check.restNoise = std::max(bench.check.restNoise, (place - mean).norm());
  return mean;
}

enum class Pushed { kWhole, kInterrupted, kStopped };

Pushed pushOnce(Bench& bench, Push& push) {
  push.moved.setZero();
  const Vec3 from = bench.position();
  for (int i = 0; i < kRamp + kHold; ++i) {
    bench.advance(push.force * std::min(1.0, static_cast<double>(i) / kRamp));
    ForceCheck& check = bench.check;
    check.largestForce = std::max(check.largestForce, bench.output.force.norm());
    check.largestSpeed = std::max(check.largestSpeed, bench.state.velocity.norm());
    const std::uint32_t faults = bench.output.faults & haptics::kFaultCutMask;
    if (faults == haptics::kFaultDeviceSilent) return Pushed::kInterrupted;
    check.faults |= faults;
    const Vec3 moved = bench.position() - from;
    if (moved.dot(push.force) > push.moved.dot(push.force)) push.moved = moved;   // a hand gives way first, then resists
    if (check.largestSpeed > kTooFast || moved.norm() > kTooFar || check.faults != 0) return Pushed::kStopped;
  }
  const double length = push.moved.norm();     // [m]
  push.right = length > kLeastMove && push.moved.dot(push.force) > kLeastCosine * length * push.force.norm();
  for (int i = 0; i < kSettle; ++i) bench.advance(Vec3::Zero());
  return Pushed::kWhole;
}

/// A busy computer or a weak cable interrupts now and then; what counts is one push without a gap.
Pushed pushWhole(Bench& bench, Push& push, Nanoseconds until) {  // [ns]
  Pushed pushed = pushOnce(bench, push);
  while (pushed == Pushed::kInterrupted && bench.clock.now() < until) {
    ++bench.check.interruptions;
    if (!waitUntilReady(bench, kSilence)) return pushed;
    for (int i = 0; i < kSettle; ++i) bench.advance(Vec3::Zero());
    pushed = pushOnce(bench, push);
  }
  return pushed;
}

void pushAllWays(Bench& bench) {
  static const char* const kNames[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
  restingPlace(bench);
  const Nanoseconds until = bench.clock.now() + static_cast<Nanoseconds>(kPatience * 1e9);
  bool all = true;
  for (int way = 0; way < 6 && all; ++way) {
    Push push;
    push.axis = kNames[way];
    push.force[way / 2] = way % 2 ? -kPush : kPush;
    const Pushed pushed = pushWhole(bench, push, until);
    if (pushed == Pushed::kInterrupted) bench.check.faults |= haptics::kFaultDeviceSilent;
    all = pushed == Pushed::kWhole;
    bench.check.pushes.push_back(push);
  }
  bench.check.passed = all;
  for (const Push& push : bench.check.pushes) bench.check.passed = bench.check.passed && push.right;
}

}  // namespace

ForceCheck checkForces(haptics::Device& device, double patience, const CheckClock& clock) {  // [s]
  ForceCheck check;
  const Nanoseconds start = clock.now();
  Bench bench{device, check, clock, {}, {}, {}, {}, {}};
  check.ready = waitUntilReady(bench, patience);
  if (check.ready) pushAllWays(bench);
  check.seconds = static_cast<double>(clock.now() - start) * 1e-9;
  check.status = device.status();
  return check;
}

ForceCheck checkForces(haptics::Device& device, double patience) {  // [s]
  std::atomic<bool> stop{false};
  std::thread service;
  if (device.served()) service = std::thread([&] { runDevice(device, stop); });
  ForceCheck check = checkForces(device, patience, {haptics::monotonicNow, haptics::sleepUntil});
  stop.store(true);
  if (service.joinable()) service.join();
  return check;
}

}  // namespace halsted::app
