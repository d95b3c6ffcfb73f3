/// Every parameter: its type, its count, its value at rest; what can be set and enabled.
#include <cmath>
#include <cstring>
#include <string>

#include "haptics/kinematics.h"
#include "tests/hd/hd_rig.h"

namespace halsted::hdtest {
namespace {

using Parameters = Hd;
using haptics::TouchGimbal;
using haptics::TouchJoints;

constexpr double kMark = 12345.0;

/// How many doubles a parameter writes; 0 when it is no floating-point one.
int realCount(HDenum name) {
  double values[64];
  for (double& value : values) value = kMark;
  hdGetDoublev(name, values);
  int count = 0;
  while (count < 64 && values[count] != kMark) ++count;
  return count;
}

TEST_F(Parameters, OfFloatingPointHaveTheirCounts) {
  hdInitDevice(HD_DEFAULT_DEVICE);
  const std::pair<HDenum, int> kCounts[] = {
      {HD_CURRENT_POSITION, 3}, {HD_CURRENT_VELOCITY, 3}, {HD_CURRENT_TRANSFORM, 16}, {HD_CURRENT_ANGULAR_VELOCITY, 3},
      {HD_CURRENT_JACOBIAN, 36}, {HD_CURRENT_JOINT_ANGLES, 3}, {HD_CURRENT_GIMBAL_ANGLES, 3}, {HD_LAST_POSITION, 3},
      {HD_LAST_VELOCITY, 3}, {HD_LAST_TRANSFORM, 16}, {HD_LAST_ANGULAR_VELOCITY, 3}, {HD_LAST_JACOBIAN, 36}, {HD_LAST_JOINT_ANGLES, 3},
      {HD_LAST_GIMBAL_ANGLES, 3}, {HD_DEVICE_FIRMWARE_VERSION, 1}, {HD_MAX_WORKSPACE_DIMENSIONS, 6}, {HD_USABLE_WORKSPACE_DIMENSIONS, 6},
      {HD_TABLETOP_OFFSET, 1}, {HD_UPDATE_RATE, 1}, {HD_INSTANTANEOUS_UPDATE_RATE, 1}, {HD_NOMINAL_MAX_STIFFNESS, 1},
      {HD_NOMINAL_MAX_FORCE, 1}, {HD_NOMINAL_MAX_CONTINUOUS_FORCE, 1}, {HD_MOTOR_TEMPERATURE, 3}, {HD_SOFTWARE_VELOCITY_LIMIT, 1},
      {HD_SOFTWARE_FORCE_IMPULSE_LIMIT, 1}, {HD_FORCE_RAMPING_RATE, 1}, {HD_NOMINAL_MAX_DAMPING, 1}, {HD_NOMINAL_MAX_TORQUE_STIFFNESS, 1},
      {HD_NOMINAL_MAX_TORQUE_DAMPING, 1}, {HD_NOMINAL_MAX_TORQUE_FORCE, 1}, {HD_NOMINAL_MAX_TORQUE_CONTINUOUS_FORCE, 1},
      {HD_CURRENT_FORCE, 3}, {HD_CURRENT_TORQUE, 3}, {HD_JOINT_ANGLE_REFERENCES, 6}, {HD_CURRENT_JOINT_TORQUE, 3},
      {HD_CURRENT_GIMBAL_TORQUE, 3}, {HD_LAST_FORCE, 3}, {HD_LAST_TORQUE, 3}, {HD_LAST_JOINT_TORQUE, 3}, {HD_LAST_GIMBAL_TORQUE, 3}};
  for (const auto& [name, count] : kCounts) {
    EXPECT_EQ(realCount(name), count) << std::hex << name;
    float values[36];
    hdGetFloatv(name, values);
    EXPECT_TRUE(drain().empty()) << std::hex << name;
  }
}

TEST_F(Parameters, OfIntegersHaveTheirTypes) {
  hdInitDevice(HD_DEFAULT_DEVICE);
  for (const HDenum name : {HD_CURRENT_BUTTONS, HD_LAST_BUTTONS, HD_INPUT_DOF, HD_OUTPUT_DOF, HD_CALIBRATION_STYLE, HD_UPDATE_RATE,
                            HD_INSTANTANEOUS_UPDATE_RATE, HD_USER_STATUS_LIGHT, HD_CURRENT_SAFETY_SWITCH}) {
    HDint value = -77;
    hdGetIntegerv(name, &value);
    EXPECT_NE(value, -77) << std::hex << name;
  }
  for (const HDenum name : {HD_CURRENT_SAFETY_SWITCH, HD_CURRENT_INKWELL_SWITCH, HD_LAST_SAFETY_SWITCH, HD_LAST_INKWELL_SWITCH}) {
    HDboolean value = 77;
    hdGetBooleanv(name, &value);
    EXPECT_EQ(value, 1) << std::hex << name;
  }
  for (const HDenum name : {HD_CURRENT_ENCODER_VALUES, HD_LAST_ENCODER_VALUES}) {
    HDlong values[7] = {-77777, -77777, -77777, -77777, -77777, -77777, -77777};
    hdGetLongv(name, values);
    EXPECT_NE(values[5], -77777);
    EXPECT_EQ(values[6], -77777);
  }
  for (const HDenum name : {HD_CURRENT_MOTOR_DAC_VALUES, HD_LAST_MOTOR_DAC_VALUES}) {
    HDlong values[4] = {-77777, -77777, -77777, -77777};
    hdGetLongv(name, values);
    EXPECT_EQ(values[2], 0);
    EXPECT_EQ(values[3], -77777);  // three motors
  }
  EXPECT_TRUE(drain().empty());
}

TEST_F(Parameters, OfAnotherTypeOrNameRaiseAnErrorAndWriteNothing) {
  hdInitDevice(HD_DEFAULT_DEVICE);
  HDint whole[3] = {5, 5, 5};
  hdGetIntegerv(HD_CURRENT_POSITION, whole);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_INPUT_TYPE});
  EXPECT_EQ(whole[0], 5);
  double real[3] = {5, 5, 5};
  hdGetDoublev(HD_CURRENT_BUTTONS, real);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_INPUT_TYPE});
  hdGetDoublev(0x2999, real);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_ENUM});
  hdGetDoublev(HD_CURRENT_POSITION, nullptr);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_VALUE});
  EXPECT_EQ(real[0], 5);
  EXPECT_STREQ(hdGetString(HD_CURRENT_POSITION), "");
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_INPUT_TYPE});
  hdSetDoublev(HD_CURRENT_POSITION, real);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_ENUM});
}

