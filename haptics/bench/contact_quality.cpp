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

/// The worst of all delays, speeds and surfaces for one hand.
struct Worst {
  double least = 0.0, cycle = 0.0;             // [J]
  double buzz = 0.0, step = 0.0, replaced = 0.0;   // [N]

  void add(const PressOutcome& o) {
    least = std::min(least, o.leastEnergy);
    cycle = std::min(cycle, o.energyTaken);
    buzz = std::max(buzz, o.buzz);
    step = std::max(step, o.largestStep);
    replaced = std::max(replaced, o.replaced);
  }
};

std::string withSpeed(const char* surface, double delay, const char* hand, double speed) {   // [s] [m/s]
  char text[96];
  std::snprintf(text, sizeof text, "%s, model %.0f ms late, %s, %.0f mm/s", surface, delay * 1e3, hand, speed * 1e3);
  return text;
}

void addEnergy(const char* surface, const PressOutcome& outcome, const std::string& condition, Measurements& all) {
  (void)surface;
  all.push_back({"energy created by press and release", condition, -std::min(outcome.leastEnergy, outcome.energyTaken), "J", Bound::kAtMost, kCreated});
}

}  // namespace

Measurements measurePressEnergy() {
  Measurements all;
  for (const NamedHand& hand : threeHands())
    for (const double speed : {0.05, 0.25})
      for (const double delay : {0.0, 2e-3}) {
        const PressPlan plan = planFor(hand.dynamics, speed, delay);
        for (const double damping : {0.0, 0.5})
          for (const double k : {300.0, 1020.0}) {
            char t[64]; std::snprintf(t, 64, "wall %.0f N/m %.1f N s/m", k, damping);
            addEnergy("", press(SpringWall{k, damping, 2e-3}, plan), withSpeed(t, delay, hand.name, speed), all);
          }
        for (const double k : {100.0, 300.0, 1000.0}) {
            char t[64]; std::snprintf(t, 64, "tissue %.0f N/m", k);
            addEnergy("", press(tissueOf(k), plan), withSpeed(t, delay, hand.name, speed), all);
        }
      }
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
    Worst worst;
    for (const double delay : {0.0, 1e-3, 2e-3, 5e-3})
      for (const double stiffness : {300.0, 1020.0}) {
        worst.add(press(SpringWall{stiffness, 0.0, 2e-3}, planFor(hand.dynamics, 0.05, delay)));
        worst.add(press(tissueOf(stiffness), planFor(hand.dynamics, 0.05, delay)));
      }
    all.push_back({"RMS above 30 Hz", std::string(hand.name) + ", walls and tissue, model 0 to 5 ms late", worst.buzz, "N", Bound::kAtMost, kBuzz});
  }
  return all;
}

}  // namespace halsted::haptics::bench
