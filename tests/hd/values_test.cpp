/// The numbers of the interface, one by one: a program compiled against another copy of the headers passes these.
#include <climits>
#include <map>
#include <type_traits>

#include "tests/hd/hd_rig.h"

namespace halsted::hdtest {
namespace {

struct Named { const char* name; long value, expected; };
#define NAMED(NAME, EXPECTED) Named{#NAME, static_cast<long>(NAME), EXPECTED}

void expectAll(std::initializer_list<Named> values) {
  for (const Named& value : values) EXPECT_EQ(value.value, value.expected) << value.name;
}

TEST(Values, OfErrors) {
  expectAll({NAMED(HD_SUCCESS, 0x0000), NAMED(HD_INVALID_ENUM, 0x0100), NAMED(HD_INVALID_VALUE, 0x0101), NAMED(HD_INVALID_OPERATION, 0x0102),
             NAMED(HD_INVALID_INPUT_TYPE, 0x0103), NAMED(HD_BAD_HANDLE, 0x0104), NAMED(HD_WARM_MOTORS, 0x0200),
             NAMED(HD_EXCEEDED_MAX_FORCE, 0x0201), NAMED(HD_EXCEEDED_MAX_FORCE_IMPULSE, 0x0202), NAMED(HD_EXCEEDED_MAX_VELOCITY, 0x0203),
             NAMED(HD_FORCE_ERROR, 0x0204), NAMED(HD_DEVICE_FAULT, 0x0300), NAMED(HD_DEVICE_ALREADY_INITIATED, 0x0301),
             NAMED(HD_COMM_ERROR, 0x0302), NAMED(HD_COMM_CONFIG_ERROR, 0x0303), NAMED(HD_TIMER_ERROR, 0x0304), NAMED(HD_ILLEGAL_BEGIN, 0x0400),
             NAMED(HD_ILLEGAL_END, 0x0401), NAMED(HD_FRAME_ERROR, 0x0402), NAMED(HD_INVALID_PRIORITY, 0x0500),
             NAMED(HD_SCHEDULER_FULL, 0x0501), NAMED(HD_INVALID_LICENSE, 0x0600)});
}

TEST(Values, OfParametersThatAreMeasured) {
  expectAll({NAMED(HD_CURRENT_BUTTONS, 0x2000), NAMED(HD_CURRENT_SAFETY_SWITCH, 0x2001), NAMED(HD_CURRENT_INKWELL_SWITCH, 0x2002),
             NAMED(HD_CURRENT_ENCODER_VALUES, 0x2010), NAMED(HD_CURRENT_PINCH_VALUE, 0x2011), NAMED(HD_LAST_PINCH_VALUE, 0x2012),
             NAMED(HD_CURRENT_POSITION, 0x2050), NAMED(HD_CURRENT_VELOCITY, 0x2051), NAMED(HD_CURRENT_TRANSFORM, 0x2052),
             NAMED(HD_CURRENT_ANGULAR_VELOCITY, 0x2053), NAMED(HD_CURRENT_JACOBIAN, 0x2054), NAMED(HD_CURRENT_JOINT_ANGLES, 0x2100),
             NAMED(HD_CURRENT_GIMBAL_ANGLES, 0x2150), NAMED(HD_LAST_BUTTONS, 0x2200), NAMED(HD_LAST_SAFETY_SWITCH, 0x2201),
             NAMED(HD_LAST_INKWELL_SWITCH, 0x2202), NAMED(HD_LAST_ENCODER_VALUES, 0x2210), NAMED(HD_LAST_POSITION, 0x2250),
             NAMED(HD_LAST_VELOCITY, 0x2251), NAMED(HD_LAST_TRANSFORM, 0x2252), NAMED(HD_LAST_ANGULAR_VELOCITY, 0x2253),
             NAMED(HD_LAST_JACOBIAN, 0x2254), NAMED(HD_LAST_JOINT_ANGLES, 0x2300), NAMED(HD_LAST_GIMBAL_ANGLES, 0x2350)});
}

TEST(Values, OfParametersOfTheDevice) {
  expectAll({NAMED(HD_VERSION, 0x2500), NAMED(HD_DEVICE_MODEL_TYPE, 0x2501), NAMED(HD_DEVICE_DRIVER_VERSION, 0x2502),
             NAMED(HD_DEVICE_VENDOR, 0x2503), NAMED(HD_DEVICE_SERIAL_NUMBER, 0x2504), NAMED(HD_DEVICE_FIRMWARE_VERSION, 0x2505),
             NAMED(HD_MAX_WORKSPACE_DIMENSIONS, 0x2550), NAMED(HD_USABLE_WORKSPACE_DIMENSIONS, 0x2551), NAMED(HD_TABLETOP_OFFSET, 0x2552),
             NAMED(HD_INPUT_DOF, 0x2553), NAMED(HD_OUTPUT_DOF, 0x2554), NAMED(HD_CALIBRATION_STYLE, 0x2555), NAMED(HD_UPDATE_RATE, 0x2600),
             NAMED(HD_INSTANTANEOUS_UPDATE_RATE, 0x2601), NAMED(HD_NOMINAL_MAX_STIFFNESS, 0x2602), NAMED(HD_NOMINAL_MAX_FORCE, 0x2603),
             NAMED(HD_NOMINAL_MAX_CONTINUOUS_FORCE, 0x2604), NAMED(HD_MOTOR_TEMPERATURE, 0x2605), NAMED(HD_SOFTWARE_VELOCITY_LIMIT, 0x2606),
             NAMED(HD_SOFTWARE_FORCE_IMPULSE_LIMIT, 0x2607), NAMED(HD_FORCE_RAMPING_RATE, 0x2608), NAMED(HD_NOMINAL_MAX_DAMPING, 0x2609),
             NAMED(HD_NOMINAL_MAX_TORQUE_STIFFNESS, 0x2620), NAMED(HD_NOMINAL_MAX_TORQUE_DAMPING, 0x2621),
             NAMED(HD_NOMINAL_MAX_TORQUE_FORCE, 0x2622), NAMED(HD_NOMINAL_MAX_TORQUE_CONTINUOUS_FORCE, 0x2623)});
}

TEST(Values, OfParametersThatAreCommanded) {
  expectAll({NAMED(HD_CURRENT_FORCE, 0x2700), NAMED(HD_CURRENT_TORQUE, 0x2701), NAMED(HD_JOINT_ANGLE_REFERENCES, 0x2702),
             NAMED(HD_CURRENT_JOINT_TORQUE, 0x2703), NAMED(HD_CURRENT_GIMBAL_TORQUE, 0x2704), NAMED(HD_CURRENT_MOTOR_DAC_VALUES, 0x2750),
             NAMED(HD_LAST_FORCE, 0x2800), NAMED(HD_LAST_TORQUE, 0x2801), NAMED(HD_LAST_JOINT_TORQUE, 0x2802),
             NAMED(HD_LAST_GIMBAL_TORQUE, 0x2803), NAMED(HD_LAST_MOTOR_DAC_VALUES, 0x2850), NAMED(HD_USER_STATUS_LIGHT, 0x2900),
             NAMED(LED_MASK, 7), NAMED(LED_STATUS_FAST_GRNYEL, 0), NAMED(LED_STATUS_SLOW_YEL, 1), NAMED(LED_STATUS_SLOW_GRN, 2),
             NAMED(LED_STATUS_FAST_GRN, 3), NAMED(LED_STATUS_SOLID_GRNYEL, 4), NAMED(LED_STATUS_SOLID_YEL, 5), NAMED(LED_STATUS_SOLID_GRN, 6),
             NAMED(LED_STATUS_FAST_YEL, 7)});
}

TEST(Values, OfCapabilitiesSchedulerAndCalibration) {
  expectAll({NAMED(HD_FORCE_OUTPUT, 0x4000), NAMED(HD_MAX_FORCE_CLAMPING, 0x4001), NAMED(HD_FORCE_RAMPING, 0x4002),
             NAMED(HD_SOFTWARE_FORCE_LIMIT, 0x4003), NAMED(HD_ONE_FRAME_LIMIT, 0x4004), NAMED(HD_MAX_SCHEDULER_PRIORITY, 65535),
             NAMED(HD_MIN_SCHEDULER_PRIORITY, 0), NAMED(HD_DEFAULT_SCHEDULER_PRIORITY, 32767), NAMED(HD_CALLBACK_DONE, 0),
             NAMED(HD_CALLBACK_CONTINUE, 1), NAMED(HD_WAIT_CHECK_STATUS, 0), NAMED(HD_WAIT_INFINITE, 1), NAMED(HD_CALIBRATION_OK, 0x5000),
             NAMED(HD_CALIBRATION_NEEDS_UPDATE, 0x5001), NAMED(HD_CALIBRATION_NEEDS_MANUAL_INPUT, 0x5002),
             NAMED(HD_CALIBRATION_ENCODER_RESET, 1), NAMED(HD_CALIBRATION_AUTO, 2), NAMED(HD_CALIBRATION_INKWELL, 4),
             NAMED(HD_DEVICE_BUTTON_1, 1), NAMED(HD_DEVICE_BUTTON_2, 2), NAMED(HD_DEVICE_BUTTON_3, 4), NAMED(HD_DEVICE_BUTTON_4, 8),
             NAMED(HD_TRUE, 1), NAMED(HD_FALSE, 0), NAMED(HD_INVALID_HANDLE, 0xffffffffL), NAMED(HD_VERSION_MAJOR_NUMBER, 3),
             NAMED(HD_VERSION_MINOR_NUMBER, 30), NAMED(HD_VERSION_BUILD_NUMBER, 0)});
  EXPECT_EQ(static_cast<HDstring>(HD_DEFAULT_DEVICE), nullptr);
}

TEST(Values, TypesAreThoseOfTheInterface) {
  static_assert(std::is_same_v<HDuint, unsigned> && std::is_same_v<HDerror, unsigned> && std::is_same_v<HDenum, unsigned>);
  static_assert(std::is_same_v<HHD, unsigned> && std::is_same_v<HDCallbackCode, unsigned> && std::is_same_v<HDWaitCode, unsigned>);
  static_assert(std::is_same_v<HDboolean, unsigned char> && std::is_same_v<HDushort, unsigned short> && std::is_same_v<HDchar, char>);
  static_assert(std::is_same_v<HDulong, unsigned long> && std::is_same_v<HDSchedulerHandle, unsigned long>);
  static_assert(std::is_same_v<HDint, int> && std::is_same_v<HDlong, long>);
  static_assert(std::is_same_v<HDfloat, float> && std::is_same_v<HDdouble, double> && std::is_same_v<HDstring, const char*>);
  static_assert(std::is_same_v<HDSchedulerCallback, unsigned (*)(void*)>);
  EXPECT_EQ(sizeof(HDErrorInfo), 12u);
  EXPECT_EQ(offsetof(HDErrorInfo, internalErrorCode), 4u);
  EXPECT_EQ(offsetof(HDErrorInfo, hHD), 8u);
}

using Behaviour = Hd;

/// What clients do that the manual does not forbid: start twice, stop twice, set a force in single precision, look at what is not there.
TEST_F(Behaviour, IsCalmAboutWhatClientsDo) {
  const HHD device = hdInitDevice("DEFAULT phantom");
  EXPECT_EQ(drain(), (device == HD_INVALID_HANDLE ? std::vector<HDerror>{HD_DEVICE_FAULT} : std::vector<HDerror>{}));
  const HHD same = device == HD_INVALID_HANDLE ? hdInitDevice("Default PHANTOM") : device;
  ASSERT_NE(same, HD_INVALID_HANDLE);
  hdStartScheduler();
  hdStartScheduler();
  hdEnable(HD_FORCE_OUTPUT);
  hdEnable(HD_FORCE_OUTPUT);
  inTicks(5, [&](int) {
    const HDfloat force[3] = {0.25f, 0.0f, -0.125f};
    HDfloat back[3] = {};
    hdBeginFrame(same);
    hdSetFloatv(HD_CURRENT_FORCE, force);
    hdGetFloatv(HD_CURRENT_FORCE, back);
    EXPECT_EQ(back[0], 0.25f);
    EXPECT_EQ(back[2], -0.125f);
    hdEndFrame(same);
  });
  hdStopScheduler();
  hdStopScheduler();
  EXPECT_TRUE(drain().empty());
  hdBeginFrame(HD_INVALID_HANDLE);
  hdEndFrame(7);
  hdMakeCurrentDevice(9);
  hdDisableDevice(HD_INVALID_HANDLE);
  EXPECT_EQ(drain(), (std::vector<HDerror>{HD_BAD_HANDLE, HD_BAD_HANDLE, HD_BAD_HANDLE, HD_BAD_HANDLE}));
  const HDboolean on = HD_TRUE;
  hdSetBooleanv(HD_FORCE_OUTPUT, &on);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_INVALID_ENUM});
}

}  // namespace
}  // namespace halsted::hdtest
