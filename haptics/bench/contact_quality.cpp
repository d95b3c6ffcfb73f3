/// 2 to 4: energy of a press, steps of force while models are replaced, and what a held contact does.
#include <algorithm>
#include <cstdio>

#include "haptics/bench/bench.h"

namespace halsted::haptics::bench {

namespace {

constexpr double kCreated = 1e-4;              // [J] devices.md
constexpr double kBuzz = 0.02;                 // [N] devices.md
constexpr double kReplaced = 0.02;             // [N] physics.md B7: step at model hand-over
constexpr double kSmoothStep = 0.1;            // [N] a tick: devices.md

SoftTissue tissueOf(double stiffness) {        // [N/m]
  SoftTissue tissue;
  tissue.stiffness = stiffness;
  return tissue;
}

PressPlan planFor(const HandDynamics& hand, double speed, double delay) {   // [m/s] [s]
  PressPlan plan;
  plan.hand = hand;
  plan.speed = speed;
  plan.modelDelay = delay;
  return plan;
}

std::string conditionOf(const std::string& surface, double delay, const char* hand, double speed) {   // [s] [m/s]
  char text[96];
  std::snprintf(text, sizeof text, "%s, %.0f ms late, %s, %.0f mm/s", surface.c_str(), delay * 1e3, hand, speed * 1e3);
  return text;
}

std::string surfaceOf(const char* kind, double stiffness) {   // [N/m]
  char text[48];
  std::snprintf(text, sizeof text, "%s of %.0f N/m", kind, stiffness);
  return text;
}

Measurement created(const PressOutcome& outcome, const std::string& condition, bool promised) {
  return {"energy created by press and release", condition, std::max(0.0, -std::min(outcome.leastEnergy, outcome.energyTaken)), "J",
          promised ? Bound::kAtMost : Bound::kNone, kCreated};
}

/// Every grip at one speed and age of the model; a stiff tissue whose model is late by more than its step is measured, not promised.
void pressWithEveryGrip(double speed, double delay, Measurements& all) {   // [m/s] [s]
  for (const NamedHand& hand : threeHands()) {
    const PressPlan plan = planFor(hand.dynamics, speed, delay);
    for (const double stiffness : {300.0, 1020.0})
      all.push_back(created(press(SpringWall{stiffness, 0.0, 2e-3}, plan), conditionOf(surfaceOf("wall", stiffness), delay, hand.name, speed), true));
    for (const double stiffness : {100.0, 300.0, 1000.0})
      all.push_back(created(press(tissueOf(stiffness), plan), conditionOf(surfaceOf("tissue", stiffness), delay, hand.name, speed),
                            delay == 0.0 || stiffness < 1000.0));
  }
}

}  // namespace

Measurements measurePressEnergy() {
  Measurements all;
  for (const double speed : {0.05, 0.25})
    for (const double delay : {0.0, 1e-3, 2e-3}) pressWithEveryGrip(speed, delay, all);
  return all;
}

Measurements measureContinuity() {
  Measurements all;
  for (const NamedHand& hand : threeHands())
    for (const int every : {1, 16}) {          // a step a tick, and a scene of 62 steps a second
      PressPlan plan = planFor(hand.dynamics, 0.05, 0.0);
      plan.every = every;
      const PressOutcome outcome = press(tissueOf(300.0), plan);
      const std::string condition = std::string(hand.name) + (every == 1 ? ", tissue at 1000 Hz" : ", tissue at 62 Hz");
      all.push_back({"largest step by a new model", condition, outcome.replaced, "N", Bound::kAtMost, every == 1 ? kReplaced : 0.05});
      all.push_back({"largest step in a tick", condition, outcome.largestStep, "N", Bound::kAtMost, kSmoothStep});
    }
  return all;
}

Measurements measureHeldContact() {
  Measurements all;
  for (const NamedHand& hand : threeHands()) {
    double worst = 0.0;                        // [N]
    for (const double delay : {0.0, 1e-3, 2e-3, 5e-3})
      for (const double stiffness : {300.0, 1020.0}) {
        worst = std::max(worst, press(SpringWall{stiffness, 0.0, 2e-3}, planFor(hand.dynamics, 0.05, delay)).buzz);
        worst = std::max(worst, press(tissueOf(stiffness), planFor(hand.dynamics, 0.05, delay)).buzz);
      }
    all.push_back({"RMS above 30 Hz", std::string(hand.name) + ", walls and tissue, model 0 to 5 ms late", worst, "N", Bound::kAtMost, kBuzz});
  }
  return all;
}

}  // namespace halsted::haptics::bench
