/// What the hand at a device feels of a needle: the shipped tick at 1 kHz around recorded readings, and the physics step in between.
#include <gtest/gtest.h>

#include <vector>

#include "tests/haptics/replay_rig.h"
#include "tests/sim/needling/body_rig.h"

namespace halsted::haptics {
namespace {

using halsted::testing::BodyRig;
using halsted::testing::needlingParams;

/// Readings of a hand that goes from 3 mm above the skin to a depth, waits, and goes back.  [m], [m/s]
std::vector<DeviceReading> inAndOut(double depth, double speed) {
  std::vector<DeviceReading> readings;
  const auto add = [&](double y) {             // [m]
    DeviceReading r = readingAt(Vec3(0, y, 0));
    r.pose.orientation = turnOnto(Vec3::UnitZ(), Vec3::UnitY());
    readings.push_back(r);
  };
  const int steps = static_cast<int>((depth + 3e-3) / (speed * 1e-3));
  for (int k = 0; k <= steps; ++k) add(3e-3 - k * speed * 1e-3);
  for (int k = 0; k < 300; ++k) add(3e-3 - steps * speed * 1e-3);
  for (int k = steps; k >= 0; --k) add(3e-3 - k * speed * 1e-3);
  return readings;
}

struct Feel {
  BodyRig body{needlingParams(), 15};
  ReplayRig hand;
  Vec3 felt = Vec3::Zero(), before = Vec3::Zero();   // [N] at the device in this tick and the last
  double energy = 0.0;                         // [J] that the hand has put in

  explicit Feel(const std::vector<DeviceReading>& readings) : hand(readings) { hand.config.mapping = {}; }
  /// One tick with the model of the last step, then the step.
  void next() {
    const Vec3 from = body.input.tools[kRight].pose.position;
    before = felt;
    felt = hand.next();
    body.input.tools[kRight] = hand.output.sample;
    body.step();
    hand.contact = body.out.contact[kRight];
    energy -= 0.5 * (before + felt).dot(hand.output.sample.pose.position - from);
  }
};

TEST(NeedleFeel, PunctureJumpIsTheSurfaceTermAndNothingElseJumps) {
  Feel feel(inAndOut(22e-3, 6e-3));
  std::vector<double> jumps, lost;             // [N]
  bool punctured = false;
  double largest = 0.0;                        // [N] change in any other tick
  for (std::size_t seen = 0; !feel.hand.device.finished(); seen = feel.body.events.size()) {
    feel.next();
    const double change = (feel.felt - feel.before).norm();   // [N]
    if (punctured) jumps.push_back(change);
    else largest = std::max(largest, change);
    punctured = false;
    for (std::size_t i = seen; i < feel.body.events.size(); ++i) {
      const Event& e = feel.body.events[i];
      if (e.kind != EventKind::kNeedleEntered && e.kind != EventKind::kLayerPunctured) continue;
      punctured = true;
      lost.push_back(e.value);
    }
  }
  ASSERT_EQ(jumps.size(), 3u);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(jumps[k], lost[k], 0.03) << "layer " << k;
  EXPECT_LT(largest, 0.03);
}

TEST(NeedleFeel, TheHandFeelsTheForceOfTheTissue) {
  for (const double speed : {3e-3, 10e-3}) {   // [m/s]
    Feel feel(inAndOut(22e-3, speed));
    double most = 0.0, peak = 0.0;             // [N]
    int ticks = 0, away = 0;
    while (!feel.hand.device.finished()) {
      feel.next();
      const double error = (feel.felt - feel.body.state.tools[kRight].force).norm();   // [N]
      most = std::max(most, feel.body.out.contact[kRight].puncture ? 0.0 : error);
      away += error > 0.02;                    // physics.md B7: what may be lost from model to model
      peak = std::max(peak, feel.felt.norm());
      ++ticks;
    }
    EXPECT_LT(most, 0.05) << speed;            // in the tick after a jump the blend may still be on its way
    EXPECT_LT(away, ticks / 50) << speed;
    EXPECT_GT(peak, 0.3);
    EXPECT_LT(peak, 3.3);                      // what a desktop device can give
  }
}

TEST(NeedleFeel, GoingInAndOutTakesEnergyFromTheHand) {
  Feel feel(inAndOut(22e-3, 10e-3));
  double least = 0.0;                          // [J]
  while (!feel.hand.device.finished()) {
    feel.next();
    least = std::min(least, feel.energy);
  }
  EXPECT_GT(least, -1e-5);
  EXPECT_GT(feel.energy, 1e-3);
}

}  // namespace
}  // namespace halsted::haptics
