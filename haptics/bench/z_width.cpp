/// 1 Z-width: the stiffest and the most damped wall that stays quiet under a hand.
#include <cstdio>

#include "haptics/bench/bench.h"
#include "haptics/bench/press.h"

namespace halsted::haptics::bench {

namespace {

constexpr double kNominal = 1020.0;            // [N/m] of the Touch, weakest axis (data sheet)
constexpr double kLookAhead = 2e-3;            // [m] planes stand ahead of a touch, as the simulator publishes them
constexpr double kLargest = 16000.0;           // [N/m] above 2 f/D no encoder tells more
constexpr double kMostDamped = 64.0;           // [N s/m]
constexpr double kFiner = 1.189207115002721;   // [1] fourth root of 2

PressPlan planFor(const HandDynamics& hand, double period) {   // [s]
  PressPlan plan;
  plan.hand = hand;
  plan.config.period = period;
  plan.config.caps.stiffness = 1e9;            // off: the wall itself is what is measured
  plan.config.caps.damping = 1e9;
  return plan;
}

std::string conditionOf(double period, const char* what, double delay, const char* hand) {   // [s] [s]
  char text[96];
  std::snprintf(text, sizeof text, "%.1f ms tick, %s %.0f ms late, %s", period * 1e3, what, delay * 1e3, hand);
  return text;
}

Measurement stiffest(const PressPlan& plan, const std::string& condition, bool promised) {
  return {"stiffest quiet wall", condition, stiffestQuietWall(plan, kLargest), "N/m", promised ? Bound::kAtLeast : Bound::kNone, kNominal};
}

}  // namespace

double stiffestQuietWall(const PressPlan& plan, double upTo) {   // [N/m] -> [N/m]
  double best = 0.0;                           // [N/m]
  for (double stiffness = 250.0; stiffness <= upTo; stiffness *= kFiner) {
    if (!quiet(press(SpringWall{stiffness, 0.0, kLookAhead}, plan))) break;
    best = stiffness;
  }
  return best;
}

double mostDampedQuietWall(const PressPlan& plan, double stiffness, double upTo) {   // [N/m] [N s/m] -> [N s/m]
  double best = 0.0;                           // [N s/m]
  for (double damping = 0.5; damping <= upTo; damping *= kFiner) {
    if (!quiet(press(SpringWall{stiffness, damping, kLookAhead}, plan))) break;
    best = damping;
  }
  return best;
}

Measurements measureZWidth(const Heard& heard) {
  Measurements all;
  for (const double period : {0.5e-3, 1e-3, 2e-3})
    for (const double delay : {0.0, 1e-3, 2e-3, 5e-3}) {
      if (delay > 0.0 && delay < period) continue;
      for (const NamedHand& hand : threeHands()) {
        if (heard) heard(static_cast<double>(all.size()) / 66.0);
        PressPlan plan = planFor(hand.dynamics, period);
        plan.modelDelay = delay;
        all.push_back(stiffest(plan, conditionOf(period, "model", delay, hand.name), period <= 1e-3));
        if (delay == 0.0) {
          const double damping = mostDampedQuietWall(plan, kNominal, kMostDamped);   // [N s/m]
          all.push_back({"most damped quiet wall of 1.02 N/mm", conditionOf(period, "model", delay, hand.name), damping, "N s/m"});
          continue;
        }
        plan.modelDelay = 0.0;
        plan.forceDelay = delay;
        all.push_back(stiffest(plan, conditionOf(period, "force", delay, hand.name), period <= 1e-3 && delay <= 1e-3));
      }
    }
  return all;
}

Measurements measureNominalWall() {
  Measurements all;
  for (const NamedHand& hand : threeHands()) {
    PressPlan plan;                            // as shipped, caps and all
    plan.hand = hand.dynamics;
    const PressOutcome outcome = press(SpringWall{kNominal, 0.0, kLookAhead}, plan);
    all.push_back({"rendered stiffness of a wall of 1.02 N/mm", hand.name, outcome.steady / outcome.depth, "N/m", Bound::kAtLeast, 0.95 * kNominal});
    all.push_back({"buzz above 30 Hz on it", hand.name, outcome.buzz, "N", Bound::kAtMost, 0.02});
    all.push_back({"swing of the tip on it", hand.name, outcome.wander * 1e3, "mm", Bound::kAtMost, 0.11});
  }
  return all;
}

}  // namespace halsted::haptics::bench
