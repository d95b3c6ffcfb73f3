/// The sample programs, run as a user runs them; what they print is checked against what the physics says.
#include <gmock/gmock.h>

#include <cstdio>

#include "tests/hd/hd_rig.h"
#include "tests/support/process.h"

namespace halsted::hdtest {
namespace {

using ::testing::HasSubstr;
using testing::ProcessResult;

ProcessResult sample(const std::string& name) { return testing::run({std::string(HD_SAMPLES) + "/hd_" + name}); }

/// The numbers after a word of a line.
std::vector<double> after(const std::string& text, const std::string& word, int count) {
  std::vector<double> numbers;
  std::size_t at = text.find(word);
  if (at == std::string::npos) return numbers;
  at += word.size();
  for (int i = 0; i < count; ++i) {
    int used = 0;
    double value = 0.0;
    if (std::sscanf(text.c_str() + at, " %lf%n", &value, &used) != 1) break;
    numbers.push_back(value);
    at += static_cast<std::size_t>(used);
  }
  return numbers;
}

class Samples : public Hd {
 protected:
  void motion(const std::string& rows) {
    testing::writeText(folder_.file("hand.csv"), rows);
    setenv("HALSTED_HD_MOTION", folder_.file("hand.csv").c_str(), 1);
  }
  void config(const std::string& toml) {
    testing::writeText(folder_.file("hd.toml"), toml);
    setenv("HALSTED_HD_CONFIG", folder_.file("hd.toml").c_str(), 1);
  }
  testing::TemporaryFolder folder_;
};

TEST_F(Samples, QueryDeviceTellsWhatTheDeviceIs) {
  const ProcessResult result = sample("query_device");
  EXPECT_EQ(result.exitCode, 0) << result.errors;
  EXPECT_THAT(result.output, HasSubstr("handle 0 model Touch vendor Halsted (virtual device)"));
  EXPECT_THAT(result.output, HasSubstr("dof 6 force 3.30 N workspace -80 -60 -35 to 80 60 35 mm"));
  EXPECT_THAT(result.output, HasSubstr("ticks ok"));
  EXPECT_THAT(result.output, HasSubstr("end: HD_SUCCESS"));
}

TEST_F(Samples, AnchoredSpringPullsByItsStiffness) {
  motion("t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0.3,20,0,0\n");
  const ProcessResult result = sample("anchored_spring");
  EXPECT_THAT(result.output, HasSubstr("ticks 600 errors 0"));
  EXPECT_THAT(result.output, HasSubstr("ratio 0.100 N/mm"));
  const auto distance = after(result.output, "distance", 1);
  ASSERT_EQ(distance.size(), 1u) << result.output;
  EXPECT_NEAR(distance[0], 20.0, 4.0);  // the hand gives way to the spring until its eye corrects it
}

TEST_F(Samples, PlanePushesUpOnly) {
  motion("t_s,x_mm,y_mm,z_mm\n0,0,10,0\n0.2,0,10,0\n0.5,5,-6,0\n0.8,20,-6,0\n");
  const ProcessResult result = sample("frictionless_plane");
  EXPECT_EQ(after(result.output, "sideways", 1), std::vector<double>{0.0}) << result.output;
  const auto depth = after(result.output, "deepest", 1), force = after(result.output, "force", 1);
  ASSERT_EQ(depth.size() + force.size(), 2u) << result.output;
  EXPECT_GT(depth[0], 3.0);
  EXPECT_NEAR(force[0], 0.25 * depth[0], 2e-3);
  EXPECT_THAT(result.output, HasSubstr("errors 0 unscheduled_twice 1"));
}

TEST_F(Samples, SpherePushesOutward) {
  motion("t_s,x_mm,y_mm,z_mm\n0,-40,10,0\n0.4,0,26,5\n0.75,40,10,0\n");
  const ProcessResult result = sample("frictionless_sphere");
  EXPECT_THAT(result.output, HasSubstr("cosine 1.000000 transform 0.000000 mm"));
  EXPECT_GT(after(result.output, "largest", 1).at(0), 0.5);
}

TEST_F(Samples, VibrationIsFeltAtItsFrequency) {
  const ProcessResult result = sample("vibration");
  EXPECT_THAT(result.output, HasSubstr("crossings 99 rate 1000 errors 0"));   // 50 Hz for a second
  const double moved = after(result.output, "motion", 1).at(0);                // [mm] 0.75 N on 45 g in a grip of 400 N/m
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(moved, 4.0);
}

TEST_F(Samples, CalibrationIsDoneByTheProgramWithAnEncoderReset) {
  config("[[device]]\nname = \"one\"\ncalibrated = false\ncalibration = [\"encoder-reset\"]\n");
  const ProcessResult result = sample("calibration");
  EXPECT_THAT(result.output, HasSubstr("styles 1 first needs_update"));
  EXPECT_THAT(result.output, HasSubstr("last ok asked 0 error 0 position 0.00 0.00 0.00"));
  const auto before = after(result.output, "needs_update position", 3);
  ASSERT_EQ(before.size(), 3u) << result.output;
  EXPECT_GT(std::abs(before[0]) + std::abs(before[1]) + std::abs(before[2]), 5.0);  // the encoders were wrong
}

TEST_F(Samples, CalibrationWaitsForTheInkwell) {
  testing::writeText(folder_.file("dock.csv"), "t_s,x_mm,y_mm,z_mm,inkwell\n0,0,0,0,0\n0.2,0,-65,-80,0\n0.3,0,-65,-80,1\n1,0,-65,-80,1\n");
  config("[[device]]\nname = \"one\"\ncalibrated = false\ncalibration = \"inkwell\"\nmotion = \"dock.csv\"\n");
  const ProcessResult result = sample("calibration");
  EXPECT_THAT(result.output, HasSubstr("styles 4 first needs_manual_input"));
  EXPECT_THAT(result.output, HasSubstr("last ok asked 1 error 0"));
}

TEST_F(Samples, ErrorHandlingSeesEveryMistakeLastOneFirst) {
  const ProcessResult result = sample("error_handling");
  EXPECT_THAT(result.output, HasSubstr("frames ok wrong 0"));
  std::size_t at = 0;
  for (const char* name : {"init HD_DEVICE_FAULT", "init HD_DEVICE_ALREADY_INITIATED", "mistake HD_ILLEGAL_BEGIN", "mistake HD_BAD_HANDLE",
                           "mistake HD_INVALID_ENUM", "mistake HD_INVALID_INPUT_TYPE", "mistake HD_FRAME_ERROR", "mistake HD_ILLEGAL_END"}) {
    const std::size_t found = result.output.find(name, at);
    ASSERT_NE(found, std::string::npos) << name << " in\n" << result.output;
    at = found;
  }
}

TEST_F(Samples, JointTorquesForcesAndDacValuesPushAlike) {
  const ProcessResult result = sample("joint_torque");
  const auto torque = after(result.output, "torque", 3), force = after(result.output, "force", 3), motors = after(result.output, "motors", 3);
  ASSERT_EQ(torque.size() + force.size() + motors.size(), 9u) << result.output;
  EXPECT_THAT(result.output, HasSubstr("errors 0"));
  EXPECT_GT(force[1], 0.3);                                          // [mm] it moved
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(torque[axis], force[axis], 0.12) << result.output;   // two encoder steps
    EXPECT_NEAR(motors[axis], force[axis], 0.12) << result.output;
  }
}

TEST_F(Samples, ServoRateRunsAtEachRate) {
  const ProcessResult result = sample("servo_rate");
  for (const double rate : {500.0, 1000.0, 2000.0}) {
    const auto line = after(result.output, "rate " + std::to_string(static_cast<int>(rate)) + " nominal", 1);
    ASSERT_EQ(line.size(), 1u) << result.output;
    EXPECT_EQ(line[0], rate);
    const std::string rest = result.output.substr(result.output.find("rate " + std::to_string(static_cast<int>(rate))));
    EXPECT_NEAR(after(rest, "median", 1).at(0), rate, 0.1 * rate) << result.output;  // of 400 ticks
  }
  EXPECT_THAT(result.output, HasSubstr("odd rate: HD_INVALID_VALUE"));
}

TEST_F(Samples, TwoDevicesPullEachOtherWithEqualForces) {
  testing::writeText(folder_.file("left.csv"), "t_s,x_mm,y_mm,z_mm\n0,0,0,0\n0.3,40,0,0\n");
  setenv("HALSTED_HD_MOTION", ("left=" + folder_.file("left.csv")).c_str(), 1);
  const ProcessResult result = sample("two_devices");
  EXPECT_GT(after(result.output, "left", 1).at(0), 30.0) << result.output;
  EXPECT_GT(after(result.output, "right", 1).at(0), 0.3) << result.output;
  EXPECT_THAT(result.output, HasSubstr("sum 0.000000 N errors 0 handles 0 1"));
}

TEST_F(Samples, DlopenNeedsNoHeader) {
  const ProcessResult result = testing::run({std::string(HD_SAMPLES) + "/hd_dlopen_client", HD_LIBRARY});
  EXPECT_THAT(result.output, HasSubstr("dlopen device 0 position 0.000 0.000 0.000 error 0"));
  EXPECT_EQ(result.exitCode, 0);
}

TEST_F(Samples, PythonCallsItThroughCtypes) {
#ifdef HALSTED_SANITIZED
  GTEST_SKIP() << "a sanitized library needs a sanitized interpreter";
#endif
  if (testing::run({"/bin/sh", "-c", "command -v python3"}).exitCode != 0) GTEST_SKIP() << "python3 is not installed";
  const ProcessResult result =
      testing::run({"/bin/sh", "-c", std::string("exec python3 ") + HD_TEST_FOLDER + "/samples/ctypes_client.py " + HD_LIBRARY});
  EXPECT_THAT(result.output, HasSubstr("ctypes Touch ticks 100 waited 1 error 0 x 0.0")) << result.errors;
}

}  // namespace
}  // namespace halsted::hdtest
