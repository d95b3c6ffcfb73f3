#pragma once
/// Draws a run in lockstep and writes PNG frames and a video of it. One thread.
#include <memory>
#include <string>
#include <vector>

#include "app/banner.h"
#include "app/lockstep.h"

namespace halsted::app {

struct FrameOptions {
  std::string folder;                          // PNG files go here; empty: none
  std::string video;                           // video file; empty: none
  double fps = 30.0;                           // [Hz] of simulated time
  int width = 1280, height = 720;              // pixels
  std::vector<double> times;                   // [s] PNG frames at these times only; empty: all of them
};

class FrameWriter {
 public:
  FrameWriter(const FrameOptions&, const Scenario&);             // throws scenes::InputError, SystemFault
  ~FrameWriter();

  /// After each step: draws what has become due. False when nothing more can: frames at given times alone, and the last is drawn.
  bool see(const Lockstep&);
  /// Completes the video; the outcome as text.
  std::string finish();

 private:
  void beginAt(double time);                   // [s] of the first state seen
  void drawFrame(const Lockstep&, bool toVideo, bool toFile);

  struct Parts;
  FrameOptions options_;
  std::unique_ptr<Parts> parts_;
  bool begun_ = false;
  std::uint64_t firstFrame_ = 0, videoFrames_ = 0, files_ = 0;   // of the video, on from the start of the session; PNG files written
  std::size_t nextTime_ = 0, tooEarly_ = 0;
  std::string lastFile_;
  Banner banner_;
};

}  // namespace halsted::app
