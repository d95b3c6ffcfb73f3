/// What a commanded force becomes: in virtual time on the path itself, and through the API.
#include <cmath>
#include <limits>

#include "haptics/hd/force_path.h"
#include "tests/hd/hd_rig.h"

namespace halsted::hdtest {
namespace {

using namespace haptics::hd;
using haptics::allFinite;

constexpr double kStill[3] = {0, 0, 0};

/// A device that has been on long enough for its ramp to be over.
struct Path {
  ForceContext context;
  ForcePathState state;
  std::uint32_t errors = 0;

  Path() { state.limits.ramp = 1.0; }
  Vec3 send(const Vec3& force, const double* velocity = kStill) { return shapeForce(force, velocity, context, state, errors); }
};

TEST(ForcePath, PassesWhatTheDeviceCanDo) {
  Path path;
  EXPECT_EQ(path.send({1.0, -0.5, 0.25}), Vec3(1.0, -0.5, 0.25));
  EXPECT_EQ(path.errors, 0u);
}

TEST(ForcePath, ScalesTheMagnitudeAndKeepsTheDirection) {
  Path path;
  const Vec3 sent = path.send({30.0, 40.0, 0.0});
  EXPECT_NEAR(sent.norm(), 3.3, 1e-12);
  EXPECT_NEAR(sent.y() / sent.x(), 4.0 / 3.0, 1e-12);
  EXPECT_EQ(path.errors, 0u);
}

TEST(ForcePath, RefusesTooMuchForceWhenItMayNotScale) {
  Path path;
  path.context.capabilities &= ~kForceClamping;
  path.context.capabilities &= ~kImpulseLimit;
  EXPECT_EQ(path.send({5.0, 0, 0}), Vec3(0, 0, 0));
  EXPECT_EQ(path.errors, kErrorMaxForce);
  path.errors = 0;
  EXPECT_LT(path.send({1.0, 0, 0}).x(), 0.01);       // cut, then ramped in again
  for (int i = 0; i < 200; ++i) path.send({1.0, 0, 0});
  EXPECT_NEAR(path.send({1.0, 0, 0}).x(), 1.0, 1e-9);
  EXPECT_EQ(path.errors, 0u);
}

TEST(ForcePath, RefusesAJumpAndASpeedAboveTheirLimits) {
  Path path;
  path.send({3.0, 0, 0});
  EXPECT_EQ(path.send({-3.0, 0, 0}), Vec3(0, 0, 0));
  EXPECT_EQ(path.errors, kErrorImpulse);
  Path fast;
  const double velocity[3] = {0, 1600.0, 0};
  EXPECT_EQ(fast.send({1.0, 0, 0}, velocity), Vec3(0, 0, 0));
  EXPECT_EQ(fast.errors, kErrorVelocity);
  Path loose;
  loose.context.capabilities &= ~(kImpulseLimit | kVelocityLimit);
  loose.send({3.0, 0, 0}, velocity);
  EXPECT_EQ(loose.send({-3.0, 0, 0}, velocity).x(), -3.0);
  EXPECT_EQ(loose.errors, 0u);
}

TEST(ForcePath, RampsInAtItsRate) {
  Path path;
  path.state.limits.ramp = 0.0;
  path.context.safety.rampRate = 33.0;
  for (int i = 0; i < 50; ++i) path.send({3.3, 0, 0});
  EXPECT_NEAR(path.send({3.3, 0, 0}).x(), 33.0 * 0.051, 0.05);   // [N] 51 ms at 33 N/s
  path.context.capabilities &= ~kForceRamping;
  path.state.limits.ramp = 0.0;
  EXPECT_EQ(path.send({3.3, 0, 0}).x(), 3.3);
}

TEST(ForcePath, LetsNoNumberOutThatIsNone) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Path path;
    EXPECT_EQ(path.send({0, bad, 0}), Vec3(0, 0, 0));
    EXPECT_EQ(path.errors, kErrorForce);
  }
}

TEST(ForcePath, SaysOnceThatTheMotorsAreWarmAndHoldsTheContinuousForce) {
  Path path;
  int said = 0;
  Vec3 sent = Vec3::Zero();
  for (int i = 0; i < 60'000; ++i) {  // a minute at full force
    path.errors = 0;
    sent = path.send({3.3, 0, 0});
    said += (path.errors & kErrorWarm) != 0;
  }
  EXPECT_EQ(said, 1);
  EXPECT_NEAR(sent.norm(), 0.88, 0.02);
}

TEST(ForcePath, MakesOfJointTorquesTheForceThatTheyHold) {
  DeviceState state;
  const double angles[3] = {0.2, 0.3, -0.25};
  std::copy(angles, angles + 3, state.jointAngles);
  const Vec3 force(0.4, -0.7, 0.2);
  const Vec3 torque = haptics::touchTorque({angles[0], angles[1], angles[2]}, force) * 1e3;  // [mN m]
  std::copy_n(torque.data(), 3, state.jointTorque);
  EXPECT_LT((commandedForce(state, kCommandForce) - force).norm(), 1e-12);
  state.force[0] = 1.0;  // both together add up
  EXPECT_LT((commandedForce(state, kCommandForce) - force - Vec3(1, 0, 0)).norm(), 1e-12);
  long motors[6] = {};
  storeMotors(angles, force, motors);
  std::copy_n(motors, 3, state.motors);
  EXPECT_LT((commandedForce(state, kCommandMotors) - force).norm(), 1e-3);  // [N] one part in 32767 of each motor
  EXPECT_EQ(commandedForce(state, kCommandNone), Vec3(0, 0, 0));
}

