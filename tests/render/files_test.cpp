// Laws of the files the renderer writes.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "render/png.h"
#include "render/video.h"

namespace halsted::render {
namespace {

namespace fs = std::filesystem;

struct Folder {                                          // its own, removed at the end
  fs::path path = fs::temp_directory_path() / ("halsted_files_" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

Frame gradient(int width, int height) {
  Frame f{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c : {x * 3 % 256, y * 5 % 256, (x ^ y) % 256, 255}) f.rgba.push_back(static_cast<std::uint8_t>(c));
  return f;
}

std::string bytes(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

std::string errorOf(const std::function<void()>& act) {
  try { act(); } catch (const std::runtime_error& e) { return e.what(); }
  return "";
}

TEST(Png, ReadsBackWhatItWrote) {
  const Folder folder;
  const Frame frame = gradient(61, 37);
  writePng(folder.path / "a.png", frame);
  const Frame back = readPng(folder.path / "a.png");
  EXPECT_EQ(back.width, 61);
  EXPECT_EQ(back.height, 37);
  EXPECT_EQ(back.rgba, frame.rgba);
}

TEST(Png, GivesTheSameBytesForTheSamePicture) {
  const Folder folder;
  writePng(folder.path / "a.png", gradient(64, 48));
  writePng(folder.path / "b.png", gradient(64, 48));
  EXPECT_EQ(bytes(folder.path / "a.png"), bytes(folder.path / "b.png"));
}

TEST(Png, NamesTheFileThatItCannotWriteOrRead) {
  const Folder folder;
  EXPECT_NE(errorOf([&] { writePng(folder.path / "none" / "a.png", gradient(8, 8)); }).find("a.png: No such file"), std::string::npos);
  std::ofstream(folder.path / "bad.png") << "not a picture at all";
  EXPECT_NE(errorOf([&] { readPng(folder.path / "bad.png"); }).find("bad.png"), std::string::npos);
}

TEST(Video, IsAnMp4ThatFfmpegFinished) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const Folder folder;
  VideoWriter video(folder.path / "a.mp4", {64, 48, 30.0});
  for (int i = 0; i < 12; ++i) video.add(gradient(64, 48));
  video.finish();
  const std::string film = bytes(folder.path / "a.mp4");
  ASSERT_GT(film.size(), 500u);
  EXPECT_EQ(film.substr(4, 4), "ftyp");
  EXPECT_NE(film.find("avc1"), std::string::npos);       // H.264
}

TEST(Video, SaysWhichProgramIsMissing) {
  const Folder folder;
  const std::string said = errorOf([&] { VideoWriter(folder.path / "a.mp4", {64, 48, 30.0}, "no-such-encoder"); });
  EXPECT_NE(said.find("no-such-encoder: not found"), std::string::npos) << said;
}

TEST(Video, ReportsAChildThatDiesAndSurvivesTheBrokenPipe) {
  const Folder folder;
  VideoWriter video(folder.path / "a.mp4", {640, 480, 30.0}, "false");
  const std::string said = errorOf([&] {
    for (int i = 0; i < 20; ++i) video.add(gradient(640, 480));
  });
  EXPECT_NE(said.find("ffmpeg stopped early"), std::string::npos) << said;
  sigset_t pending;
  sigpending(&pending);
  EXPECT_FALSE(sigismember(&pending, SIGPIPE));          // no signal is left behind for someone else
}

TEST(Video, PassesOnWhatFfmpegComplainedOf) {
  if (std::system("ffmpeg -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffmpeg is not installed";
  const Folder folder;
  const std::string said = errorOf([&] {
    VideoWriter video(folder.path / "none" / "a.mp4", {640, 480, 30.0});
    for (int i = 0; i < 20; ++i) video.add(gradient(640, 480));
    video.finish();
  });
  EXPECT_NE(said.find("No such file"), std::string::npos) << said;
}

TEST(Video, LeavesNoChildBehind) {
  const Folder folder;
  { VideoWriter video(folder.path / "a.mp4", {64, 48, 30.0}, "cat"); }
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);          // ECHILD: every child was waited for
}

TEST(Video, RefusesOddSizes) {
  const Folder folder;
  EXPECT_NE(errorOf([&] { VideoWriter(folder.path / "a.mp4", {63, 48, 30.0}); }).find("even"), std::string::npos);
}

}  // namespace
}  // namespace halsted::render
