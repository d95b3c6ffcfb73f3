/// The instrument tie. The driver lies over the stitch, along the wound. The left hand holds the long end and winds it round the driver's
/// closed jaws, on the side of their tips: there it passes between driver and tissue, through the loop that the thread itself makes with
/// the tissue. (Wound about a driver that stands upright, thread only twists like a rubber band, and comes undone.) The driver opens,
/// takes the short tail, closes and draws it back through the loop; both ends are drawn apart, the long end toward the tail's side. The
/// next throw is wound from there, the other way round for a square knot, so that the hands change sides with every throw.
#include <algorithm>

#include "scenes/stitch_frame.h"
#include "scenes/tie_phases.h"
#include "scenes/tie_places.h"
#include "sim/suture/knot_watch.h"

namespace halsted::scenes {
namespace {

constexpr int kMostAdded = 2;                  // throws
constexpr int kMostRedrawn = 4;                // times that a throw is drawn, or the tail taken for it
constexpr double kGain = 0.5e-3;               // [m]

bool begin(const Scene& s, std::string& failure) {
  KnotPlan& k = s.memory.knot;
  if (s.state.strand.holeCount < 2) { failure = "there is no stitch in the tissue"; return false; }
  k = KnotPlan{};
  k.throws = parseThrows(s.action.tie);
  const StitchFrame f = stitchFrame(s);
  k.side = f.side;
  k.up = f.up;
  k.handle = f.front;
  k.floor = overTissue(s);
  for (int h = 0; h < kHands; ++h) s.memory.goal[h] = above(s.memory.hand[h].command, 0.02);
  goTo(s, driverHoldsLong(s) ? kLiftIt : s.state.tools[kRight].closed ? kFreeDriver : kFreeLong);
  return true;
}

/// A knot in which nothing locks, as far as can be seen, gets another throw. Throws of one sense are not meant to lock.
bool wantsAnother(const Scene& s) {
  KnotPlan& k = s.memory.knot;
  const bool meant = s.action.tie.find('=') != std::string::npos;
  if (!meant || locks(s.state.knot) > 0 || k.added == kMostAdded) return false;
  ++k.added;
  k.throws.push_back({1, k.throws.back().over});
  return true;
}

/// A loop that hangs is drawn once more, and again while that gains something: a single throw let go opens as far as its thread springs.
bool wantsDrawing(const Scene& s) {
  KnotPlan& k = s.memory.knot;
  const double hangs = hangsBy(s), before = k.hung;   // [m]
  if (hangs > 0.0) k.hung = hangs;             // drawn again for its walls, it may hang the next time
  return wallsCameApart(s) || (hangs > 0.0 && hangs < before - kGain);
}

bool readInFull(const KnotState& seen) { return seen.watched && seen.complete && seen.crossingsLeft == 0; }

/// What comes undone while this throw is wound did not lie before it.
void seeUndone(const Scene& s) {
  const KnotState& seen = s.state.knot;
  if (!readInFull(seen)) return;
  s.memory.knot.throwsBefore = std::min(s.memory.knot.throwsBefore, seen.throws);
  s.memory.knot.turnsBefore = std::min(s.memory.knot.turnsBefore, turns(seen));
}

/// Looks at the throw that is drawn, as long as it takes to let go of it: thread that lies over a knot hides it at times. What was seen before
/// it was drawn does not count.
void lookAtThrow(const Scene& s) {
  if (s.memory.phase == kDrawTight && s.inPhase < kKnotInterval) return;
  KnotPlan& k = s.memory.knot;
  const KnotState& seen = s.state.knot;
  if (!readInFull(seen)) return;
  ++(seen.throws > k.throwsBefore || turns(seen) > k.turnsBefore ? k.stepsMore : k.stepsSame);
}

/// A throw that did not come is wound once more, from the side where it was begun. One that wants it is drawn again; else the next one
/// follows: the long end is now on the other side of the stitch.
void nextThrow(const Scene& s, std::string& failure) {
  if (!letTailGo(s)) return;
  KnotPlan& k = s.memory.knot;
  if (noThrowCame(k)) {
    if (++k.misses > kAttempts) failure = "no throw comes of the loop";
    goTo(s, kLiftLong);
    return;
  }
  if (wantsDrawing(s)) {
    if (++k.redrawn > kMostRedrawn) failure = "the throw does not stay on the wall";
    goTo(s, kAgain);
    return;
  }
  ++k.current;
  k.hung = KnotPlan{}.hung;
  k.misses = k.beside = 0;
  k.side = -k.side;
  goTo(s, kLiftLong);
}

}  // namespace

/// The driver goes back along its shaft; true once it is there.
bool rise(const Scene& s) {
  ExpertState& e = s.memory;
  if (s.inPhase < 1.5 * s.dt) e.goal[kRight] = above(e.hand[kRight].command, 0.02);
  return s.inPhase > 0.3 && moveHand(s, kRight, e.goal[kRight], kMove);
}

/// The driver lets the tail go and rises.
bool letTailGo(const Scene& s) {
  s.memory.hand[kRight].jaw = 1.0;
  return rise(s);
}

/// The driver goes for the tail; true where that is not to be had and the knot locks already: it is one, with a throw less than was meant.
bool fetchOrLeave(const Scene& s, std::string& failure) {
  fetchTail(s, failure);
  if (failure.empty() || locks(s.state.knot) == 0) return false;
  failure.clear();
  return true;
}

bool runTie(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase != kLook && s.state.strand.holeCount < 2) { failure = "the thread has left the tissue"; return false; }
  if (e.phase > kLiftLong && e.phase < kCross) seeUndone(s);
  if (e.phase >= kDrawTight && e.phase <= kLetTail) lookAtThrow(s);
  if (e.phase == kLook) begin(s, failure);
  else if (e.phase < kLiftIt) takeNearer(s);
  else if (e.phase < kFreeDriver) handOver(s);
  else if (e.phase <= kTakeLongClose) takeLongEnd(s, failure);
  else if (e.phase == kShorten) shortenTail(s);
  else if (e.phase <= kWind) wind(s);
  else if (e.phase <= kClose) return fetchOrLeave(s, failure);
  else if (e.phase == kUnwind) { if (unwind(s)) goTo(s, kLiftLong); }
  else if (e.phase <= kCross) drawThrough(s);
  else if (e.phase == kLayTail) { if (layTail(s)) goTo(s, kLetTail); }
  else if (e.phase == kLetTail) nextThrow(s, failure);
  else if (e.phase >= kAgain) drawAgain(s);
  else if (drawTight(s)) {
    const bool last = e.knot.current + 1 == e.knot.throws.size();
    if (last && !noThrowCame(e.knot) && !wantsAnother(s)) return true;
    goTo(s, kLayTail);
  }
  return false;
}

bool runLetGo(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase == 0) {
    for (int h = 0; h < kHands; ++h) e.goal[h] = above(e.hand[h].command, 0.02);
    nextPhase(s);
  }
  bool up = s.inPhase > 0.3;
  for (int h = 0; h < kHands; ++h) {
    e.hand[h].jaw = 1.0;
    if (s.inPhase > 0.3) up = moveHand(s, h, e.goal[h], kMove) && up;
  }
  return up;
}

}  // namespace halsted::scenes