TEST_F(Parameters, NeedADeviceUnlessTheyBelongToTheLibrary) {
  double value = kMark;
  hdGetDoublev(HD_NOMINAL_MAX_FORCE, &value);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_OPERATION});
  EXPECT_EQ(value, kMark);
  HDint rate = 0;
  hdGetIntegerv(HD_UPDATE_RATE, &rate);
  EXPECT_EQ(rate, 1000);
  EXPECT_STREQ(hdGetString(HD_VERSION), "3.30.0");
  EXPECT_TRUE(drain().empty());
}

TEST_F(Parameters, DescribeOneArm) {
  setenv("HALSTED_HD_MOTION", (std::string(HD_TEST_FOLDER) + "/reach.csv").c_str(), 1);
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  inTicks(300, [&](int) {
    hdBeginFrame(device);
    double position[3], angles[3], gimbal[3], transform[16], jacobian[36], scaled[16];
    hdGetDoublev(HD_CURRENT_POSITION, position);
    hdGetDoublev(HD_CURRENT_JOINT_ANGLES, angles);
    hdGetDoublev(HD_CURRENT_GIMBAL_ANGLES, gimbal);
    hdGetDoublev(HD_CURRENT_TRANSFORM, transform);
    hdGetDoublev(HD_CURRENT_JACOBIAN, jacobian);
    hdScaleGimbalAngles(1.0, 1.0, 1.0, scaled);
    hdEndFrame(device);
    const TouchJoints joints(angles[0], angles[1], angles[2]);
    const Vec3 reached = haptics::touchPosition(joints) * 1e3;
    const Mat3 turned = haptics::touchOrientation(joints, TouchGimbal(gimbal[0], gimbal[1], gimbal[2])).toRotationMatrix();
    const Mat3 slope = haptics::touchJacobian(joints) * 1e3;
    for (int row = 0; row < 3; ++row) {
      ASSERT_NEAR(position[row], reached[row], 1e-6);
      ASSERT_EQ(transform[12 + row], position[row]);
      for (int column = 0; column < 3; ++column) {
        ASSERT_NEAR(transform[4 * column + row], turned(row, column), 1e-9);
        ASSERT_NEAR(jacobian[6 * row + column], slope(row, column), 1e-9);
      }
    }
    for (int i = 0; i < 16; ++i) ASSERT_NEAR(scaled[i], transform[i], 1e-9);
  });
  EXPECT_TRUE(drain().empty());
}

