#include "sim/suture/assist_knot.h"

#include <algorithm>
#include <cmath>

#include "sim/lanes.h"
#include "sim/model.h"
#include "sim/state.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"
#include "sim/suture/knotting.h"

namespace halsted {
namespace {

constexpr double kStiffness = 2e4;             // [N/m] of the tie: 3 N part the strands by less than their width
constexpr int kSamples = 48;                   // along the tails
constexpr double kCrossedFor = 0.05;           // [s]
constexpr double kFirm = 0.5;                  // [N] more tension than this in the loop than in the hand: it is tight, the knot runs no farther
constexpr double kTight = 0.3;                 // [N] the same where it only remains to be seen: a knot that has run as far as it goes hovers about kFirm
constexpr double kYields = 2.0;                // [N] more tension than this in the loop: a throw that is not locked yet lets thread back into it
constexpr double kRun = 0.03;                  // [m/s] down to the tissue
constexpr double kClose = 0.05;                // [m/s] the two strands come together
constexpr double kSeatSlack = 2e-3;            // [m] of thread in the loop beyond the straight way from hole to hole
constexpr double kSeatFor = 0.2;               // [s]
constexpr double kRelaxed = 0.5;               // [1] of the tension that places it: no longer drawn
constexpr double kFeelTime = 0.01;             // [s]
constexpr double kSlipPerNewton = 0.02;        // [m/s per N] past the holding force
constexpr double kClearOfHole = 0.5e-3;        // [m] a knot does not go through its hole

const Hole& firstHole(const State& s) { return s.strand.holes[0]; }
const Hole& lastHole(const State& s) { return s.strand.holes[s.strand.holeCount - 1]; }

/// How far toward the tissue the knot may lie on either strand.  [m]
double tailLimit(const State& s) { return firstHole(s).coordinate - kClearOfHole; }
double tipLimit(const State& s) { return lastHole(s).coordinate + kClearOfHole; }

Vec3 pointAt(const Model& m, const State& s, double coordinate) { return strandPoint(m.strand, s.strand, coordinate); }

/// Coordinates at which the hands hold the two tails, and the smaller of the two pulls.
struct HeldTails {
  double tail = -1.0, tip = -1.0;              // [m] negative: not held
  double pull = 0.0;                           // [N]
  bool both() const { return tail >= 0.0 && tip >= 0.0; }
};

HeldTails heldTails(const State& s) {
  HeldTails held;
  double pull[2] = {0.0, 0.0};                 // [N]
  for (const ToolState& t : s.tools) {
    const double c = t.threadCoordinate;       // [m]
    if (c < 0.0) continue;
    if (c < firstHole(s).coordinate) { held.tail = c; pull[0] = t.threadForce.norm(); }
    if (c > lastHole(s).coordinate) { held.tip = c; pull[1] = t.threadForce.norm(); }
  }
  held.pull = std::min(pull[0], pull[1]);
  return held;
}

/// The two tails walked along together, from the tissue to the hands: at each share of the way, from the one to the other.
class Walk {
 public:
  Walk(const Model& m, const State& s, double tail, double tip)
      : model_(m), state_(s), tail_(tail), tip_(tip), start_(between(0.0)),
        up_(0.5 * (pointAt(m, s, tail) + pointAt(m, s, tip)) - 0.5 * (pointAt(m, s, firstHole(s).coordinate) + pointAt(m, s, lastHole(s).coordinate))) {}

  double tailAt(double share) const { return firstHole(state_).coordinate + share * (tail_ - firstHole(state_).coordinate); }   // [m], [1]
  double tipAt(double share) const { return lastHole(state_).coordinate + share * (tip_ - lastHole(state_).coordinate); }       // [m], [1]
  Vec3 between(double share) const { return pointAt(model_, state_, tailAt(share)) - pointAt(model_, state_, tipAt(share)); }   // [1]
  double distanceSquared(double tail, double tip) const { return (pointAt(model_, state_, tail) - pointAt(model_, state_, tip)).squaredNorm(); }   // [m]
  /// Does it lie forward of the start's normal plane, and on which side of the start?
  bool ahead(const Vec3& v) const { return v.dot(start_) > 0.0; }
  bool left(const Vec3& v) const { return up_.dot(start_.cross(v)) > 0.0; }

