/// What makes a contact stable, measured in virtual time with the shipped tick, the Touch in software and simulated hands
/// (the measures of the field: Z-width, energy over a cycle, limit cycles).
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <vector>

#include "tests/haptics/press_release.h"

namespace halsted::haptics {
namespace {

constexpr double kCreated = 1e-4;  // [J] the most that a press-release cycle may create
constexpr double kBuzz = 0.02;     // [N] RMS above 30 Hz of a held contact
constexpr double kWander = 0.1e-3; // [m] two counts of the encoder: larger is an oscillation

bool stable(const PressResult& result) { return result.buzz < kBuzz && result.wander < kWander; }

TEST(HapticStability, PressReleaseOfAWallNeverCreatesEnergy) {
  for (const NamedHand& hand : threeHands())
    for (const double stiffness : {300.0, 600.0, 1000.0})
      for (const double damping : {0.0, 1.0}) {
        Press press;
        press.hand = hand.dynamics;
        const PressResult result = pressAndRelease(SpringWall{stiffness, damping}, press);
        EXPECT_GT(result.leastEnergy, -kCreated) << hand.name << " " << stiffness << " N/m " << damping << " N s/m";
        EXPECT_GT(result.energyTaken, -kCreated) << hand.name << " " << stiffness << " N/m " << damping << " N s/m";
        EXPECT_GT(result.steady, 0.25) << "the hand did press";
      }
}

TEST(HapticStability, PressReleaseOfTissueNeverCreatesEnergy) {
  for (const NamedHand& hand : threeHands())
    for (const double stiffness : {100.0, 300.0, 1000.0})
      for (const int delay : {0, 1, 2}) {
        Press press;
        press.hand = hand.dynamics;
        press.delay = delay;
        press.depth = 6e-3;
        SoftTissue tissue;
        tissue.stiffness = stiffness;
        const PressResult result = pressAndRelease(tissue, press);
        EXPECT_GT(result.leastEnergy, -kCreated) << hand.name << " " << stiffness << " N/m, delay " << delay;
        EXPECT_GT(result.steady, 0.25) << "the hand did press";
      }
}

TEST(HapticStability, APlanePublishedAheadMakesAFastTouchPassiveToo) {
  for (const NamedHand& hand : threeHands())
    for (const double speed : {0.1, 0.25})
      for (const int delay : {0, 1}) {
        Press press;
        press.hand = hand.dynamics;
        press.speed = speed;
        press.delay = delay;
        const PressResult result = pressAndRelease(SpringWall{1000.0, 0.5, 2e-3}, press);
        EXPECT_GT(result.leastEnergy, -kCreated) << hand.name << " " << speed << " m/s, delay " << delay;
      }
}

TEST(HapticStability, HeldContactDoesNotBuzz) {
  for (const NamedHand& hand : threeHands())
    for (const double stiffness : {300.0, 1000.0})
      for (const int delay : {0, 1, 2}) {
        Press press;
        press.hand = hand.dynamics;
        press.delay = delay;
        press.depth = 6e-3;
        SoftTissue tissue;
        tissue.stiffness = stiffness;
        EXPECT_LT(pressAndRelease(SpringWall{stiffness, 0.0}, press).buzz, kBuzz) << hand.name << " wall " << stiffness;
        EXPECT_LT(pressAndRelease(tissue, press).buzz, kBuzz) << hand.name << " tissue " << stiffness;
      }
}

TEST(HapticStability, ContactNeverSticks) {
  for (const NamedHand& hand : threeHands()) {
    Press press;
    press.hand = hand.dynamics;
    press.speed = 0.25;
    press.depth = 4e-3;
    EXPECT_GE(pressAndRelease(SpringWall{1000.0, 2.0}, press).mostAdhesive, -1e-9) << hand.name;
    EXPECT_GE(pressAndRelease(SoftTissue{}, press).mostAdhesive, -1e-9) << hand.name;
  }
}

TEST(HapticStability, SteadyForceIsTheSpringsForce) {
  for (const double stiffness : {300.0, 1000.0}) {
    Press press;
    press.depth = 0.5e-3;
    // The hand sees its goal and gets there, within a count and the eye's deadband.
    const double expected = stiffness * press.depth;  // [N]
    EXPECT_NEAR(pressAndRelease(SpringWall{stiffness, 0.0}, press).steady, expected, stiffness * 0.1e-3);
  }
}

/// The Z-width: the stiffest wall that stays quiet, by hand, period and age of the model; printed as a table. One N/mm, the
/// nominal stiffness of the device, must be quiet with all three hands at 1 kHz whatever the delay.
TEST(HapticStability, OneNewtonPerMillimetreIsStableWithThreeHands) {
  for (const NamedHand& hand : threeHands())
    for (const int delay : {0, 1, 2, 5}) {
      Press press;
      press.hand = hand.dynamics;
      press.delay = delay;
      EXPECT_TRUE(stable(pressAndRelease(SpringWall{1000.0, 0.0}, press))) << hand.name << ", delay " << delay;
    }
}

/// The wall's plane is published 2 mm ahead, as the simulator does: a bare device that is thrown at it else bounces for seconds.
constexpr double kSearchFactor = 1.4142135623730951;   // [1]
double stiffestQuietWall(Press press, double upTo) {  // [N/m]
  double best = 0.0;  // [N/m]
  for (double stiffness = 250.0; stiffness <= upTo; stiffness *= kSearchFactor) {
    if (!stable(pressAndRelease(SpringWall{stiffness, 0.0, 2e-3}, press))) break;
    best = stiffness;
  }
  return best;
}

/// No wider with a longer period or a greater delay, within a step of the search.
void expectShrinks(const std::array<double, 9>& width, const char* hand) {   // [N/m] period by period, delay by delay
  for (int cell = 0; cell < 9; ++cell) {
    if (cell % 3 > 0) { EXPECT_LE(width[cell], 1.001 * kSearchFactor * width[cell - 1]) << hand << ", period " << cell / 3 << ", delay " << cell % 3; }
    if (cell / 3 > 0) { EXPECT_LE(width[cell], 1.001 * kSearchFactor * width[cell - 3]) << hand << ", period " << cell / 3 << ", delay " << cell % 3; }
  }
}

TEST(HapticStability, ZWidthShrinksWithPeriodAndDelayAndLacksNothingThatFrictionGives) {
  std::vector<NamedHand> hands{{"none", pushingHand(0.0)}};
  for (const NamedHand& hand : threeHands()) hands.push_back(hand);
  std::printf("stiffest quiet wall [N/m]; with friction 2 f/D = %.0f N/m\n%-10s %9s %6s", 2 * 0.26 / 0.055e-3, "friction", "period", "delay");
  for (const NamedHand& hand : hands) std::printf(" %10s", hand.name);
  std::printf("\n");
  constexpr double kPeriods[] = {0.5e-3, 1e-3, 2e-3};   // [s]
  constexpr int kDelays[] = {0, 2, 5};                  // periods
  for (const double friction : {0.26, 0.0}) {
    std::vector<std::array<double, 9>> width(hands.size());   // [N/m] by hand, then period and delay
    for (int cell = 0; cell < 9; ++cell) {
      const double period = kPeriods[cell / 3];         // [s]
      const int delay = kDelays[cell % 3];
      std::printf("%-8.2f N %6.1f ms %6d", friction, period * 1e3, delay);
      for (std::size_t h = 0; h < hands.size(); ++h) {
        Press press;
        press.hand = hands[h].dynamics;
        press.period = period;
        press.delay = delay;
        press.friction = friction;
        const double stiffest = width[h][cell] = stiffestQuietWall(press, 12000.0);  // [N/m]
        std::printf(" %10.0f", stiffest);
        if (friction > 0.0 && period <= 1e-3 && hands[h].dynamics.damping > 0.0) { EXPECT_GE(stiffest, 1000.0) << hands[h].name; }
      }
      std::printf("\n");
    }
    for (std::size_t h = 0; h < hands.size(); ++h) expectShrinks(width[h], hands[h].name);
  }
}

}  // namespace
}  // namespace halsted::haptics
