#include "app/frame_writer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/errors.h"
#include "app/render_scene.h"
#include "app/run_summary.h"
#include "render/png.h"
#include "render/renderer.h"
#include "render/video.h"

namespace fs = std::filesystem;

namespace halsted::app {

struct FrameWriter::Parts {
  RenderScene scene;
  render::Renderer renderer;
  RenderSnapshot snapshot;
  std::unique_ptr<render::VideoWriter> video;

  Parts(const Scenario& scenario, int width, int height) : scene(renderScene(scenario)), renderer(scene, width, height) {
    prepareSnapshot(scenario.model, snapshot);
  }
};

FrameWriter::FrameWriter(const FrameOptions& options, const Scenario& scenario) : options_(options) {
  std::sort(options_.times.begin(), options_.times.end());
  constexpr double kSlowest = 1.0, kFastest = 240.0;             // [Hz] what players show
  if (!options_.video.empty() && !(options_.fps >= kSlowest && options_.fps <= kFastest))
    throw scenes::InputError("--fps: a video needs 1 to 240 frames per second");
  if (!options_.video.empty() && (options_.width % 2 != 0 || options_.height % 2 != 0))
    throw scenes::InputError("--size: a video needs an even width and height");
  std::error_code error;
  if (!options_.folder.empty()) fs::create_directories(options_.folder, error);
  if (error) throw SystemFault(options_.folder + ": cannot make the folder: " + error.message());
  try {
    parts_ = std::make_unique<Parts>(scenario, options_.width, options_.height);
    if (!options_.video.empty())
      parts_->video = std::make_unique<render::VideoWriter>(options_.video, render::VideoFormat{options_.width, options_.height, options_.fps});
  } catch (const std::exception& reason) {
    throw SystemFault(std::string("rendering: ") + reason.what());
  }
}

FrameWriter::~FrameWriter() = default;

bool FrameWriter::see(const Lockstep& run) {
  const StepOutput& output = run.output();
  for (int i = 0; i < output.eventCount; ++i) banner_.tell(output.events[i], run.scenario().model, run.time());
  const double late = run.time() + 1e-9;       // [s]
  if (!begun_) beginAt(run.time());
  const bool frameDue = late >= static_cast<double>(videoFrames_) / options_.fps;
  const bool timeDue = nextTime_ < options_.times.size() && late >= options_.times[nextTime_];
  const bool toVideo = frameDue && parts_->video, everyFrame = frameDue && options_.times.empty();
  const bool toFile = !options_.folder.empty() && (timeDue || everyFrame);
  if (frameDue) ++videoFrames_;
  while (nextTime_ < options_.times.size() && late >= options_.times[nextTime_]) ++nextTime_;
  if (toVideo || toFile) drawFrame(run, toVideo, toFile);
  return parts_->video || options_.times.empty() || nextTime_ < options_.times.size();
}

void FrameWriter::beginAt(double time) {
  begun_ = true;
  firstFrame_ = videoFrames_ = static_cast<std::uint64_t>(std::ceil(time * options_.fps - 1e-9));
  while (nextTime_ < options_.times.size() && options_.times[nextTime_] < time - 1e-9) ++nextTime_, ++tooEarly_;
}

void FrameWriter::drawFrame(const Lockstep& run, bool toVideo, bool toFile) {
  fillSnapshot(run.scenario().model, run.state(), parts_->snapshot);
  render::HudInput hud;
  hud.message = banner_.at(run.time());
  for (int hand = 0; hand < kHands; ++hand) hud.haptic.force[hand] = run.hands()[hand].output.force;
  try {
    const render::Frame& frame = parts_->renderer.draw(parts_->snapshot, hud, parts_->scene.camera);
    if (toVideo) parts_->video->add(frame);
    if (!toFile) return;
    lastFile_ = (fs::path(options_.folder) / number("frame_%08.3f.png", run.time())).string();
    render::writePng(lastFile_, frame);
    ++files_;
  } catch (const std::exception& reason) {
    throw SystemFault(reason.what());
  }
}

std::string FrameWriter::finish() {
  std::string text;
  if (parts_->video) {
    try {
      parts_->video->finish();
    } catch (const std::exception& reason) {
      throw SystemFault(reason.what());
    }
    text += "  video " + options_.video + ": " + std::to_string(videoFrames_ - firstFrame_) + " frames at " + number("%g Hz", options_.fps) + "\n";
  }
  if (!options_.folder.empty()) text += "  " + std::to_string(files_) + " PNG frames in " + options_.folder + (files_ ? ", last " + lastFile_ : "") + "\n";
  if (tooEarly_ > 0) text += "  " + std::to_string(tooEarly_) + " of the times lie before the run begins\n";
  if (nextTime_ < options_.times.size())
    text += "  " + std::to_string(options_.times.size() - nextTime_) + " of the times lie after the end of the run\n";
  return text;
}

}  // namespace halsted::app