using Forces = Hd;

/// Force that left in the last frame, from the motors [N].
double sentForce() {
  HDlong motors[3];
  double angles[3];
  hdGetLongv(HD_LAST_MOTOR_DAC_VALUES, motors);
  hdGetDoublev(HD_LAST_JOINT_ANGLES, angles);
  DeviceState state;
  std::copy(motors, motors + 3, state.motors);
  std::copy(angles, angles + 3, state.jointAngles);
  return commandedForce(state, kCommandMotors).norm();
}

/// Commands `force` for so many ticks; returns what left in the last but one.
double sentAfter(HHD device, const double (&force)[3], int ticks) {
  double sent = -1;
  inTicks(ticks, [&](int) {
    hdBeginFrame(device);
    sent = sentForce();
    hdSetDoublev(HD_CURRENT_FORCE, force);
    hdEndFrame(device);
  });
  return sent;
}

TEST_F(Forces, ComeOutOnlyWhenEnabledAndServed) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdDisable(HD_FORCE_RAMPING);
  const double force[3] = {0, 0.5, 0};
  EXPECT_EQ(sentAfter(device, force, 3), 0.0);       // no scheduler
  hdStartScheduler();
  EXPECT_EQ(sentAfter(device, force, 3), 0.0);       // not enabled
  hdEnable(HD_FORCE_OUTPUT);
  EXPECT_NEAR(sentAfter(device, force, 5), 0.5, 1e-3);
  hdDisable(HD_FORCE_OUTPUT);
  EXPECT_EQ(sentAfter(device, force, 3), 0.0);
  EXPECT_TRUE(drain().empty());
}

TEST_F(Forces, AreClampedByDefaultAndRefusedOtherwise) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdEnable(HD_FORCE_OUTPUT);
  hdDisable(HD_FORCE_RAMPING);
  hdStartScheduler();
  const double force[3] = {0, 0, 20.0};
  EXPECT_NEAR(sentAfter(device, force, 5), 3.3, 0.02);
  EXPECT_TRUE(drain().empty());
  hdDisable(HD_MAX_FORCE_CLAMPING);
  EXPECT_LT(sentAfter(device, force, 5), 0.01);
  const auto codes = drain();
  ASSERT_FALSE(codes.empty());
  for (const HDerror code : codes) EXPECT_TRUE(code == HD_EXCEEDED_MAX_FORCE || code == HD_EXCEEDED_MAX_FORCE_IMPULSE) << code;
}

TEST_F(Forces, AddUpByReadingAndSettingAgain) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  onServo([&] {
    hdBeginFrame(device);
    for (int i = 0; i < 3; ++i) {
      float force[3];
      hdGetFloatv(HD_CURRENT_FORCE, force);
      force[1] += 0.25f;
      hdSetFloatv(HD_CURRENT_FORCE, force);
    }
    double sum[3];
    hdGetDoublev(HD_CURRENT_FORCE, sum);
    EXPECT_EQ(sum[1], 0.75);
    hdEndFrame(device);
  });
}

TEST_F(Forces, AndDacValuesDoNotMixInAFrame) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  const double force[3] = {0.1, 0, 0};
  const HDlong motors[3] = {100, 200, 300}, tooMuch[3] = {40000, 0, 0};
  onServo([&] {
    hdBeginFrame(device);
    hdSetLongv(HD_CURRENT_MOTOR_DAC_VALUES, motors);
    hdSetDoublev(HD_CURRENT_FORCE, force);
    EXPECT_EQ(drain(), std::vector<HDerror>{HD_FORCE_ERROR});
    hdEndFrame(device);
  });
  onServo([&] {
    hdBeginFrame(device);
    hdSetDoublev(HD_CURRENT_JOINT_TORQUE, force);
    hdSetLongv(HD_CURRENT_MOTOR_DAC_VALUES, motors);
    EXPECT_EQ(drain(), std::vector<HDerror>{HD_FORCE_ERROR});
    hdEndFrame(device);
  });
  onServo([&] {
    hdBeginFrame(device);
    hdSetLongv(HD_CURRENT_MOTOR_DAC_VALUES, tooMuch);
    EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_VALUE});
    hdEndFrame(device);
  });
}

TEST_F(Forces, ThatAreNoNumbersRaiseAnError) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdEnable(HD_FORCE_OUTPUT);
  hdStartScheduler();
  const double force[3] = {std::nan(""), 0, 0};
  EXPECT_EQ(sentAfter(device, force, 2), 0.0);
  const auto codes = drain();
  ASSERT_FALSE(codes.empty());
  EXPECT_EQ(codes[0], static_cast<HDerror>(HD_FORCE_ERROR));
}

TEST_F(Forces, EndWhenNobodyRendersThemAnyMore) {
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdEnable(HD_FORCE_OUTPUT);
  hdDisable(HD_FORCE_RAMPING);
  hdStartScheduler();
  const double force[3] = {0, 1.0, 0};
  sentAfter(device, force, 20);
  double position[3];
  inTicks(400, [](int) {});  // the callback is gone: held for 50 ms, then let go; the hand brings the stylus back
  hdGetDoublev(HD_CURRENT_POSITION, position);
  EXPECT_NEAR(position[1], 0.0, 0.3);
  HDlong motors[3];
  hdGetLongv(HD_CURRENT_MOTOR_DAC_VALUES, motors);
  EXPECT_EQ(motors[1], 0);
}

}  // namespace
}  // namespace halsted::hdtest
