#include "haptics/bench/press.h"

namespace halsted::haptics::bench {

namespace {
constexpr double kAbove = 10e-3;               // [m] where the hand starts
constexpr double kBuzz = 0.02;                 // [N] RMS above 30 Hz of a held contact (devices.md)
constexpr double kWander = 0.11e-3;            // [m] two counts of the encoder
}  // namespace

bool quiet(const PressOutcome& outcome) { return outcome.buzz < kBuzz && outcome.wander < kWander; }

Rig pressRig(const PressPlan& plan) {
  Pose start;
  start.position.y() = kAbove;
  HandDynamics hand = plan.hand;
  hand.maxSpeed = plan.speed;
  Rig rig(plan.touch, hand, start);
  rig.config = plan.config;
  rig.every = plan.every;
  rig.delay = static_cast<int>(plan.modelDelay / (plan.config.period * plan.every) + 0.5);
  rig.forceDelay = static_cast<int>(plan.forceDelay / plan.config.period + 0.5);
  return rig;
}

PressJudge::PressJudge(const PressPlan& plan, Rig& rig) : plan_(plan), rig_(rig) {}

int PressJudge::ticks(double seconds) const { return static_cast<int>(seconds / plan_.config.period + 0.5); }

void PressJudge::approach() { rig_.target.pose.position.y() = -plan_.depth; }

void PressJudge::beginRelease() { rig_.target.pose.position.y() = kAbove; }

void PressJudge::seen(bool judged) {
  const double y = rig_.device.position().y();   // [m]
  forces_.push_back(rig_.output.force.y());
  if (!judged) return;
  low_ = std::min(low_, y);
  high_ = std::max(high_, y);
  depths_ -= y;
  sum_ += forces_.back();
  ++judged_;
}

PressOutcome PressJudge::outcome() const {
  PressOutcome outcome;
  outcome.buzz = rmsAbove30Hz(forces_, 1.0 / plan_.config.period, forces_.size() - static_cast<std::size_t>(judged_));
  outcome.wander = high_ - low_;
  outcome.steady = sum_ / judged_;
  outcome.depth = depths_ / judged_;
  outcome.leastEnergy = rig_.leastEnergy;
  outcome.energyTaken = rig_.energyTaken;
  outcome.largestStep = rig_.largestStep;
  outcome.peak = rig_.peak;
  return outcome;
}

}  // namespace halsted::haptics::bench
