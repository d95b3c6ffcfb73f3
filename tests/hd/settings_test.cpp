/// Names, files and recorded hands: what the environment can say, and what it is told when it says it wrongly.
#include "haptics/hd/settings.h"

#include <chrono>
#include <cmath>
#include <cstring>

#include "haptics/hd/motion.h"
#include "tests/hd/hd_rig.h"
#include "tests/support/process.h"

namespace halsted::hdtest {
namespace {

using namespace haptics::hd;

class HdSettings : public Hd {
 protected:
  std::string file(const std::string& name, const std::string& text) {
    testing::writeText(folder_.file(name), text);
    return folder_.file(name);
  }
  testing::TemporaryFolder folder_;
};

TEST_F(HdSettings, TakeNamesFromTheEnvironment) {
  setenv("HALSTED_HD_DEVICES", "Alpha, Beta", 1);
  EXPECT_EQ(hdInitDevice("beta"), 0u);
  EXPECT_EQ(hdInitDevice(HD_DEFAULT_DEVICE), 1u);       // the first one
  EXPECT_EQ(hdInitDevice("Alpha"), HD_INVALID_HANDLE);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_DEVICE_ALREADY_INITIATED});
  EXPECT_EQ(hdInitDevice("left"), HD_INVALID_HANDLE);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_DEVICE_FAULT});
}

TEST_F(HdSettings, TakeDevicesFromAFile) {
  setenv("HALSTED_HD_CONFIG", file("a.toml", "[[device]]\nname = \"master\"\naliases = [\"m\"]\nserial = \"S1\"\nmodel = \"Omni\"\n"
                                             "start_mm = [10, 20.5, -3]\ncalibration = [\"auto\", \"inkwell\"]\nhand = \"light\"\n").c_str(), 1);
  EXPECT_EQ(hdInitDevice("M"), 0u);
  EXPECT_STREQ(hdGetString(HD_DEVICE_SERIAL_NUMBER), "S1");
  EXPECT_STREQ(hdGetString(HD_DEVICE_MODEL_TYPE), "Omni");
  EXPECT_EQ(hdCheckCalibrationStyle(), static_cast<HDenum>(HD_CALIBRATION_AUTO | HD_CALIBRATION_INKWELL));
  double position[3];
  hdGetDoublev(HD_CURRENT_POSITION, position);
  EXPECT_NEAR(position[0], 10.0, 0.03);                 // [mm] half an encoder step
  EXPECT_NEAR(position[1], 20.5, 0.03);
}

TEST_F(HdSettings, SayFileAndLineOfAMistake) {
  const std::pair<const char*, const char*> kMistakes[] = {
      {"[[device]]\nname = 3\n", ":2: name: must be text"},
      {"[[device]]\nname = \"a\"\nhand = \"iron\"\n", ":3: hand"},
      {"[[device]]\nname = \"a\"\nstart_mm = [1, 2]\n", ":3: start_mm"},
      {"[[device]]\nname = \"a\"\ncolour = 1\n", ":3: unknown key 'colour'"},
      {"[[device]]\nserial = \"a\"\n", ":1: device: no name"},
      {"[[device]]\nname = \"a\"\nmotion = \"../../etc/hand.csv\"\n", ":3: motion: a file beside this one"},
      {"[[device]]\nname = \"a\"\n\"two\\nlines\" = 1\n", "unknown key 'two lines'"},
      {"# a comment with \xc3\xa4\n[[device]]\nname = \"\xc3\xa4\"\n", ":3: a letter outside ASCII"},
      {"[!device]]\nname = \"a\"\n", "bad.toml"},
      {"device = 3\n", "no [[device]]"},
      {"[[device\n", ":1:"}};
  for (const auto& [text, message] : kMistakes) {
    try {
      readSettingsFile(file("bad.toml", text));
      FAIL() << text;
    } catch (const SettingsError& error) {
      EXPECT_NE(std::strstr(error.what(), message), nullptr) << error.what();
    }
  }
  setenv("HALSTED_HD_CONFIG", "/no/such/file.toml", 1);
  EXPECT_EQ(hdInitDevice(HD_DEFAULT_DEVICE), HD_INVALID_HANDLE);
  EXPECT_EQ(drain(), std::vector<HDerror>{HD_COMM_CONFIG_ERROR});
}

