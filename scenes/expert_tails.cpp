#include <cmath>

#include "scenes/expert_state.h"
#include "sim/contact/surface.h"
#include "sim/strand/strand.h"
#include "sim/suture/knotting.h"
#include "sim/suture/tied_loop.h"
#include "sim/tools/instrument.h"

namespace halsted::scenes {
namespace {

constexpr double kLeast = 0.015, kMost = 0.075, kStep = 3e-3;   // [m] of thread to choose from, between stitch and jaws
constexpr double kEnd = 4e-3;                  // [m] not by its very end
constexpr double kClear = 0.012;               // [m] of room: no better with more
constexpr double kNear = 0.25;                 // [1] room that one would give up to be nearer to the stitch
constexpr double kLowest = -0.06, kDeepest = -0.02;            // [m] y and z: lower or deeper is out of the hands' reach
constexpr double kNearer = 12e-3;              // [m] to the stitch after a miss
constexpr double kSamePlace = 0.015;           // [m] along the thread
constexpr int kTries = 8;                      // to take it alone: where thread lies in a heap, with what is beside it
constexpr double kTightenSpeed = 0.008;        // [m/s] twice as fast, thread that catches at its holes and slips tears them (patient)
constexpr double kTightenReach = 0.09;         // [m] as far as the arms go apart
constexpr double kMostGiven = 0.02;            // [m] a tail that was taken too tight is let back
constexpr double kFeel = 0.5;                  // [N] short of the tension at which a hand slows down
constexpr double kFeelTime = 0.2;              // [s] thread that catches and slips is felt as its mean
constexpr double kTight = 0.3;                 // [1] of the speed: nothing comes any more
constexpr double kHoldTight = 1.5;             // [s]
constexpr double kPatience = 10.0, kGains = 0.005;   // [s] [1] of the opening: in such a time no more is gained; two hands that feel each other through a stitch see-saw
constexpr double kSnug = 0.15, kClosed = 0.13; // [1] of the opening at rest: it lies on the anvil; no need to draw any more
constexpr double kWallsMeet = 2e-3;            // [m] of gap between two ends that looks as open as an opening at rest
constexpr double kDrawSpeed = 0.04, kDrawReach = 0.06;           // [m/s] [m] of one stroke
constexpr double kMostPull = 1.5;              // [N] at which a hand that feels draws no farther
constexpr double kUp = 0.02, kLetGo = 0.4, kRiseSpeed = 0.08;    // [m] [s] [m/s] of hands that let go and rise
constexpr double kLook = 2.0;                  // [s] with no hand on the thread, in which a procedure looks at a stitch that stays
constexpr double kStalls = 0.9;                // [1] of it: over cut edges, where it slows down as it pulls, it comes no farther
const Vec3 kDrawWay = Vec3(0.5, 0.6, 0.6).normalized();          // [1] of the driver: up, toward the surgeon, to its own side

/// Distance of a place on the thread from the wall and from the rest of the thread: jaws that close there take hold of nothing else.  [m]
double clearance(const Scene& s, double coordinate) {
  const Vec3 p = strandPoint(s.model.strand, s.state.strand, coordinate);
  const double wall = (p - s.state.tissue.position[nearestVertex(s.model.surface, {s.state.tissue.position, s.state.tissue.gone}, p)]).norm();   // [m]
  return std::fmin(kClear, std::fmin(wall, fromOtherThread(s, coordinate, kSamePlace)));
}

/// Where to take the thread that leaves the stitch at `stitch`, tail (`way` -1) or needle side (+1): clear, not far (or as far as the
/// action says; nearer after every miss, for there it may lie on the wall), not past where it is cut, and not where it was just
/// missed.  [m] [1]
double thinkOfPlace(const Scene& s, double stitch, double way) {
  const double wanted = s.action.tail > 0.0 ? s.action.tail : kLeast, end = threadEnd(s.model, s.state, stitch);   // [m]
  const double least = std::fmax(kLeast, wanted - kNearer * s.memory.attempt);                   // [m]
  double best = stitch + way * least, bestScore = -1.0;                                          // [m], [m]
  for (double off = least; off < std::fmax(kMost, wanted + kStep); off += kStep) {
    const double c = stitch + way * off;
    if (c < kEnd || c > end - kEnd) break;
    double score = clearance(s, c) - kNear * off;                                                // [m]
    const Vec3 at = strandPoint(s.model.strand, s.state.strand, c);
    if (at.y() < kLowest || at.z() < kDeepest) score -= kClear;
    if (s.memory.attempt > 0 && std::fabs(c - s.memory.place) < 2.0 * kStep) score -= kClear;
    if (score > bestScore) { bestScore = score; best = c; }
  }
  return best;
}

double tailPlace(const Scene& s) { return thinkOfPlace(s, s.state.strand.holes[0].coordinate, -1.0); }
double needlePlace(const Scene& s) { return thinkOfPlace(s, s.state.strand.holes[s.state.strand.holeCount - 1].coordinate, 1.0); }

/// A stay is held by each hand on its own side.
bool changedSides(const Scene& s) {
  const auto x = [&](double place) { return strandPoint(s.model.strand, s.state.strand, place).x(); };   // [m]
  return s.action.kind == "take_stay" && x(tailPlace(s)) > x(needlePlace(s));
}

/// Takes the thread at the place thought of; false while at it. What was not taken, or was another turn of the thread, is let go; `alone`, also
/// what has another turn beside it.
bool takeThread(const Scene& s, int hand, int first, double (*think)(const Scene&), bool alone) {
  ExpertState& e = s.memory;
  if (!pickUp(s, hand, threadGrip(s, hand, e.place), first)) return false;
  const double held = s.state.tools[hand].threadCoordinate;                                      // [m]
  const bool another = alone && e.attempt < kTries && pinchesAnother(s, hand, kSamePlace);
  if (held >= 0.0 && std::fabs(held - e.place) < kSamePlace && !another) return true;
  e.hand[hand].jaw = 1.0;
  ++e.attempt;
  e.place = think(s);
  goTo(s, first);
  return false;
}

/// How open it still is: the opening of one end, or the gap between the walls of two.  [1]
double opening(const State& s, const Model& m) {
  return m.join.present() ? s.metrics.seam->join.wallGap / kWallsMeet : s.metrics.openingArea / m.restOpening;
}

}  // namespace

double fromOtherThread(const Scene& s, double coordinate, double near) {   // [m]
  const Vec3 p = strandPoint(s.model.strand, s.state.strand, coordinate);
  double least = 1e300;                        // [m]
  for (int i = 0; i < s.model.strand.nodes; ++i) {
    if (std::fabs(s.model.strand.place[i] - coordinate) < near) continue;
    least = std::fmin(least, (p - s.state.strand.position[i]).norm());
  }
  return least;
}

bool pinchesAnother(const Scene& s, int hand, double near) {   // [m]
  if (!s.model.params.thread.knots) return false;   // thread that does not meet thread is not caught so
  const ToolState& t = s.state.tools[hand];
  const ToolParams& p = toolOf(s.model, s.state, hand);
  const auto& x = s.state.strand.position;
  for (int i = 1; i < s.model.strand.nodes; ++i) {
    const double place = 0.5 * (s.model.strand.place[i - 1] + s.model.strand.place[i]);          // [m]
    if (std::fabs(place - t.threadCoordinate) < near) continue;
    for (const Vec3& at : {x[i], Vec3(0.5 * (x[i - 1] + x[i]))}) {
      const Vec3 seen = t.proxy.inverseApply(at);                                                // [m]
      if (std::fabs(seen.x()) < p.jawRadius && std::fabs(seen.y()) < p.jawRadius && seen.z() > -p.jawRadius && seen.z() < p.jawLength) return true;
    }
  }
  return false;
}

Pose threadGrip(const Scene& s, int hand, double coordinate) {
  const Vec3 p = strandPoint(s.model.strand, s.state.strand, coordinate);
  Vec3 t = strandTangent(s.model.strand, s.state.strand, coordinate);
  t.z() = 0.0;
  const Vec3 now = s.memory.hand[hand].command.orientation * Vec3::UnitY();
  const Vec3 line = t.norm() > 0.1 ? Vec3(t.normalized()) : Vec3(Vec3::UnitY());
  const Vec3 along = line.dot(now) < 0.0 ? Vec3(-line) : line;
  Mat3 axes;
  axes << along.cross(Vec3::UnitZ()), along, Vec3::UnitZ();
  return {p, Quat(axes).normalized()};
}

/// Phase 0: looks; what is closed needs no other grip. 1 to 3: the right hand takes its tail. 4: the left lets the needle go. 5 to 7: it takes the other.
bool runTakeTails(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (s.state.strand.holeCount < 2) { failure = "there is no stitch in the tissue"; return false; }
  if (e.phase == 0) {
    const bool held = s.state.tools[kLeft].threadCoordinate >= 0.0 && s.state.tools[kRight].threadCoordinate >= 0.0;
    if (s.action.kind == "take_tails" && held && opening(s.state, s.model) < kSnug) return true;
    e.crossed = changedSides(s);
  }
  const auto rightPlace = e.crossed ? tailPlace : needlePlace, leftPlace = e.crossed ? needlePlace : tailPlace;
  if (e.phase == 0) {
    e.place = rightPlace(s);
    nextPhase(s);
  } else if (e.phase <= 3) {
    if (!takeThread(s, kRight, 1, rightPlace, true)) return false;
    e.goal[kLeft] = above(e.hand[kLeft].command, 0.02);
    e.attempt = 0;
    nextPhase(s);
  } else if (e.phase == 4) {
    e.hand[kLeft].jaw = 1.0;
    if (s.inPhase > 0.3 && moveHand(s, kLeft, e.goal[kLeft], 0.08)) { e.place = leftPlace(s); nextPhase(s); }
  } else {
    return takeThread(s, kLeft, 5, leftPlace, true);
  }
  return false;
}

namespace {

void beginStroke(const Scene& s) {
  ExpertState& e = s.memory;
  e.goal[kRight] = e.hand[kRight].command;
  e.drawn[kRight] = e.felt[kRight] = 0.0;
  nextPhase(s);
}

/// The driver draws the thread that it holds, slower where it `feels` it; true when it has come as far as an arm draws, or no farther.
bool drawStroke(const Scene& s, bool feels) {
  ExpertState& e = s.memory;
  feel(e.felt[kRight], s.state.tools[kRight].threadForce.norm(), s.dt, kFeelTime);
  const double pace = feels ? std::fmax(0.0, 1.0 - e.felt[kRight] / kMostPull) : 1.0;   // [1]
  e.drawn[kRight] += pace * kDrawSpeed * s.dt;
  moveHand(s, kRight, {e.goal[kRight].position + e.drawn[kRight] * kDrawWay, e.goal[kRight].orientation}, 0.1);
  return e.drawn[kRight] > kDrawReach || e.felt[kRight] > (feels ? kStalls : 1.0) * kMostPull;
}

}  // namespace

/// Hand over hand: while the forceps keep the needle, the driver takes the thread by the stitch and draws it through, stroke after stroke,
/// until so much has come. Phases 1 to 3: it takes hold. 4: it draws.
bool runDraw(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (s.state.strand.holeCount < 2) { failure = "there is no stitch in the tissue"; return false; }
  if (e.phase == 0) {
    e.place = needlePlace(s);
    nextPhase(s);
  } else if (e.phase <= 3) {
    if (takeThread(s, kRight, 1, needlePlace, false)) beginStroke(s);
  } else {
    const double through = s.model.strand.length - s.state.strand.holes[s.state.strand.holeCount - 1].coordinate;   // [m]
    if (through >= s.action.pull) return true;
    if (drawStroke(s, s.state.cut.has_value())) e.phase = 0;   // over cut edges thread catches; against the hand that keeps the needle all between them is out
  }
  return false;
}

/// Phase 0: both hands let go and rise. 1: looks. 2 to 4: the driver takes hold. 5: it draws. A knot whose throws this draws tight, and that holds, stays,
/// let go and looked at as any other: it cannot be taken out.
bool runTakeOut(const Scene& s) {
  ExpertState& e = s.memory;
  if (e.phase == 0) {
    if (s.inPhase < 1.5 * s.dt)
      for (int h = 0; h < kHands; ++h) e.goal[h] = above(e.hand[h].command, kUp);
    bool up = true;
    for (int h = 0; h < kHands; ++h) {
      e.hand[h].jaw = s.inPhase < 0.5 * kLetGo && s.state.tools[h].ratchet ? 0.0 : 1.0;   // a squeeze opens the ratchet
      up = s.inPhase > kLetGo && moveHand(s, h, e.goal[h], kRiseSpeed) && up;
    }
    if (up) nextPhase(s);
  } else if (s.state.strand.holeCount == 0) {
    return true;
  } else if (e.phase == 1) {
    if (finishedLoop(s.model, s.state)) return s.inPhase > kLook;
    e.place = needlePlace(s);
    nextPhase(s);
  } else if (e.phase <= 4) {
    if (takeThread(s, kRight, 2, needlePlace, false)) beginStroke(s);
  } else if (drawStroke(s, true)) {
    goTo(s, finishedLoop(s.model, s.state) ? 0 : 1);
  }
  return false;
}

/// Both tails of a purse-string are drawn apart, crossed as for a knot: each hand pulls over the other's hole, so the gap between them closes
/// too. Each hand feels its own tail: it draws until that is tight, gives way when it is too tight, and stops when the opening is closed or closes no farther.
bool runTighten(const Scene& s, std::string&) {
  ExpertState& e = s.memory;
  if (e.phase == 0) {
    for (int h = 0; h < kHands; ++h) e.goal[h] = e.hand[h].command;
    e.drawn = e.felt = {};
    e.settled = e.stuck = 0.0;
    e.closed = false;
    e.leastOpen = opening(s.state, s.model);
    nextPhase(s);
  }
  const double open = opening(s.state, s.model);                                                 // [1]
  const bool gains = open < e.leastOpen - kGains;
  if (gains) e.leastOpen = open;
  e.stuck = gains ? 0.0 : e.stuck + s.dt;
  e.closed = open < (e.closed ? kSnug : kClosed);                                                 // held, it springs back a little
  bool exhausted = false;                      // an arm is stretched out and its tail still slack: both need a shorter grip
  double fastest = 0.0;                        // [1] of the tightening speed
  for (int h = 0; h < kHands; ++h) {
    feel(e.felt[h], s.state.tools[h].threadForce.norm(), s.dt, kFeelTime);
    const double slack = (s.action.tension - e.felt[h]) / kFeel;                                 // [1]
    const double pace = e.closed ? std::fmin(0.0, slack + 1.0) : e.drawn[h] >= kTightenReach ? std::fmin(0.0, slack) : std::fmin(1.0, slack);
    e.drawn[h] = std::fmax(-kMostGiven, e.drawn[h] + std::fmax(-1.0, pace) * kTightenSpeed * s.dt);
    fastest = std::fmax(fastest, pace);
    exhausted = exhausted || e.drawn[h] >= kTightenReach;
    const double side = h == kLeft ? -1.0 : 1.0;                                                 // [1]
    const Vec3 way = Vec3(side, -0.35, 0.25).normalized();
    moveHand(s, h, {e.goal[h].position + e.drawn[h] * way, e.goal[h].orientation}, 0.1);
  }
  e.settled = open < kSnug || exhausted || fastest < kTight ? e.settled + s.dt : 0.0;
  return e.settled > kHoldTight || e.stuck > kPatience;
}

}  // namespace halsted::scenes
