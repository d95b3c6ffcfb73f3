/// `halsted replay` and `halsted capture`: the same playback, the second one with pictures.
#include <cstdio>

#include "app/commands/commands.h"

namespace halsted::app {

int replay(const PlayOptions& options) { return play(options, nullptr); }

int capture(const PlayOptions& options, const FrameOptions& frames) {
  if (frames.folder.empty() && frames.video.empty()) throw scenes::InputError("capture: nothing to write; give --out DIR or --video FILE.mp4");
  std::unique_ptr<FrameWriter> writer;
  PlayOptions watched = options;
  watched.video = frames.video;
  const int code = play(watched, [&](const Scenario& scenario) -> Watcher {
    writer = std::make_unique<FrameWriter>(frames, scenario);
    return [&writer](const Lockstep& run) { return writer->see(run); };
  });
  const std::string written = writer->finish();
  std::fprintf(options.json ? stderr : stdout, "%s", written.c_str());
  return code;
}

}  // namespace halsted::app