TEST_F(HdSettings, MotionFilesSayFileAndLineOfAMistake) {
  const std::pair<const char*, const char*> kMistakes[] = {
      {"", "no samples"},
      {"t_s,x_mm,y_mm\n0,0,0\n", ":1: no column 'z_mm'"},
      {"x_mm,y_mm,z_mm\n0,0,0\n", ":1: no column 't_s'"},
      {"t_s,x_mm,y_mm,z_mm\n0,0,0\n", ":2: too few columns"},
      {"t_s,x_mm,y_mm,z_mm\n0,0,zero,0\n", ":2: not a number: 'zero'"},
      {"t_s,x_mm,y_mm,z_mm\n0,0,nan,0\n", ":2: not a number"},
      {"t_s,x_mm,y_mm,z_mm\n0,0,9999,0\n", ":2: position farther than 1 m"},
      {"t_s,x_mm,y_mm,z_mm\n1,0,0,0\n0,0,0,0\n", ":3: time runs backwards"},
      {"t_s,x_mm,y_mm,z_mm\n-1e308,0,0,0\n1e308,0,0,0\n", ":2: a time that no clock shows"},
      {"t_s,x_mm,y_mm,z_mm,qx,qy,qz,qw\n1,0,0,0,0,0,0,0\n", ":2: not a unit quaternion"},
      {"t_s,x_mm,y_mm,z_mm,buttons\n1,0,0,0,99\n", ":2: buttons"}};
  for (const auto& [text, message] : kMistakes) {
    try {
      readMotion(file("bad.csv", text));
      FAIL() << text;
    } catch (const MotionError& error) {
      EXPECT_NE(std::strstr(error.what(), message), nullptr) << error.what();
    }
  }
}

TEST_F(HdSettings, MotionIsTheLineBetweenItsSamples) {
  const Motion motion = readMotion(file("m.csv", "t_s x_m y_m z_m\n5 0 0 0\n6 0.1 0 0\n8 0.1 0.2 0\n"));
  std::size_t cursor = 0;
  EXPECT_EQ(motion.duration(), 3.0);
  EXPECT_NEAR(sampleAt(motion, 0.25, cursor).pose.position.x(), 0.025, 1e-12);
  EXPECT_NEAR(sampleAt(motion, 2.0, cursor).pose.position.y(), 0.1, 1e-12);
  EXPECT_NEAR(sampleAt(motion, 99.0, cursor).pose.position.y(), 0.2, 1e-12);
  EXPECT_NEAR(sampleAt(motion, 0.5, cursor).pose.position.x(), 0.05, 1e-12);  // back again
}

/// How far the device is from the recording at its worst and on average, over the first two seconds [mm].
struct Tracking {
  double worst = 0.0, mean = 0.0;
};

Tracking play(const std::string& path, double lag) {  // [s]
  setenv("HALSTED_HD_MOTION", path.c_str(), 1);
  const Motion motion = readMotion(path);
  const HHD device = hdInitDevice(HD_DEFAULT_DEVICE);
  const auto start = std::chrono::steady_clock::now();  // the motion begins when the device is opened
  hdStartScheduler();
  Tracking tracking;
  std::size_t cursor = 0;
  const int ticks = 2000;
  inTicks(ticks, [&](int tick) {
    hdBeginFrame(device);
    double position[3];
    hdGetDoublev(HD_CURRENT_POSITION, position);
    hdEndFrame(device);
    if (tick < 200) return;
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const Vec3 wanted = sampleAt(motion, elapsed - lag, cursor).pose.position * 1e3;
    const double error = (Vec3(position[0], position[1], position[2]) - wanted).norm();
    tracking.worst = std::max(tracking.worst, error);
    tracking.mean += error / (ticks - 200);
  });
  EXPECT_TRUE(drain().empty());
  return tracking;
}

TEST_F(HdSettings, RecordedHandsOfAnOmniAndOfASurgicalToolMoveTheDevice) {
  const char* data = std::getenv("HALSTED_DATA");
  if (!data) GTEST_SKIP() << "HALSTED_DATA is not set";
  const Tracking omni = play(std::string(data) + "/traces/omni-hand/master_state.csv", 6e-3);
  std::printf("omni-hand: mean %.2f mm, worst %.2f mm\n", omni.mean, omni.worst);
  EXPECT_LT(omni.mean, 1.5);
  hdStopScheduler();
  hdDisableDevice(0);
  const Tracking tool = play(std::string(data) + "/traces/davinci-tool-1khz/Tool_4_Maryland_L_2_00.TXT", 6e-3);
  std::printf("davinci-tool: mean %.2f mm, worst %.2f mm\n", tool.mean, tool.worst);
  EXPECT_LT(tool.mean, 1.5);
}

}  // namespace
}  // namespace halsted::hdtest
