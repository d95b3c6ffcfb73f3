/// Between two stitches: both hands let go and go aside, and the assistant is asked for a new thread.
#include "scenes/expert_state.h"

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

}  // namespace

bool runFreshThread(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (!s.state.supply) { failure = "this scene has no other thread: thread.spare"; return false; }
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
  } else if (e.phase == kAsk) {
    e.handedBefore = s.state.supply->handed;
    e.spoken.kind = Command::Kind::kFreshThread;
    nextPhase(s);
  } else {
    if (s.state.supply->handed > e.handedBefore) { e.hand[kRight].jaw = 0.0; return s.inPhase > kAnswer; }
    if (s.inPhase > kAnswer) failure = name(static_cast<ThreadRefusal>(s.state.supply->refusal));
  }
  return false;
}

}  // namespace halsted::scenes
