/// The training window on a real X server without a screen (Xvfb): what was rendered is what one sees.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/window.h"
#include "tests/support/process.h"

namespace halsted::app {
namespace {

using halsted::testing::RunningProcess;
using halsted::testing::TemporaryFolder;

constexpr int kWidth = 320, kHeight = 200;
const char* const kServer = "/usr/bin/Xvfb";

/// An X server whose screen is a file in XWD format.
class Screen {
 public:
  Screen() {
    const std::string number = freeNumber();
    server_ = std::make_unique<RunningProcess>(std::vector<std::string>{kServer, ":" + number, "-screen", "0", "640x480x24", "-fbdir", folder_.path()});
    setenv("DISPLAY", (":" + number).c_str(), 1);
    for (int i = 0; i < 100 && !std::filesystem::exists("/tmp/.X11-unix/X" + number); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }

  ~Screen() {                                  // a server that is killed leaves its lock behind
    server_->send(SIGTERM);
    server_->wait();
  }

  /// Red, green, blue at a pixel of the screen.
  std::array<int, 3> pixel(int x, int y) const {
    const std::string dump = halsted::testing::readText(folder_.file("Xvfb_screen0"));
    const auto word = [&](int i) {
      std::size_t value = 0;
      for (int b = 0; b < 4; ++b) value = value << 8 | static_cast<unsigned char>(dump[static_cast<std::size_t>(4 * i + b)]);
      return value;
    };
    const std::size_t header = word(0), lineBytes = word(12), colours = word(19);   // XWDFileHeader
    const std::size_t at = header + 12 * colours + static_cast<std::size_t>(y) * lineBytes + 4 * static_cast<std::size_t>(x);
    const auto byte = [&](std::size_t i) { return static_cast<int>(static_cast<unsigned char>(dump[at + i])); };
    return {byte(2), byte(1), byte(0)};
  }

 private:
  /// A display that no server has, nor left behind when it was killed.
  static std::string freeNumber() {
    int number = 100 + getpid() % 400;
    const auto taken = [&](const char* before, const char* after) { return std::filesystem::exists(before + std::to_string(number) + after); };
    while (taken("/tmp/.X", "-lock") || taken("/tmp/.X11-unix/X", "")) ++number;
    return std::to_string(number);
  }

  TemporaryFolder folder_;
  std::unique_ptr<RunningProcess> server_;
};

/// Red top left, green top right, blue bottom left, white bottom right.
render::Frame quarters() {
  render::Frame frame{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool right = x >= kWidth / 2, bottom = y >= kHeight / 2;
      const std::uint8_t red = right == bottom ? 255 : 0, green = right ? 255 : 0, blue = bottom ? 255 : 0;
      for (std::uint8_t channel : {red, green, blue, std::uint8_t{255}}) frame.rgba.push_back(channel);
    }
  return frame;
}

TEST(Window, ShowsTheFrameAsItWasRendered) {
  if (!std::filesystem::exists(kServer)) GTEST_SKIP() << "needs Xvfb";
  const Screen screen;
  Window window("Halsted", kWidth, kHeight, Pose{}, CameraView{});
  using Rgb = std::array<int, 3>;
  for (int i = 0; i < 50 && screen.pixel(kWidth / 4, kHeight / 4) != Rgb{255, 0, 0}; ++i) {
    window.show(quarters());
    window.poll();
  }
  EXPECT_EQ(screen.pixel(kWidth / 4, kHeight / 4), (Rgb{255, 0, 0}));
  EXPECT_EQ(screen.pixel(3 * kWidth / 4, kHeight / 4), (Rgb{0, 255, 0}));
  EXPECT_EQ(screen.pixel(kWidth / 4, 3 * kHeight / 4), (Rgb{0, 0, 255}));
  EXPECT_EQ(screen.pixel(3 * kWidth / 4, 3 * kHeight / 4), (Rgb{255, 255, 255}));
  EXPECT_FALSE(window.closed());
}

}  // namespace
}  // namespace halsted::app
