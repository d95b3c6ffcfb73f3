#pragma once
/// A scenario in real time: starts the four threads, and ends them so that nothing is lost. Main thread.
///   device   transfers of a device behind a cable
///   haptic   1 kHz servo loop        physics  fixed dt            render  newest snapshot        recorder  log and session file
#include <memory>
#include <string>
#include <thread>

#include "app/scenario.h"
#include "app/threads/haptic_thread.h"
#include "app/threads/physics_thread.h"
#include "app/threads/recorder_thread.h"
#include "app/threads/render_thread.h"

namespace halsted::app {

struct LiveOptions {
  std::string record, trainee;                 // session file; empty: not recorded
  RenderOptions render;
  bool measureBareLoop = false;
};

struct LiveOutcome {
  HapticOutcome haptic;
  PhysicsOutcome physics;
  RenderOutcome render;
  RecorderOutcome recorder;
  Durations bareLateness;
  std::string fault;                           // what ended the session early: a device, the disk, the renderer; empty: nothing
};

class LiveSession {
 public:
  LiveSession(const Scenario&, const LiveOptions&);              // throws as Surgeons and SessionWriter; the scenario must outlive it
  ~LiveSession();                              // stops the threads if nobody did

  void start();
  bool running() const { return !links_.stop.load(); }
  bool scriptsEnded() const { return links_.scriptsEnded.load(); }
  /// Ends physics and haptics, then the picture, then writes what is left.
  const LiveOutcome& stop();

  Links& links() { return links_; }
  Hands& hands() { return hands_; }            // before `start` only
  const State& state() const { return state_; }   // before `start` and after `stop` only

 private:
  std::string faultText() const;

  const Scenario& scenario_;
  LiveOptions options_;
  Surgeons surgeons_;                          // before the writer: a script that does not fit must cost nobody a session
  RenderScene scene_;
  State state_;
  Hands hands_;
  Links links_;
  std::unique_ptr<SessionWriter> writer_;
  std::atomic<bool> finishRecording_{false};
  LiveOutcome outcome_;
  std::thread haptic_, physics_, render_, recorder_, bare_;
  std::array<std::thread, kHands> service_;    // one for each device behind a cable
};

}  // namespace halsted::app
