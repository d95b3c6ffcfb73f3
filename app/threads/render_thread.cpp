#include "app/threads/render_thread.h"

#include <exception>

#include "app/banner.h"
#include "app/resources.h"
#include "app/threads/realtime.h"
#include "render/renderer.h"

namespace halsted::app {
namespace {

const char* const kHelp = "mouse: move  wheel: nearer, farther  right drag: turn  left button, space: close the jaws  C: cut open  N: thread  T: instruments  H: hand a clamp over  Esc: end";

/// Rates over the last half second, for the panel.
struct RateMeter {
  Nanoseconds since = monotonicNow();
  std::uint64_t frames = 0, firstTick = 0, firstLate = 0;
  double framesPerSecond = 0.0, hapticRate = 0.0;   // [Hz]
  bool late = false;

  void frame(const HapticStatus& haptic, const PhysicsStatus& physics) {
    ++frames;
    const double seconds = static_cast<double>(monotonicNow() - since) * 1e-9;   // [s]
    if (seconds < 0.5) return;
    framesPerSecond = static_cast<double>(frames) / seconds;
    hapticRate = static_cast<double>(haptic.tick - firstTick) / seconds;
    late = static_cast<double>(physics.lateSteps - firstLate) > 0.01 * seconds * 1e3;
    *this = {monotonicNow(), 0, haptic.tick, physics.lateSteps, framesPerSecond, hapticRate, late};
  }
};

/// What the panels show, gathered before each frame.
struct Panel {
  render::HudInput hud;
  RateMeter rates;
  Banner banner;

  void update(Links& links, const Model& m) {
    links.hapticStatus.acquire();
    links.physicsStatus.acquire();
    hud.live = true;
    hud.stale = links.hapticStatus.front().status.staleTicks != hud.haptic.staleTicks;
    hud.haptic = links.hapticStatus.front().status;
    hud.hapticLateness = links.hapticStatus.front().worstLateness * 1e6;
    hud.physics = links.physicsStatus.front();
    rates.frame(hud.haptic, hud.physics);
    hud.framesPerSecond = rates.framesPerSecond;
    hud.hapticRate = rates.hapticRate;
    hud.late = rates.late;
    const double now = static_cast<double>(monotonicNow()) * 1e-9;   // [s]
    for (Event event; links.shownEvents.pop(event);) banner.tell(event, m, now);
    hud.message = banner.at(now);
    hud.otherView = links.otherView.load();
    if (links.helpVisible.load()) hud.message = kHelp;
  }
};

/// A renderer, the panels over the picture, and where the picture goes.
class Painter {
 public:
  Painter(const RenderScene& scene, const RenderOptions& options, const Model& model, Links& links)
      : renderer_(scene, options.width, options.height), camera_(scene.camera), toWindow_(options.toWindow), model_(model), links_(links) {}

  void draw() {
    links_.snapshot.acquire();
    panel_.update(links_, model_);
    const render::Frame& frame = renderer_.draw(links_.snapshot.front(), panel_.hud, camera_);
    if (!toWindow_) return;
    links_.frame.back() = frame;
    links_.frame.publish();
  }

 private:
  render::Renderer renderer_;
  CameraView camera_;
  bool toWindow_;
  const Model& model_;
  Links& links_;
  Panel panel_;
};

double secondsSince(Nanoseconds start) { return static_cast<double>(monotonicNow() - start) * 1e-9; }

void drawFrames(const RenderScene& scene, const RenderOptions& options, const Model& model, Links& links, RenderOutcome& outcome) {
  const Nanoseconds born = monotonicNow();
  Painter painter(scene, options, model, links);
  painter.draw();                              // compiles what the shaders left to the first use
  outcome.startSeconds = secondsSince(born);
  const auto period = static_cast<Nanoseconds>(1e9 / options.fps);
  const Nanoseconds start = monotonicNow();
  Nanoseconds next = start;
  while (!links.stop.load(std::memory_order_relaxed)) {
    next = std::max(next + period, monotonicNow());   // a slow frame delays the next one, frames are not made up for
    sleepUntil(next);
    const Nanoseconds begin = monotonicNow();
    const double cpu = threadCpuTime();        // [s]
    painter.draw();
    outcome.frameTimes.add(secondsSince(begin));
    outcome.frameCpu.add(threadCpuTime() - cpu);
    ++outcome.frames;
  }
  outcome.seconds = secondsSince(start);
}

}  // namespace

void runRender(const RenderScene& scene, const RenderOptions& options, const Model& model, Links& links, RenderOutcome& outcome) noexcept {
  yieldToOthers();
  try {
    drawFrames(scene, options, model, links, outcome);
  } catch (const std::exception& error) {
    outcome.failure = error.what();
    links.stop.store(true);
  }
}

}  // namespace halsted::app