 private:
  const Model& model_;
  const State& state_;
  double tail_, tip_;                          // [m]
  Vec3 start_, up_;                            // [m]
};

/// Signed.
int turnsOf(const Walk& walk) {
  int half = 0;
  bool ahead = true;
  for (int i = 1; i <= kSamples; ++i) {
    const double share = static_cast<double>(i) / kSamples;      // [1]
    const Vec3 v = walk.between(share);
    if (walk.ahead(v) == ahead) continue;
    half += walk.left(v) == ahead ? 1 : -1;                // over the left from ahead to behind, over the right back again
    ahead = !ahead;
  }
  return half;
}

/// Where the two tails are nearest to each other: the crossing. Returns how near.  [m]
double nearestPlaces(const Walk& walk, AssistKnot& k) {
  double least = 1e300;                        // [m^2]
  for (int i = 1; i <= kSamples; ++i)
    for (int j = 1; j <= kSamples; ++j) {
      const double tail = walk.tailAt(static_cast<double>(i) / kSamples), tip = walk.tipAt(static_cast<double>(j) / kSamples);   // [m]
      const double d2 = walk.distanceSquared(tail, tip);         // [m^2]
      if (d2 >= least) continue;
      least = d2;
      k.tail = tail;
      k.tip = tip;
    }
  return std::sqrt(least);
}

void undo(AssistKnot& k) {
  const AssistKnot old = k;
  k = AssistKnot{};
  k.locks = old.locks;
  k.slipped = old.slipped;
}

/// Both tails crossed and tight for a moment: there it is.
void place(const Model& m, State& s, AssistKnot& k) {
  const HeldTails held = heldTails(s);
  const bool tight = held.both() && held.pull > m.params.thread.assistTension;
  k.drawn = tight && turnsOf(Walk(m, s, held.tail, held.tip)) != 0 ? k.drawn + m.params.dt : 0.0;
  if (k.drawn < kCrossedFor) return;
  k.placed = true;
  k.apart = nearestPlaces(Walk(m, s, held.tail, held.tip), k);
}

/// Tension on the hand's side over the tissue's, from what the tie and the hand's side pull: between knot and hole may lie less than a
/// segment. `way` is from the tissue to the hand along the coordinate.  [m] [1] [N]
double feltAt(const Model& m, const State& s, double place, int way, const Vec3& tie) {
  const int node = threadSpot(m.strand, place).node;
  const int near = way < 0 ? std::max(1, node) : std::min(node + 1, m.strand.nodes - 2), far = near + way;
  const double pull = std::max(0.0, s.strand.tension[std::min(near, far)]);   // [N]
  const Vec3 outward = (s.strand.position[far] - s.strand.position[near]).normalized();
  return pull - (tie + pull * outward).norm();
}

void feel(const Model& m, const State& s, AssistKnot& k) {
  const Vec3 tie = tieForce(s.work.threadContacts.tie, s.strand.position);   // [N]
  const double now[2] = {feltAt(m, s, k.tail, -1, tie), feltAt(m, s, k.tip, 1, -tie)};   // [N]
  for (int i = 0; i < 2; ++i) k.felt[i] += std::min(1.0, m.params.dt / kFeelTime) * (now[i] - k.felt[i]);
}

/// Thread in the loop beyond the straight way between its two holes.  [m]
double slackOf(const Model& m, const State& s, const AssistKnot& k) {
  const Vec3 a = holePoint(m, firstHole(s), s.tissue.position), b = holePoint(m, lastHole(s), s.tissue.position);
  return firstHole(s).coordinate - k.tail + k.tip - lastHole(s).coordinate - (a - b).norm();
}

void lock(const State& s, AssistKnot& k, StepOutput& out) {
  k.locked = true;
  k.felt = {};
  pushEvent(out, {s.step, EventKind::kThrowTied, -1, ++k.locks, 0.0});
}

/// Thread goes through it where one side pulls more than so much harder than the other. Returns how much.  [N] [m]
double giveWay(const Model& m, const State& s, double most, AssistKnot& k) {
  const auto past = [&](int i) { return k.felt[i] > most ? k.felt[i] - most : (k.felt[i] < -most ? k.felt[i] + most : 0.0); };
  const double scale = kSlipPerNewton * m.params.dt;             // [m/N]
  const double tail = std::min(k.tail + scale * past(0), tailLimit(s));
  const double tip = std::max(k.tip - scale * past(1), tipLimit(s));
  const double slipped = magnitude(tail - k.tail) + magnitude(tip - k.tip);   // [m]
  k.tail = tail;
  k.tip = tip;
  return slipped;
}

/// Toward the tissue, and with it the two sides together, by the hands' draw. It runs back only where the loop is far tighter than they draw:
/// what springs apart or is let down would be locked in so tight that it tears the thread out.
void run(const Model& m, State& s, AssistKnot& k, StepOutput& out) {
  const HeldTails held = heldTails(s);
  const double dt = m.params.dt, least = m.params.thread.assistTension;   // [s], [N]
  const bool seated = k.seated >= kSeatFor, drawing = held.both() && held.pull > least;
  if (seated && held.pull < kRelaxed * least) return lock(s, k, out);
  if (!held.both()) {
    undo(k);
    pushEvent(out, {s.step, EventKind::kThrowLost, -1, 0, 0.0});
    return;
  }
  const double slack = slackOf(m, s, k), step = drawing ? kRun * dt : 0.0;   // [m]
  if (k.felt[0] > -kFirm) k.tail = std::min(k.tail + step, tailLimit(s));
  if (k.felt[1] > -kFirm) k.tip = std::max(k.tip - step, tipLimit(s));
  giveWay(m, s, kYields, k);
  // It lies on the tissue where the loop is as short as the way straight across, or where it is tight: over a ridge it is longer.
  const bool tight = k.felt[0] < -kTight && k.felt[1] < -kTight;
  // Hands that give way take the tension off it: what it was while it was drawn counts, or over a ridge it would never lock.
  if (drawing) k.seated = slack > kSeatSlack && !tight ? 0.0 : k.seated + dt;
}

/// A locked knot holds up to its force, then thread goes through it.
void slip(const Model& m, State& s, AssistKnot& k) { k.slipped += giveWay(m, s, m.params.thread.assistHolding, k); }

/// Is there still thread on both sides of what it holds?
bool exists(const Model& m, const State& s, const AssistKnot& k) {
  return s.strand.holeCount > 1 && k.tail > 0.0 && k.tip < m.strand.length && !partedAt(m, s, k.tail) && !partedAt(m, s, k.tip);
}

}  // namespace

int halfTurns(const Model& m, const State& s, double tail, double tip) { return turnsOf(Walk(m, s, tail, tip)); }

void linkAssistKnot(const Model& m, State& s) {
  ThreadTie& tie = s.work.threadContacts.tie;
  tie.stiffness = 0.0;
  if (!s.assist || !s.assist->placed) return;
  AssistKnot& k = *s.assist;
  tie.first = segmentWeights(m.strand, k.tail);
  tie.second = segmentWeights(m.strand, k.tip);
  const Vec3 between = curvePoint(s.strand.position, tie.first) - curvePoint(s.strand.position, tie.second);
  const double size = between.norm();          // [m]
  // They come together by the hands' pull, which bends both strands about the knot: no more force than that is made here.
  const double most = kFirm + (s.strand.holeCount > 1 ? 2.0 * heldTails(s).pull : 0.0);   // [N]
  if (kStiffness * (size - k.apart) < most) k.apart = std::max(2.0 * m.strand.radius, k.apart - kClose * m.params.dt);
  tie.apart = size > 1e-9 ? Vec3(k.apart / size * between) : Vec3(k.apart * Vec3::UnitX());
  tie.stiffness = kStiffness;
}

void settleAssistKnot(const Model& m, State& s, StepOutput& out) {
  if (!s.assist) return;
  AssistKnot& k = *s.assist;
  if (k.placed && !exists(m, s, k)) {
    undo(k);
    pushEvent(out, {s.step, EventKind::kThrowLost, -1, 0, 0.0});
  }
  if (s.strand.holeCount < 2) return;
  if (!k.placed) return place(m, s, k);
  feel(m, s, k);
  if (k.locked) slip(m, s, k);
  else run(m, s, k, out);
}

}  // namespace halsted
