#pragma once
/// Draws the newest snapshot at the wanted rate and hands the frame to the window. Runs at low priority: forces come first.
#include <string>

#include "app/threads/links.h"
#include "app/timing.h"
#include "sim/model.h"

namespace halsted::app {

struct RenderOptions {
  int width = 1280, height = 720;              // pixels
  double fps = 60.0;                           // [Hz] at most
  bool toWindow = false;                       // publish frames
};

struct RenderOutcome {
  std::uint64_t frames = 0;
  double startSeconds = 0.0;                   // [s] until the first frame was there: textures, shaders, that frame itself
  double seconds = 0.0;                        // [s] from the first frame, which `frames` does not count, to the end
  Durations frameTimes{50e-6, 20'000};
  Durations frameCpu{50e-6, 20'000};          // of this thread alone; all of it when the graphics library starts no threads
  std::string failure;                         // no OpenGL, ...; empty: none
};

/// Runs until `links.stop`. Render thread. Of the model it reads what no step changes.
void runRender(const RenderScene&, const RenderOptions&, const Model&, Links&, RenderOutcome&) noexcept;

}  // namespace halsted::app
