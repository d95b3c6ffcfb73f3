/// Laws of the Falcon's kinematics: inverse, forward, rates and torques agree with each other and with the mechanism's lengths.
#include <gtest/gtest.h>

#include <cmath>

#include "haptics/falcon/falcon_kinematics.h"
#include "haptics/falcon/falcon_protocol.h"

namespace halsted::haptics {
namespace {

/// Calls `check` at 125 places of a cube of 80 mm about the middle: the workspace that is advertised is a ball of 40 mm radius.
template <typename Check>
void everywhere(Check&& check) {
  for (int i = 0; i < 125; ++i) check(Vec3(i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2) * 20e-3);
}

TEST(FalconKinematics, ForwardUndoesInverse) {
  everywhere([](const Vec3& place) {
    const auto legs = falconLegs(place);
    if (place.norm() > 45e-3 && !legs) return;                   // corners out of reach
    ASSERT_TRUE(legs) << place.transpose();
    const auto found = falconPosition(*legs, Vec3::Zero());
    if (place.norm() > 45e-3 && !found) return;
    ASSERT_TRUE(found) << place.transpose();
    EXPECT_LT((*found - place).norm(), 1e-9) << place.transpose();
  });
}

TEST(FalconKinematics, ShinsKeepTheirLength) {
  const FalconLinks links;
  everywhere([&](const Vec3& place) {
    const auto legs = falconLegs(place);
    if (!legs) return;
    for (int i = 0; i < 3; ++i) {
      // Knee and grip joint in the leg's frame, from the angle alone: their distance is knee + parallelogram, as built.
      const double azimuth = std::acos(-1.0) * (std::array{0.5, -1.0 / 6, -5.0 / 6}[static_cast<std::size_t>(i)] + 1.0 / 12);   // [rad]
      const double u = std::cos(azimuth) * place.x() + std::sin(azimuth) * place.y() - links.baseU + links.gripU;   // [m]
      const double v = -std::sin(azimuth) * place.x() + std::cos(azimuth) * place.y() - links.baseV + links.gripV;  // [m]
      const double w = place.z() + links.middle;                                                                     // [m]
      const double du = u - links.arm * std::cos((*legs)[i]), dw = w - links.arm * std::sin((*legs)[i]);             // [m]
      const double along = std::hypot(du, dw) - links.knee;                                                          // [m]
      EXPECT_NEAR(std::hypot(along, v), links.shin, 1e-12);
    }
  });
}

TEST(FalconKinematics, RatesAreTheDerivativesOfTheAngles) {
  constexpr double kStep = 1e-6;               // [m]
  everywhere([&](const Vec3& place) {
    const auto rates = falconLegRates(place);
    if (!rates || place.norm() > 45e-3) return;
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = Vec3::Unit(axis) * kStep;
      const Vec3 difference = (*falconLegs(place + step) - *falconLegs(place - step)) / (2.0 * kStep);
      EXPECT_LT((difference - rates->col(axis)).norm(), 1e-4 * rates->norm()) << place.transpose();
    }
  });
}

/// Virtual work: torque times leg motion is force times grip motion, and what the motors are told makes that force again.
TEST(FalconKinematics, TorqueDoesTheWorkOfTheForce) {
  const Vec3 force(1.2, -0.7, 2.0);            // [N]
  everywhere([&](const Vec3& place) {
    if (place.norm() > 45e-3) return;
    const auto torque = falconTorque(place, force);
    const auto rates = falconLegRates(place);
    ASSERT_TRUE(torque && rates);
    const Vec3 motion(0.3e-3, 0.1e-3, -0.2e-3);  // [m]
    EXPECT_NEAR(torque->dot(*rates * motion), force.dot(motion), 1e-12);
    EXPECT_LT((falconForce(place, falconMotors(place, force)) - force).norm(), 0.02);
  });
}

TEST(FalconKinematics, MotorLimitKeepsTheDirection) {
  const Vec3 force(30.0, 20.0, -10.0);         // [N] far beyond what it can do
  const auto motors = falconMotors(Vec3(0.01, 0.0, 0.0), force);
  int largest = 0;
  for (const int motor : motors) largest = std::max(largest, std::abs(motor));
  EXPECT_EQ(largest, kFalconMotorLimit);
  const Vec3 made = falconForce(Vec3(0.01, 0.0, 0.0), motors);
  EXPECT_GT(made.dot(force), 0.9999 * made.norm() * force.norm());
}

TEST(FalconKinematics, CountsAndAnglesAgree) {
  for (int counts = -3000; counts <= 1500; counts += 7) EXPECT_EQ(falconLegCounts(falconLegAngle(counts)), counts);
  EXPECT_NEAR(falconLegAngle(0), 35.0 * std::acos(-1.0) / 180.0, 1e-12);
  EXPECT_NEAR(falconLegAngle(1) - falconLegAngle(0), kFalconLegStep, 1e-7);
}

TEST(FalconKinematics, WhatCannotBeIsRefused) {
  const double bad = std::nan("");
  EXPECT_FALSE(falconLegs(Vec3(0.5, 0.0, 0.0)));
  EXPECT_FALSE(falconLegs(Vec3(bad, 0.0, 0.0)));
  EXPECT_FALSE(falconPosition(Vec3(bad, 0.0, 0.0), Vec3::Zero()));
  EXPECT_FALSE(falconPosition(Vec3(9.0, -9.0, 9.0), Vec3::Zero()));
  EXPECT_FALSE(falconTorque(Vec3(0.5, 0.0, 0.0), Vec3::UnitX()));
}

TEST(FalconWire, NumbersComeThroughWhole) {
  for (int value = -32768; value <= 32767; value += 111) {
    FalconReply reply;
    reply.encoders = {value, -1 - value, 5};
    reply.buttons = kFalconForward | kFalconMinus;
    reply.homed = 5;
    const auto back = decodeFalconReply(encode(reply));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->encoders, reply.encoders);
    EXPECT_EQ(back->buttons, reply.buttons);
    EXPECT_EQ(back->homed, reply.homed);
  }
  FalconCommand command;
  command.motors = {4096, -4096, 17};
  command.lights = kFalconGreen;
  command.homing = true;
  const auto back = decodeFalconCommand(encode(command));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->motors, command.motors);
  EXPECT_EQ(back->lights, command.lights);
  EXPECT_TRUE(back->homing);
}

/// The format as public drivers know it: '<', least significant nibble first from 'A', '>'.
TEST(FalconWire, IsThePublicFormat) {
  FalconCommand command;
  command.motors = {0x123, -1, 0};
  command.lights = kFalconRed;
  const FalconFrame frame = encode(command);
  EXPECT_EQ(std::string(frame.begin(), frame.end()), "<DCBAPPPPAAAAIA>");
}

TEST(FalconWire, FramerFindsFramesInNoise) {
  const FalconFrame frame = encode(FalconReply{});
  FalconFramer framer;
  const std::string noise = "A<BB<<>CC>";
  int whole = 0;
  for (int round = 0; round < 50; ++round) {
    for (const char c : noise) whole += framer.push(static_cast<std::uint8_t>(c));
    for (const std::uint8_t byte : frame) whole += framer.push(byte);
  }
  EXPECT_EQ(whole, 50);
  EXPECT_GT(framer.dropped(), 50u);
}

}  // namespace
}  // namespace halsted::haptics
