/// Throws of an instrument tie: the tail is drawn through the loop, then both ends are drawn apart.
#include <cmath>

#include "scenes/tie_phases.h"
#include "scenes/tie_places.h"
#include "sim/portable_math.h"
#include "sim/strand/strand.h"
#include "sim/suture/knot_place.h"
#include "sim/suture/tied_loop.h"

namespace halsted::scenes {
namespace {

constexpr double kTaut = 0.5;                  // [N] at which a tail on its way up is drawn no farther
constexpr double kTailShare = 0.85, kTaken = 1.1;   // [1] of its length: how far from the tissue the tail is drawn up through the loop; over throws that hold, until it is taut
constexpr double kGentle = 0.15;               // [N]
constexpr double kAside = 10e-3, kLow = 6e-3, kLower = 3e-3;  // [m] from the stitch as the ends begin to be drawn; above it; over throws that lie, which must not be lifted
constexpr double kOff = 0.1;                   // [N] felt when there is nothing more to come
constexpr double kClings = 3.0;                // [s] after which it is wound again: it has come to lie between the jaws
constexpr double kOver = 18e-3, kBeyond = 12e-3;   // [m] of the other hand above the stitch and past the tips meanwhile
constexpr double kDraw = 0.03, kDrawTaut = 5e-3;   // [m/s] of slack thread; of thread that it feels
constexpr double kHoldTail = 0.15;             // [1] of that for the tail: it is to stay short
constexpr double kReach = 0.09;                // [m] as far as an arm draws
constexpr double kBehind = 10e-3;              // [m] that a hand lags where its device stops
constexpr double kLeans = 8.0;                 // [N] on a hand, twice what any end is drawn with: it leans on something
constexpr double kFeel = 0.5;                  // [N]
constexpr double kLaySide = 0.5, kLayUp = 0.2; // [1] of the way toward the surgeon
constexpr double kLaySlack = 0.95;             // [1] of the tail's straight length: as far from the stitch as it was drawn, it would still draw
constexpr double kHangs = 2e-3;                // [m] of slack
constexpr double kHoldTight = 0.3;             // [s]
constexpr double kEased = 0.05, kEase = 0.1;   // [N] at the other hand as the tail is laid; [m/s]
constexpr double kPatience = 12.0;             // [s] then it is as tight as it gets: over tissue that gives, two hands that feel each other see-saw

std::optional<TiedLoop> loopOf(const Scene& s) {
  const std::optional<KnotPlace> place = placeOfKnot(s.model, s.state);
  return place ? std::optional<TiedLoop>({place->tail, place->tip}) : std::nullopt;
}

/// Is there a throw below that nothing locks yet, and that a pull on one end alone draws apart?
bool loosensThrow(const Scene& s) { return s.memory.knot.current > 0 && locks(s.state.knot) == 0; }

/// Which way the tail is drawn, and the long end against it: across the wound, turned toward the surgeon as the script says.  [1]
Vec3 drawWay(const Scene& s) {
  const double turned = s.action.drawDegrees * kPi / 180.0;   // [rad]
  return cosine(turned) * s.memory.knot.side + sine(turned) * s.memory.knot.handle;
}

/// A long end's hand whose device has come to its stop aslant turns there and goes on straight across, or the tail, drawn in its place, would come
/// through both walls; false where it goes straight already.
bool goesStraight(const Scene& s) {
  KnotPlan& k = s.memory.knot;
  if (k.longWay == Vec3(-k.side)) return false;
  s.memory.goal[kLeft].position = s.state.tools[kLeft].proxy.position;
  k.longWay = -k.side;
  k.drawn[kLeft] = 0.0;
  return true;
}

/// With what a loop that clings is drawn off.  [N]
double firm(const Scene& s) { return loosensThrow(s) ? kGentle : kFirm; }

/// Looks where the tail, that the driver has, leaves the throws that lie.
void seeTail(const Scene& s) {
  const std::optional<KnotPlace> place = s.memory.knot.current > 0 ? placeOfKnot(s.model, s.state) : std::nullopt;
  s.memory.knot.tailOut = place ? place->tailOut : tailHole(s).coordinate;
}

/// From where the tail leaves the throws that lie, as far as it goes without being drawn straight: farther, throws that nothing locks would slide up along it.
struct TailReach { Vec3 from; double length; };   // [m]
TailReach tailReach(const Scene& s) {
  const KnotPlan& k = s.memory.knot;
  const double share = k.current > 0 && !k.loose ? kTaken : kTailShare;   // [1]
  return {strandPoint(s.model.strand, s.state.strand, k.tailOut), share * std::fmax(0.0, k.tailOut - s.state.tools[kRight].threadCoordinate)};
}

/// A place for the tail, or as near to it as the tail reaches: no lower, where it is to be kept off the wall.  [m]
Vec3 withinTail(const Scene& s, const Vec3& place) {
  if (s.memory.knot.current == 0) return place;
  const TailReach tail = tailReach(s);
  const Vec3 way = place - tail.from, up = way.dot(s.memory.knot.up) * s.memory.knot.up, level = way - up;   // [m]
  const double most = std::sqrt(std::fmax(0.0, tail.length * tail.length - up.squaredNorm())), far = level.norm();   // [m]
  return far > most ? Vec3(tail.from + up + most / far * level) : place;
}

/// The other hand draws the loop off the driver's tips, on to the tail: until it is off and there is nothing more to come.
void drawOffTips(const Scene& s) {
  KnotPlan& k = s.memory.knot;
  const double pull = s.state.tools[kLeft].threadForce.norm();   // [N]
  feel(k.felt[kLeft], pull, s.dt, kFeelTime);
  k.settled = k.felt[kLeft] > kOff ? k.settled + s.dt : 0.0;
  if (pull < firm(s)) {
    k.drawn[kLeft] += kCareful * s.dt;
    const Vec3 from = stitch(s) + kOver * k.up - kBeyond * k.handle, offTips = (k.up - k.handle).normalized();   // [m], [1]
    moveHand(s, kLeft, keepTurn(s, kLeft, from + k.drawn[kLeft] * offTips), 2.0 * kCareful);
  }
  const bool on = loopOnJaws(s);
  if (on && k.settled > kClings && ++k.misses <= kAttempts) goTo(s, kUnwind);
  else if ((k.felt[kLeft] > kOff && (!on || k.settled > kClings)) || k.drawn[kLeft] > kReach) goTo(s, kCross);
}

}  // namespace

/// The tail comes through the loop, then the hands go to their sides.
void drawThrough(const Scene& s) {
  ExpertState& e = s.memory;
  KnotPlan& k = e.knot;
  const Vec3 p = stitch(s);
  if (e.phase == kThrough) {
    if (s.inPhase < 1.5 * s.dt) {
      seeTail(s);
      const TailReach tail = tailReach(s);
      e.goal[kRight] = keepTurn(s, kRight, tail.from + tail.length * (k.handle + k.up).normalized());
    }
    const double half = 0.5 * (s.state.tools[kRight].threadCoordinate + tailHole(s).coordinate);   // [m]
    feel(k.felt[kRight], strandTension(s.model.strand, s.state.strand, half, 1), s.dt, kFeelTime);   // the jaws feel the wall, too, on which the tail lay
    const bool taut = k.felt[kRight] > kTaut || s.state.tools[kLeft].threadForce.norm() > firm(s);
    const bool drawn = taut || moveHand(s, kRight, e.goal[kRight], kCareful);
    if (!drawn) { moveHand(s, kLeft, keepTurn(s, kLeft, p + kOver * k.up - kBeyond * k.handle), kCareful); return; }
    drawOffTips(s);
  } else {
    k.longWay = -drawWay(s);
    const double low = s.state.cut ? std::fmax(kLow, k.floor) : k.current > 0 ? kLower : kLow;   // [m] drawn along the wall, as ends that are drawn up lift the throw; but over cut edges
    const bool right = moveHand(s, kRight, keepTurn(s, kRight, withinTail(s, p + kAside * drawWay(s) + low * k.up)), kCareful);
    const bool left = moveHand(s, kLeft, keepTurn(s, kLeft, p + 2.0 * kAside * k.longWay + low * k.up), kMove);
    if (!right || !left) return;
    for (int h = 0; h < kHands; ++h) e.goal[h] = e.hand[h].command;
    k.drawn = k.felt = {};
    k.settled = 0.0;
    goTo(s, kDrawTight);
  }
}

/// Each hand draws its end until it feels the tension; true once both have held it for a moment. The tail is to stay short and comes
/// slowly, unless the other hand's device has come to its stop; and not before that hand has taken up its slack, or the tail alone would draw the
/// throw below apart.
bool drawTight(const Scene& s) {
  ExpertState& e = s.memory;
  KnotPlan& k = e.knot;
  bool tight = true, stopped = false;          // the left hand's, as it comes first
  for (int h = 0; h < kHands; ++h) {
    feel(k.felt[h], s.state.tools[h].threadForce.norm(), s.dt, kFeelTime);
    const double lack = (s.action.tension - k.felt[h]) / kFeel;   // [1]
    const bool ready = !loosensThrow(s) || stopped || k.felt[kLeft] > kOff || k.drawn[kLeft] >= kReach;
    const double most = h == kLeft || stopped ? 1.0 : ready ? kHoldTail : 0.0;   // [1]
    const double pace = std::fmax(-1.0, std::fmin(most, lack));  // [1]
    stopped = (e.hand[h].command.position - s.state.tools[h].proxy.position).norm() > kBehind || s.state.tools[h].force.norm() > kLeans;
    stopped = stopped && !(h == kLeft && goesStraight(s));
    const double by = pace * (k.felt[h] > kOff ? kDrawTaut : kDraw) * s.dt;   // [m]
    if (!stopped || by < 0.0) k.drawn[h] = std::fmin(kReach, std::fmax(0.0, k.drawn[h] + by));
    tight = tight && (lack < 0.2 || stopped || k.drawn[h] >= kReach);
    const Vec3 way = h == kLeft ? k.longWay : drawWay(s);   // [1]
    moveHand(s, h, {e.goal[h].position + k.drawn[h] * way, e.goal[h].orientation}, 0.1);
  }
  k.settled = tight ? k.settled + s.dt : 0.0;
  if (k.settled <= kHoldTight && s.inPhase <= kPatience) return false;
  const std::optional<TiedLoop> loop = loopOf(s);
  k.beyond = loop ? threadBeyondWay(s.model, s.state, *loop) : 0.0;
  return true;
}

/// Measured against the loop as it was drawn: over an edge its way is longer than that from hole to hole.
double hangsBy(const Scene& s) {
  if (locks(s.state.knot) > 0) return 0.0;
  const std::optional<TiedLoop> loop = loopOf(s);
  if (!loop || isTaut(s.model, s.state, *loop)) return 0.0;
  const double beyond = threadBeyondWay(s.model, s.state, *loop);   // [m]
  return beyond > std::fmax(0.0, s.memory.knot.beyond) + kHangs ? beyond : 0.0;
}

bool wallsCameApart(const Scene& s) {
  return locks(s.state.knot) == 0 && s.action.gap > 0.0 && s.state.metrics.seam && s.state.metrics.seam->join.wallGap > s.action.gap;
}

void drawAgain(const Scene& s) {
  if (!pickUp(s, kRight, tailGrip(s), kAgain)) return;
  seeTail(s);
  goTo(s, holdsTail(s) ? kCross : kLetTail);
}

/// The tail is laid toward the surgeon, away from the thread between the knot and the holes, or the jaws would take that for it. The other
/// hand eases off with it: a pull that nothing answers any more would draw the throw along the tail, off the stitch. Of a throw that did not
/// come, it goes back to where it was, opposite to the long end.
bool layTail(const Scene& s) {
  ExpertState& e = s.memory;
  KnotPlan& k = e.knot;
  const Vec3 from = stitch(s);
  feel(k.felt[kLeft], std::fmax(0.0, -s.state.tools[kLeft].threadForce.dot(k.longWay)), s.dt, kFeelTime);   // what pushes it back is no pull
  if (k.felt[kLeft] > kEased) k.drawn[kLeft] -= kEase * s.dt;
  moveHand(s, kLeft, {e.goal[kLeft].position + k.drawn[kLeft] * k.longWay, e.goal[kLeft].orientation}, kEase);
  if (s.inPhase < 1.5 * s.dt) {
    const double far = (e.hand[kRight].command.position - from).norm();   // [m]
    const double aside = noThrowCame(k) ? -kLaySide : kLaySide;   // [1]
    e.goal[kRight] = keepTurn(s, kRight, from + kLaySlack * far * (aside * e.knot.side + e.knot.handle + kLayUp * e.knot.up).normalized());
  }
  return moveHand(s, kRight, e.goal[kRight], kCareful);
}

}  // namespace halsted::scenes
