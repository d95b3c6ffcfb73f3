/// What the assistant is asked for: both hands let go and go aside, and are handed a new thread or their other instruments.
#include "scenes/expert_state.h"
#include "sim/tools/instrument.h"

namespace halsted::scenes {
namespace {

constexpr double kRise = 0.02, kAway = 0.15;   // [m] over the wound first; [m/s]
constexpr double kAnswer = 0.2;                // [s] in which the assistant hands it or says why not

enum Phase { kOpen, kUp, kAside, kAsk, kWait };

bool bothAt(const Scene& s, const std::array<Pose, kHands>& goal) {
  bool there = true;
  for (int h = 0; h < kHands; ++h) there = moveHand(s, h, goal[h], kAway) && there;
  return there;
}

/// Both hands open and go aside, clear of the wound; true once the phase is kAsk.
bool goneAside(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase >= kAsk) return true;
  if (e.phase == kOpen) {
    for (int h = 0; h < kHands; ++h) {
      e.hand[h].jaw = s.state.tools[h].ratchet ? 0.0 : 1.0;      // a squeeze opens the ratchet
      e.goal[h] = above(e.hand[h].command, kRise);
    }
    if (s.inPhase > 0.3) nextPhase(s);
  } else if (e.phase == kUp) {
    if (!bothAt(s, e.goal)) return false;
    e.goal = {parked(kLeft), parked(kRight)};
    nextPhase(s);
  } else if (e.phase == kAside) {
    if (bothAt(s, e.goal) && s.inPhase > 0.3) nextPhase(s);
  }
  return false;
}

bool hasSecond(const Scene& s, int hand) { return s.model.params.second[hand].kind != ToolKind::kNone; }

}  // namespace

bool runFreshThread(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (!s.state.supply) { failure = "this scene has no other thread: thread.spare"; return false; }
  if (!goneAside(s)) return false;
  if (e.phase == kAsk) {
    e.handedBefore = s.state.supply->handed;
    e.spoken.kind = Command::Kind::kFreshThread;
    nextPhase(s);
  } else {
    if (s.state.supply->handed > e.handedBefore) { e.hand[kRight].jaw = 0.0; return s.inPhase > kAnswer; }
    if (s.inPhase > kAnswer) failure = name(static_cast<ThreadRefusal>(s.state.supply->refusal));
  }
  return false;
}

bool runChangeTools(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (!s.state.instruments) { failure = "this scene has no other instruments: tool.left.second, tool.right.second"; return false; }
  if (!goneAside(s)) return false;
  const int hand = (e.phase - kAsk) / 2;       // asks and waits for the left, then for the right one
  if (hand >= kHands) return true;
  if (!hasSecond(s, hand)) {
    e.phase += 1;
    nextPhase(s);
  } else if ((e.phase - kAsk) % 2 == 0) {
    e.secondBefore = s.state.instruments->second[hand];
    e.spoken = {Command::Kind::kChangeInstrument, static_cast<double>(hand)};
    nextPhase(s);
  } else if (s.state.instruments->second[hand] != e.secondBefore) {
    nextPhase(s);
  } else if (s.inPhase > kAnswer) {
    failure = name(static_cast<InstrumentRefusal>(s.state.instruments->refusal));
  }
  return false;
}

}  // namespace halsted::scenes
