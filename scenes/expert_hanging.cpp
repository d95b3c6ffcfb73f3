/// From hand to hand: thread that the driver's jaws hold.
#include <cmath>

#include "scenes/expert_state.h"

namespace halsted::scenes {
namespace {

constexpr double kByTheNeedle = 24e-3;         // [m] no nearer to it
constexpr double kCloser = 0.75, kClosest = 8e-3;   // [1] of the way to the driver after a miss; no nearer to its jaws [m]
constexpr double kSamePlace = 15e-3;           // [m] along the thread; what else the jaws have taken they let go
constexpr double kUp = 0.02, kSpeed = 0.08;    // [m] the hand rises when it has let go, [m/s]
constexpr double kLetGo = 0.3;                 // [s]

/// Where to take it, as far from the driver: beyond it; where it holds the thread close to the needle, between stitch and driver.  [m]
double hangingPlace(const Scene& s, double far) {   // [m]
  const double driver = s.state.tools[kRight].threadCoordinate, room = s.model.strand.length - kByTheNeedle - driver;   // [m]
  return driver + (room > kClosest ? std::fmin(far, room) : -far);
}

}  // namespace

bool takeHanging(const Scene& s, int first) {
  ExpertState& e = s.memory;
  if (e.phase == first) {
    if (s.inPhase < 1.5 * s.dt) e.goal[kLeft] = above(e.hand[kLeft].command, kUp);
    e.hand[kLeft].jaw = 1.0;
    e.place = hangingPlace(s, kHanging);
    if (s.inPhase > kLetGo && moveHand(s, kLeft, e.goal[kLeft], kSpeed)) nextPhase(s);
    return false;
  }
  if (!pickUp(s, kLeft, threadGrip(s, kLeft, e.place), first + 1)) return false;
  const double held = s.state.tools[kLeft].threadCoordinate;   // [m]
  if (held >= 0.0 && std::fabs(held - e.place) < kSamePlace) return true;
  const double driver = s.state.tools[kRight].threadCoordinate;   // [m]
  if (driver >= 0.0) e.place = hangingPlace(s, std::fmax(kClosest, kCloser * std::fabs(e.place - driver)));
  e.hand[kLeft].jaw = 1.0;                     // missed: once more, where thread is steadier
  goTo(s, first + 1);
  return false;
}

}  // namespace halsted::scenes
