#include "app/threads/render_thread.h"

#include <exception>

#include "app/resources.h"
#include "app/threads/realtime.h"
#include "render/renderer.h"

namespace halsted::app {
namespace {

const char* const kHelp = "mouse: move  wheel: nearer, farther  right drag: turn  left button or space: close the jaws  C: cut open  N: new thread  T: other instruments  Esc: end";
constexpr double kMessageTime = 3.0;           // [s] an event stays on screen

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

void readEvents(Links& links, double dt, std::string& message, Nanoseconds& until) {   // [s]
  Event event;
  while (links.shownEvents.pop(event)) {
    char text[160];
    std::snprintf(text, sizeof text, "%.1f s: %s%s%s", static_cast<double>(event.step) * dt, name(event.kind),
                  event.kind == EventKind::kThreadRefused ? ": " : "",
                  event.kind == EventKind::kThreadRefused ? name(static_cast<ThreadRefusal>(event.index)) : "");
    message = text;
    until = monotonicNow() + static_cast<Nanoseconds>(kMessageTime * 1e9);
  }
  if (monotonicNow() > until) message.clear();
}

/// What the panels show, gathered before each frame.
struct Panel {
  render::HudInput hud;
  RateMeter rates;
  Nanoseconds messageUntil = 0;

  void update(Links& links, double dt) {       // [s]
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
    readEvents(links, dt, hud.message, messageUntil);
    hud.otherView = links.otherView.load();
    if (links.helpVisible.load()) hud.message = kHelp;
  }
};

/// A renderer, the panels over the picture, and where the picture goes.
class Painter {
 public:
  Painter(const RenderScene& scene, const RenderOptions& options, double dt, Links& links)   // [s]
      : renderer_(scene, options.width, options.height), camera_(scene.camera), toWindow_(options.toWindow), dt_(dt), links_(links) {}

  void draw() {
    links_.snapshot.acquire();
    panel_.update(links_, dt_);
    const render::Frame& frame = renderer_.draw(links_.snapshot.front(), panel_.hud, camera_);
    if (!toWindow_) return;
    links_.frame.back() = frame;
    links_.frame.publish();
  }

 private:
  render::Renderer renderer_;
  CameraView camera_;
  bool toWindow_;
  double dt_;                                  // [s]
  Links& links_;
  Panel panel_;
};

double secondsSince(Nanoseconds start) { return static_cast<double>(monotonicNow() - start) * 1e-9; }

void drawFrames(const RenderScene& scene, const RenderOptions& options, double dt, Links& links, RenderOutcome& outcome) {   // [s]
  const Nanoseconds born = monotonicNow();
  Painter painter(scene, options, dt, links);
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

void runRender(const RenderScene& scene, const RenderOptions& options, double dt, Links& links, RenderOutcome& outcome) noexcept {   // [s]
  yieldToOthers();
  try {
    drawFrames(scene, options, dt, links, outcome);
  } catch (const std::exception& error) {
    outcome.failure = error.what();
    links.stop.store(true);
  }
}

}  // namespace halsted::app
