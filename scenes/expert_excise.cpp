/// An excision: the left hand's clamps take the fold, one after the other, the right hand's pen goes round one wall and then the other, and the clamp carries off
/// what has come free. Hands move, nothing else.
#include <algorithm>
#include <cmath>

#include "scenes/expert_state.h"
#include "sim/portable_math.h"

namespace halsted::scenes {
namespace {

constexpr double kOver = 0.025;                // [m] above a place that is approached
constexpr double kAcross = 0.10, kClose = 0.03, kCarry = 0.05;   // [m/s] in the air, near tissue, with the specimen
constexpr double kHalfShut = 0.3;              // [1] of the clamp's jaws: shut on two walls without crushing them
constexpr double kCurrentOn = 0.0, kCurrentOff = 1.0;   // [1] the pen's button is its jaw
constexpr double kSettle = 0.3;                // [s]
constexpr int kAttempts = 3;
const Vec3 kAway(-0.075, 0.02, 0.035);         // [m] with the specimen, out of the picture's middle

/// A tool with its shaft along `shaft` toward the hand and its jaws opening as near to `across` as that allows.
Quat heldAlong(const Vec3& shaft, const Vec3& across) {   // [1]
  Mat3 axes;
  axes.col(2) = shaft.normalized();
  axes.col(0) = (across - across.dot(axes.col(2)) * axes.col(2)).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Quat(axes).normalized();
}

/// Top of the fold in a direction: the mucosa farthest from the line.
int crestAt(const Model& m, double turn) {     // [1] of a turn
  int best = -1;
  double least = 1e300;                        // [1]
  for (int v = 0; v < static_cast<int>(m.mesh.uv.size()); ++v) {
    if (m.bowels.wallDepth[v] != 1.0) continue;
    const double off = std::fabs(m.mesh.uv[v].x() - turn);                 // [1]
    const double cost = std::fmin(off, 1.0 - off) + 10.0 * m.mesh.uv[v].y();   // a row is worth ten times a column
    if (cost < least) { least = cost; best = v; }
  }
  return best;
}

double turnOf(double degrees) {                // [deg] -> [1] from 0 up to 1
  const double turn = degrees / 360.0;         // [1]
  return turn - std::floor(turn);
}

Pose foldGrip(const Scene& s) {
  const double angle = s.action.angleDegrees * kPi / 180.0;                // [rad]
  const Vec3 radial(cosine(angle), sine(angle), 0.0);
  const Vec3 shaft = (0.35 * radial + Vec3::UnitZ()).normalized();
  const Vec3 crest = s.state.tissue.position[crestAt(s.model, turnOf(s.action.angleDegrees))];
  const double deep = s.action.depth + 1e-3 * s.memory.attempt;            // [m]
  return {crest - deep * shaft, heldAlong(shaft, radial)};
}

/// Over the fold, down with one jaw in the lumen, shut.
bool takeFold(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  HandMotion& clamp = e.hand[kLeft];
  if (e.phase == 0) {
    clamp.jaw = 1.0;
    if (moveHand(s, kLeft, above(foldGrip(s), kOver), kAcross) && s.inPhase > kSettle) { e.goal[kLeft] = foldGrip(s); nextPhase(s); }
  } else if (e.phase == 1) {
    if (moveHand(s, kLeft, e.goal[kLeft], kClose)) nextPhase(s);
  } else {
    clamp.jaw = kHalfShut;
    if (s.inPhase < 2.0 * kSettle) return false;
    if (s.state.tools[kLeft].grasp.count > 0) { nextPhase(s); return true; }
    if (++e.attempt >= kAttempts) failure = "the clamp does not hold the fold";
    goTo(s, 0);
  }
  return false;
}

/// The blade across the wall, square to it but for `tilt_deg` toward the surgeon.
Pose penAt(const Scene& s, const RingPlace& place, double depth) {          // [m] below the surface
  const double lean = s.action.tilt * kPi / 180.0;                         // [rad]
  const Vec3 shaft = cosine(lean) * place.out + sine(lean) * Vec3::UnitZ();
  return {place.point - depth * place.out, heldAlong(shaft, Vec3::UnitZ())};
}

/// Nobody lets a blade deeper than the wall is thick: as deep as was said under the surface of the ring ahead, which is whole yet. What is
/// cut gives way under the blade and tells nothing. Where it has come down in vain, the wall has sunk in: deeper and longer every time.
Vec3 noDeeper(const Scene& s, const Vec3& place) {   // [m]
  constexpr double kAhead = 3.0, kDeeper = 0.3e-3;   // [1] columns [m]
  const CutCourse& c = s.memory.cut;
  const Vec3 centre = centreOf(c.ring, s.state), from = place - centre;     // [m]
  const double least = (placeOnRing(c.ring, s.state, c.first + c.done + kAhead).point - centre).norm() - s.action.depth - kDeeper * c.vain;   // [m]
  const double far = from.norm();              // [m]
  return far < least ? Vec3(centre + least / far * from) : place;
}

/// Onto the nearest bridge of the first part that has not parted, and on round the wall as soon as it has; where the blade only leans
/// against the wall and nothing burns, out of the wall and down on it. True when none is left.
bool followBridges(const Scene& s, Pose& pen) {
  constexpr double kSilent = 0.12, kClear = 0.8e-3, kThere = 1.0e-3, kLead = 0.45e-3, kPatience = 3.0;   // [s] [m] over the surface [m] [m] [s]
  constexpr int kMostVain = 8;
  CutCourse& c = s.memory.cut;
  const int around = static_cast<int>(c.ring.column.size());
  Bridge bridge;
  while (c.done < around && !bridgeAt(c.ring, s.model, s.state, c.first + c.done, bridge)) ++c.done;
  if (c.done == around) return true;
  c.quiet = s.state.metrics.cut->current ? 0.0 : c.quiet + s.dt;
  if (s.state.metrics.cut->current) c.vain = 0;
  const RingPlace place = placeOnRing(c.ring, s.state, c.first + c.done + 0.5);
  const double depth = (place.point - bridge.middle).dot(place.out);       // [m]
  pen = penAt(s, {bridge.middle, place.out}, c.lifted ? -depth - kClear : 0.0);
  if (!c.lifted) pen.position = noDeeper(s, pen.position);
  const Vec3& tip = s.state.tools[kRight].proxy.position;
  const Vec3 way = pen.position - tip;         // [m]
  if (c.lifted && (way.norm() < kThere || c.quiet > kPatience)) { c.lifted = false; c.quiet = 0.0; }
  else if (!c.lifted && c.quiet > kSilent * (1 + c.vain)) { c.lifted = true; c.vain = std::min(c.vain + 1, kMostVain); }
  if (!c.lifted && way.norm() > kLead) pen.position = tip + kLead / way.norm() * way;     // led, not pushed
  return false;
}

/// A hand that cuts does not press on what holds it back: when that goes, it would fall through.
void holdLightly(HandMotion& pen) {
  constexpr double kMost = 0.4e-3;             // [m] past what is aimed at
  const double size = pen.correction.norm();   // [m]
  if (size > kMost) pen.correction *= kMost / size;
}

bool beginCut(const Scene& s, std::string& failure) {
  CutCourse& c = s.memory.cut;
  const double line = s.model.params.anatomy.cutHeight;                    // [m] over the base
  c = {};
  c.ring = ringOn(s.model, s.action.bowel, s.action.height > 0.0 ? line - s.action.height : 0.0);
  if (!c.ring.present()) { failure = "there is no wall to cut there"; return false; }
  c.first = static_cast<int>(turnOf(s.action.angleDegrees) * static_cast<double>(c.ring.column.size()));
  return true;
}

}  // namespace

bool runHoldFold(const Scene& s, std::string& failure) {
  constexpr double kPull = 4e-3, kMost = 0.015, kFelt = 0.1;               // [m/s] [m] [s]
  ExpertState& e = s.memory;
  if (e.phase < 3) {
    if (!takeFold(s, failure)) return false;
    e.goal[kLeft] = e.hand[kLeft].command;
    e.pulled = e.felt[kLeft] = 0.0;
    // Away from the middle of the line: its whole circumference is then stretched alike, and the cut gapes as it is made.
    e.pullAlong = (e.goal[kLeft].position - centreOf(ringOn(s.model, 0, 0.0), s.state)).normalized();
  }
  feel(e.felt[kLeft], s.state.tools[kLeft].force.norm(), s.dt, kFelt);
  if (s.state.tools[kLeft].grasp.count == 0) failure = "the fold has slipped out of the clamp";
  if (e.felt[kLeft] >= s.action.tension || e.pulled >= kMost) return true;
  e.pulled += kPull * s.dt;
  moveHand(s, kLeft, {e.goal[kLeft].position + e.pulled * e.pullAlong, e.goal[kLeft].orientation}, kClose);
  return false;
}

bool runHandOver(const Scene& s, std::string& failure) {
  constexpr double kAnswer = 0.2;              // [s] in which the assistant takes it or says why not
  ExpertState& e = s.memory;
  HandMotion& clamp = e.hand[kLeft];
  if (!s.state.clamps) { failure = "the assistant has no clamp to give for this one: assistant.clamps"; return false; }
  if (e.phase == 0) {
    e.clampsBefore = s.state.clamps->count;
    e.spoken = {Command::Kind::kHandOver, static_cast<double>(kLeft)};
    e.goal[kLeft] = above(clamp.command, kOver);
    nextPhase(s);
  } else if (e.phase == 1) {
    if (s.state.clamps->count > e.clampsBefore) nextPhase(s);
    else if (s.inPhase > kAnswer) failure = name(static_cast<ClampRefusal>(s.state.clamps->refusal));
  } else if (moveHand(s, kLeft, e.goal[kLeft], kClose)) {        // shut as it is: it would open against what stands beside it
    clamp.jaw = 1.0;
    return s.inPhase > kSettle;
  }
  return false;
}

/// Over the start; down on it; round with current; out again.
bool runCutRing(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  HandMotion& pen = e.hand[kRight];
  if (e.phase == 0) {
    if (!beginCut(s, failure)) return false;
    nextPhase(s);
  }
  const RingPlace place = placeOnRing(e.cut.ring, s.state, e.cut.first + e.cut.done + 0.5);
  if (e.phase <= 2) {
    pen.jaw = kCurrentOff;
    if (moveHand(s, kRight, penAt(s, place, e.phase == 1 ? -kOver : -1e-3), e.phase == 1 ? kAcross : kClose) && s.inPhase > kSettle) nextPhase(s);
  } else if (e.phase == 3) {
    holdLightly(pen);
    Pose goal;
    const bool through = followBridges(s, goal);
    pen.jaw = e.cut.lifted || through ? kCurrentOff : kCurrentOn;
    if (!through) { moveHand(s, kRight, goal, e.cut.lifted ? kClose : s.action.speed); return false; }
    e.goal[kRight] = penAt(s, place, -kOver);
    nextPhase(s);
  } else {
    pen.jaw = kCurrentOff;
    return moveHand(s, kRight, e.goal[kRight], kClose);
  }
  return false;
}

/// Only what has come free is carried off.
bool runTakeAway(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  HandMotion& clamp = e.hand[kLeft];
  const CutMetrics& cut = *s.state.metrics.cut;
  if (e.phase == 0) {
    if (cut.freePieces == 0) { failure = "the specimen is not free"; return false; }
    if (s.state.tools[kLeft].grasp.count == 0) { failure = "the clamp holds nothing"; return false; }
    e.goal[kLeft] = {clamp.command.position + kAway, clamp.command.orientation};
    nextPhase(s);
  }
  moveHand(s, kRight, parked(kRight), kAcross);
  if (e.phase == 1) {
    if (moveHand(s, kLeft, e.goal[kLeft], kCarry)) nextPhase(s);
  } else {
    clamp.jaw = 1.0;
    return s.inPhase > kSettle && cut.taken > 0;
  }
  return false;
}

}  // namespace halsted::scenes
