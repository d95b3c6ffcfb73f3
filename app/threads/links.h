#pragma once
/// Every carrier between the threads of a live session (DESIGN 2), owned by the main thread and shared by reference.
/// Beside each: who writes -> who reads. Nothing else is shared while the threads run.
#include <array>
#include <atomic>

#include "app/carriers/spsc_ring.h"
#include "app/carriers/triple_buffer.h"
#include "app/session/session_format.h"
#include "render/frame.h"
#include "sim/exchange.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted::app {

/// What physics consumed and what came of it; the session file is a list of these.
struct StepRecord {
  std::uint64_t step = 0;                      // index of the state before it
  StepInput input;
  std::uint64_t stateHash = 0;                 // after it
};

/// Something worth a line in the log, in codes; the recorder puts it into words.
enum class NoticeKind : std::uint8_t { kNoRealtimePriority, kMemoryNotLocked, kSkippedPeriods, kHandFault, kDeviceGone, kDevicePaused, kDeviceBack, kScriptEnded };
struct Notice {
  NoticeKind kind = NoticeKind::kSkippedPeriods;
  std::uint64_t when = 0;                      // tick or step of the thread that noticed
  std::int64_t value = 0;                      // periods, hand, fault bits, hand | problem << 8: by kind
};

/// For the panel: the status and how late the worst of the last hundred ticks was, which is about the 99th percentile.
struct HapticLevel {
  HapticStatus status;
  double worstLateness = 0.0;                  // [s]
};

struct Links {
  Links(const std::array<ToolSample, kHands>& atStart, const RenderSnapshot& sizedSnapshot, const render::Frame& sizedFrame,
        const State& sizedState)
      : samples(atStart), snapshot(sizedSnapshot), frame(sizedFrame), wholeState(sizedState) {}

  TripleBuffer<std::array<ToolSample, kHands>> samples;          // haptic -> physics
  TripleBuffer<std::array<LocalContact, kHands>> contacts;       // physics -> haptic
  TripleBuffer<std::array<HandTarget, kHands>> scriptTargets;    // physics -> haptic
  TripleBuffer<HandTarget> mouseTarget;                          // main -> haptic
  TripleBuffer<RenderSnapshot> snapshot;                         // physics -> render
  TripleBuffer<HapticLevel> hapticStatus;                        // haptic -> render
  TripleBuffer<PhysicsStatus> physicsStatus;                     // physics -> render
  TripleBuffer<render::Frame> frame;                             // render -> main
  TripleBuffer<State> wholeState;                                // physics -> recorder, every kStateInterval steps

  SpscRing<Command> commands{64};                                // main -> physics
  SpscRing<StepRecord> steps{8192};                              // physics -> recorder: 8 s of steps
  SpscRing<Event> events{4096};                                  // physics -> recorder
  SpscRing<Event> shownEvents{64};                               // physics -> render
  SpscRing<HapticRecord> hapticRecords{8192};                    // haptic -> recorder
  SpscRing<Notice> hapticNotices{256};                           // haptic -> recorder
  SpscRing<Notice> physicsNotices{256};                          // physics -> recorder

  std::atomic<bool> stop{false};                                 // any thread may ask all to end
  std::atomic<bool> helpVisible{false};                          // main -> render
  std::atomic<bool> otherView{false};                            // main -> render: whole body or cutaway, against what the scene says
  std::atomic<std::uint32_t> pausedHands{0};                     // haptic -> physics: one bit a hand whose device is away for a while
  std::atomic<int> goneHand{-1};                                 // haptic -> main: the device that vanished
  std::atomic<bool> scriptsEnded{false};                         // physics -> main
};

}  // namespace halsted::app