TEST_F(Parameters, FollowTheMotionOfTheHand) {
  setenv("HALSTED_HD_MOTION", (std::string(HD_TEST_FOLDER) + "/reach.csv").c_str(), 1);
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  hdStartScheduler();
  double velocity[3] = {}, spin[3] = {};
  HDint buttons = 0, last = 0, edges = 0;
  bool docked = false;
  inTicks(450, [&](int tick) {
    hdBeginFrame(device);
    if (tick == 150) hdGetDoublev(HD_CURRENT_VELOCITY, velocity);
    if (tick == 150) hdGetDoublev(HD_CURRENT_ANGULAR_VELOCITY, spin);
    hdGetIntegerv(HD_CURRENT_BUTTONS, &buttons);
    hdGetIntegerv(HD_LAST_BUTTONS, &last);
    edges += (buttons & HD_DEVICE_BUTTON_1) && !(last & HD_DEVICE_BUTTON_1);
    HDboolean out = 1;
    hdGetBooleanv(HD_CURRENT_INKWELL_SWITCH, &out);
    docked = docked || !out;
    hdEndFrame(device);
  });
  EXPECT_EQ(edges, 1);
  EXPECT_TRUE(docked);
  EXPECT_NEAR(velocity[0], 100.0, 25.0);   // [mm/s] 30 mm in 0.3 s
  EXPECT_NEAR(spin[1], 1.745, 0.5);        // [rad/s] 30 degrees in 0.3 s about y
}

TEST_F(Parameters, OfTheDeviceAreThoseOfATouch) {
  hdInitDevice(HD_DEFAULT_DEVICE);
  double value = 0, box[6];
  hdGetDoublev(HD_NOMINAL_MAX_FORCE, &value);
  EXPECT_DOUBLE_EQ(value, 3.3);
  hdGetDoublev(HD_NOMINAL_MAX_CONTINUOUS_FORCE, &value);
  EXPECT_DOUBLE_EQ(value, 0.88);
  hdGetDoublev(HD_NOMINAL_MAX_STIFFNESS, &value);
  EXPECT_DOUBLE_EQ(value, 0.5);
  hdGetDoublev(HD_MAX_WORKSPACE_DIMENSIONS, box);
  const double expected[6] = {-210, -110, -85, 210, 205, 130};
  EXPECT_EQ(std::memcmp(box, expected, sizeof box), 0);
  HDint style = 0;
  hdGetIntegerv(HD_CALIBRATION_STYLE, &style);
  EXPECT_EQ(style, HD_CALIBRATION_ENCODER_RESET | HD_CALIBRATION_INKWELL);
  EXPECT_EQ(hdCheckCalibrationStyle(), static_cast<HDenum>(style));
  EXPECT_EQ(hdCheckCalibration(), static_cast<HDenum>(HD_CALIBRATION_OK));
  EXPECT_TRUE(hdDeploymentLicense("a", "b", "c"));
}

TEST_F(Parameters, ThatCanBeEnabledStartAtTheirDefaults) {
  hdInitDevice(HD_DEFAULT_DEVICE);
  EXPECT_FALSE(hdIsEnabled(HD_FORCE_OUTPUT));
  for (const HDenum cap : {HD_MAX_FORCE_CLAMPING, HD_FORCE_RAMPING, HD_SOFTWARE_FORCE_LIMIT, HD_ONE_FRAME_LIMIT, HD_SOFTWARE_VELOCITY_LIMIT,
                           HD_SOFTWARE_FORCE_IMPULSE_LIMIT}) {
    EXPECT_TRUE(hdIsEnabled(cap)) << std::hex << cap;
    hdDisable(cap);
    EXPECT_FALSE(hdIsEnabled(cap));
    hdEnable(cap);
    EXPECT_TRUE(hdIsEnabled(cap));
  }
  EXPECT_TRUE(drain().empty());
  EXPECT_FALSE(hdIsEnabled(HD_CURRENT_FORCE));
  hdDisable(HD_CURRENT_FORCE);
  EXPECT_EQ(drain(), (std::vector<HDerror>{HD_INVALID_ENUM, HD_INVALID_ENUM}));
}

TEST_F(Parameters, ThatCanBeSetStay) {
  hdInitDevice(HD_DEFAULT_DEVICE);
  for (const HDenum name : {HD_SOFTWARE_VELOCITY_LIMIT, HD_SOFTWARE_FORCE_IMPULSE_LIMIT, HD_FORCE_RAMPING_RATE}) {
    const double wanted = 12.5, wrong = -1.0;
    double value = 0;
    hdSetDoublev(name, &wanted);
    hdGetDoublev(name, &value);
    EXPECT_EQ(value, wanted);
    hdSetDoublev(name, &wrong);
    EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_VALUE});
  }
  const HDint light = LED_STATUS_SOLID_GRN, none = 8;
  HDint seen = 0;
  hdSetIntegerv(HD_USER_STATUS_LIGHT, &light);
  hdGetIntegerv(HD_USER_STATUS_LIGHT, &seen);
  EXPECT_EQ(seen, light);
  hdSetIntegerv(HD_USER_STATUS_LIGHT, &none);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_VALUE});
}

}  // namespace
}  // namespace halsted::hdtest
