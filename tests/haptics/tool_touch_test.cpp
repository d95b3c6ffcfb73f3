/// Touching the simulated wall, slow and fast, through device, tick and physics step: the laws of a haptic contact.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/haptics/wall_loop.h"

namespace halsted::haptics {
namespace {

constexpr double kToolCreated = 1e-4;              // [J] the most that a press-release cycle may create
constexpr double kReplaced = 0.05;             // [N] the most that a new model may change the force
constexpr double kToolBuzz = 0.02;                 // [N] RMS above 30 Hz of a held contact

SimParams softWall() {
  SimParams p = wallParams();
  p.tissue.youngsModulus = 120e3;              // the handling range, as in the scenes
  return p;
}

void expectLaws(const SimParams& p, WallPress press, const NamedHand& hand, double speed) {   // [m/s]
  press.hand = hand.dynamics;
  press.speed = speed;
  const WallResult r = pressWall(p, press);
  std::printf("%-10s %3.0f mm/s, delay %d: least %9.2e J, cycle %9.2e J, replaced %.3f N, buzz %.4f N, steady %.2f N\n", hand.name,
              speed * 1e3, press.delay, r.leastEnergy, r.energyTaken, r.replaced, r.buzz, r.steady);
  EXPECT_GT(r.leastEnergy, -kToolCreated) << hand.name << " " << speed;
  EXPECT_GT(r.energyTaken, -kToolCreated) << hand.name << " " << speed;
  EXPECT_LT(r.replaced, kReplaced) << hand.name << " " << speed;
  EXPECT_LT(r.buzz, kToolBuzz) << hand.name << " " << speed;
  EXPECT_GT(press.slidesOff ? r.peak : r.steady, 0.05) << "the hand did press";
  EXPECT_EQ(r.otherHand, 0.0);
}

void expectLawsAtAnySpeed(const SimParams& p, const WallPress& press) {
  for (const NamedHand& hand : threeHands())
    for (const double speed : {0.02, 0.05, 0.1, 0.2, 0.3}) expectLaws(p, press, hand, speed);
}

TEST(ToolTouch, CreatesNoEnergyAtAnySpeedOnTheMiddleOfAStiffWall) { expectLawsAtAnySpeed(wallParams(), WallPress{}); }

/// Where the wall is held it hardly gives: here a touch at 300 mm/s created up to 6e-4 J before the planes came ahead of it.
TEST(ToolTouch, CreatesNoEnergyAtAnySpeedWhereTheWallIsHeld) {
  for (const int delay : {0, 3}) {
    WallPress press;
    press.height = 2e-3;
    press.hold = 1.0;
    press.delay = delay;
    expectLawsAtAnySpeed(wallParams(), press);
  }
}

TEST(ToolTouch, CreatesNoEnergyAtAnySpeedOnBowel) { expectLawsAtAnySpeed(softWall(), WallPress{}); }

/// Soft tissue at its middle, its edges, a corner, its end and beside the foot that holds it; the tool stands on the face, or lies along it.
/// Beside the foot it is pressed to half and to three quarters of the wall's thickness: pinched between tool and foot it quivered.
struct SoftPlace {
  const char* name;
  double height, along, depth;                   // [m]
  bool flat;
  bool slidesOff = false;                        // the tool leaves the edge while it is held
};

class SoftPlaces : public testing::TestWithParam<SoftPlace> {};
INSTANTIATE_TEST_SUITE_P(ToolTouch, SoftPlaces,
                         testing::Values(SoftPlace{"Middle", 11e-3, 12e-3, 3e-3, false}, SoftPlace{"Foot", 2e-3, 12e-3, 2e-3, false},
                                         SoftPlace{"PinchedAtTheFoot", 2e-3, 12e-3, 3e-3, false},
                                         SoftPlace{"Rim", 14e-3, 12e-3, 3e-3, false}, SoftPlace{"OverTheRim", 16.5e-3, 12e-3, 3e-3, false, true},
                                         SoftPlace{"End", 11e-3, 22e-3, 3e-3, false}, SoftPlace{"Corner", 15e-3, 23e-3, 3e-3, false, true},
                                         SoftPlace{"LyingAtTheFoot", 2e-3, 12e-3, 1.5e-3, true},
                                         SoftPlace{"LyingInTheMiddle", 9e-3, 4e-3, 2e-3, true}, SoftPlace{"LyingAtTheRim", 14e-3, 12e-3, 2e-3, true}),
                         [](const auto& place) { return std::string(place.param.name); });

TEST_P(SoftPlaces, CreateNoEnergyAtAnySpeed) {
  WallPress press;
  press.height = GetParam().height;
  press.along = GetParam().along;
  press.flat = GetParam().flat;
  press.depth = GetParam().depth;
  press.slidesOff = GetParam().slidesOff;
  for (const NamedHand& hand : threeHands())
    for (const double speed : {0.01, 0.03, 0.1, 0.2, 0.3}) {
      press.hold = 1.0 + 13e-3 / speed;          // the way there, and a second
      expectLaws(softWall(), press, hand, speed);
    }
}

/// The planes stand where the touch begins: the tool in the air is told how far it may go, and feels nothing before.
TEST(ToolTouch, PlanesStandWhereTheTouchBegins) {
  for (const double gap : {1.4e-3, 0.7e-3, 0.1e-3}) {
    WallStep wall(wallParams(), beforeWall(10e-3));
    ToolSample sample = wall.rig.input.tools[kLeft];
    LocalContact c = wall.step(sample, 1e-3);      // the jaws close in the air
    sample.pose = beforeWall(gap);
    for (int i = 0; i < 10; ++i) c = wall.step(sample, 1e-3);
    ASSERT_TRUE(c.ahead && !c.touching) << gap;
    ASSERT_GE(c.planeCount, 1);
    EXPECT_NEAR(c.planes[0].normal.x(), 1.0, 1e-6);
    EXPECT_NEAR(c.planes[0].normal.dot(c.position - c.planes[0].point), gap, 1e-9);
    EXPECT_EQ(modelForce(c, c.position, Vec3::Zero(), CouplingCaps{}), Vec3(Vec3::Zero()));
    const Vec3 beyond = modelForce(c, c.position - Vec3(gap + 0.1e-3, 0, 0), Vec3::Zero(), CouplingCaps{});
    EXPECT_GT(beyond.x(), 0.02);                 // 0.1 mm on the wall and the coupling in series
    EXPECT_LT(beyond.x(), 0.1);
    sample.pose = beforeWall(gap + 20e-3);
    EXPECT_FALSE(wall.step(sample, 1e-3).ahead);
  }
}

}  // namespace
}  // namespace halsted::haptics
