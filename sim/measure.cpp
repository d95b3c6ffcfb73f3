#include "sim/measure.h"

#include <cmath>
#include <limits>

#include "sim/contact/geometry.h"
#include "sim/cutting/cut_measure.h"
#include "sim/cutting/edge.h"
#include "sim/damage.h"
#include "sim/needling/needling_scene.h"
#include "sim/suture/fresh_thread.h"
#include "sim/suture/hole_sides.h"
#include "sim/suture/holes.h"
#include "sim/suture/tied_loop.h"

namespace halsted {
namespace {

constexpr double kLoaded = 0.02;               // [N] below it a hand is not working
constexpr int kJoinInterval = 16;                  // steps between looks at the edges that are being joined
constexpr double kThrough = 0.98;              // [1] of the wall: the needle was in the lumen
constexpr int kStretchInterval = 16;           // steps between looks at every edge
constexpr double kAcross = 0.8;                // [1] a chord whose middle is nearer to the centre than this share of the rim's radius

/// Distance to the rim's outline [m], and its mean radius.
double rimDistance(std::span<const int> rim, std::span<const Vec3> x, const Vec3& p) {
  double best = 1e300;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vec3 &a = x[rim[i]], &b = x[rim[(i + 1) % rim.size()]];
    best = std::fmin(best, (p - a - closestOnSegment(p, a, b) * (b - a)).norm());
  }
  return best;
}

double rimRadius(std::span<const int> rim, std::span<const Vec3> x) {
  const Vec3 centre = centreOf(rim, x);
  double sum = 0.0;                            // [m]
  for (int v : rim) sum += (x[v] - centre).norm();
  return sum / static_cast<double>(rim.size());
}

/// The chord from the last exit to this entry runs over the opening instead of along the rim. Both at rest.
bool crossesOpening(std::span<const int> rim, std::span<const Vec3> x, const Vec3& from, const Vec3& to) {
  Vec3 middle = 0.5 * (from + to) - centreOf(rim, x);
  middle.z() = 0.0;                            // the rim's plane faces +z at rest
  return middle.norm() < kAcross * rimRadius(rim, x);
}

/// The entry of the bite that ends in this exit, one of the strand's holes; the tip may have gone in elsewhere since. It lies before it, with fifty bites
/// in the tissue mostly just before.
const Hole& entryOf(const StrandState& s, const Hole& exit) {
  for (int i = static_cast<int>(&exit - s.holes.data()); i >= 0; --i)
    if (s.holes[i].bite == exit.bite && s.holes[i].role == static_cast<std::int32_t>(HoleRole::kEntry)) return s.holes[i];
  return exit;
}

/// Bites that came out of the wall on the side on which they went into it, in what the thread in use still has in the tissue.
int partialBites(const Model& m, const StrandState& s) {
  int count = 0;
  for (int i = 0; i < s.holeCount; ++i) {
    const Hole& h = s.holes[i];
    if (h.role != static_cast<std::int32_t>(HoleRole::kPassed) && h.role != static_cast<std::int32_t>(HoleRole::kExit)) continue;
    const Hole& entry = entryOf(s, h);
    count += &entry != &h && onMucosa(m, entry) == onMucosa(m, h);
  }
  return count;
}

/// The needle's way went at least as deep as the deeper of the two holes: one from the inside out begins in the lumen.
void closeBite(const Model& m, const std::array<const Hole*, 2>& ends, int bite, SeamMetrics& seam) {
  for (const Hole* h : ends) seam.deepestTip = std::fmax(seam.deepestTip, wallShare(m, placeOf(*h)));
  if (bite < kMaxBites) seam.wallShare[bite] = seam.deepestTip;
  seam.fullThickness += seam.deepestTip > kThrough;
  seam.deepestTip = 0.0;
  seam.lastBowel = bowelOf(m, *ends[0]);
}

void completeBite(const Model& m, const Hole& exit, State& s, StepOutput& out) {
  MetricsState& metrics = s.metrics;
  const Hole& entered = entryOf(s.strand, exit);
  const Vec3 at = holePoint(m, exit, m.mesh.vertices), entry = holePoint(m, entered, m.mesh.vertices);
  const int i = metrics.biteCount++, bowel = bowelOf(m, entered);
  const std::span<const int> rim = edgeOf(m, s, bowel);
  if (i < kMaxBites) {
    BiteMetrics& b = metrics.bites[i];
    b.entryAngle = entered.entryCosine;
    b.width = (at - entry).norm();
    b.depth = rimDistance(rim, m.mesh.vertices, entry);
    b.spacing = i > 0 ? (entry - metrics.lastExit).norm() : 0.0;
  }
  const bool sameBowel = !metrics.seam || metrics.seam->lastBowel == bowel;
  if (i > 0 && sameBowel && crossesOpening(rim, m.mesh.vertices, metrics.lastExit, entry)) ++metrics.acrossOpening;
  metrics.lastExit = at;
  if (metrics.seam) closeBite(m, {&entered, &exit}, i, *metrics.seam);
  pushEvent(out, {s.step, EventKind::kBiteCompleted, -1, i, i < kMaxBites ? metrics.bites[i].depth : 0.0});
}

/// How deep in the wall the needle's tip is, and has been since the last bite was complete.
void followTip(const Model& m, const StrandState& strand, SeamMetrics& seam) {
  for (int i = 0; i < strand.holeCount; ++i) {
    const Hole& h = strand.holes[i];
    if (h.role != static_cast<std::int32_t>(HoleRole::kTip) && h.role != static_cast<std::int32_t>(HoleRole::kExit)) continue;
    seam.deepestTip = std::fmax(seam.deepestTip, wallShare(m, placeOf(h)));
  }
}

/// A bite is complete when the whole needle has left its exit and thread lies in the wall.
void countBites(const Model& m, State& s, StepOutput& out) {
  for (int i = 0; i < s.strand.holeCount; ++i) {
    Hole& h = s.strand.holes[i];
    if (h.role != static_cast<std::int32_t>(HoleRole::kExit) || h.coordinate > m.strand.length) continue;
    h.role = static_cast<std::int32_t>(HoleRole::kPassed);
    completeBite(m, h, s, out);
  }
}

void measureHands(State& s) {
  for (int hand = 0; hand < kHands; ++hand) {
    HandMetrics& h = s.metrics.hands[hand];
    const ToolState& t = s.tools[hand];
    if (h.started) h.pathLength += (t.proxy.position - h.lastPosition).norm();
    h.started = true;
    h.lastPosition = t.proxy.position;
    const double force = t.force.norm();
    h.peakForce = std::fmax(h.peakForce, force);
    if (force > kLoaded) { h.forceSum += force; h.forceSteps += 1.0; }
  }
}

void measureStretch(const Model& m, State& s) {
  if (s.step % kStretchInterval != 0) return;
  double peak = 0.0;                           // [1] squared
  for (int v : m.surface.vertices) {
    for (int e = m.surface.neighbourStart[v]; e < m.surface.neighbourStart[v + 1]; ++e) {
      const int u = m.surface.neighbour[e];
      if (u < v || (s.cut && !s.cut->tie[e])) continue;
      const double now = (s.tissue.position[u] - s.tissue.position[v]).squaredNorm();
      peak = std::fmax(peak, now / (m.mesh.vertices[u] - m.mesh.vertices[v]).squaredNorm());
    }
  }
  s.metrics.peakStretch = std::fmax(s.metrics.peakStretch, std::sqrt(peak));
}

double rimToRod(const Model& m, std::span<const Vec3> x) {
  const RodParams& rod = m.params.anvil;
  double sum = 0.0;                            // [m]
  if (!(rod.radius > 0.0)) return 0.0;
  for (int v : m.mesh.rim) sum += (x[v] - rod.from - closestOnSegment(x[v], rod.from, rod.to) * (rod.to - rod.from)).norm() - rod.radius;
  return sum / static_cast<double>(m.mesh.rim.size());
}

/// What the two tails carry where a hand holds them, as a knot bears what is drawn at it; just outside the first and the last hole where none
/// does.  [N]
std::array<double, 2> tailTensions(const Model& m, const State& s) {
  if (s.strand.holeCount == 0) return {0.0, 0.0};
  const double first = s.strand.holes[0].coordinate, last = s.strand.holes[s.strand.holeCount - 1].coordinate;   // [m]
  std::array<double, 2> tension{strandTension(m.strand, s.strand, first, -1), strandTension(m.strand, s.strand, last, 1)};
  for (const ToolState& t : s.tools) {
    if (t.threadCoordinate < 0.0) continue;
    if (t.threadCoordinate < first) tension[0] = strandTension(m.strand, s.strand, t.threadCoordinate, 1);
    if (t.threadCoordinate > last) tension[1] = strandTension(m.strand, s.strand, t.threadCoordinate, -1);
  }
  return tension;
}

void measureSeam(const SeamMetrics& seam, int lastBite, bool sewnOff, StepOutput& out) {
  const auto set = [&](Quantity q, double value) { out.seen[static_cast<int>(q)] = value; };
  set(Quantity::kCrossings, seam.join.crossings);
  set(Quantity::kRimGap, seam.join.rimGap);
  set(Quantity::kWallGap, seam.join.wallGap);
  const bool released = out.seen[static_cast<int>(Quantity::kTailsHeld)] == 0.0 && seam.join.crossings > 0 && sewnOff;
  set(Quantity::kReleasedGap, released ? seam.join.wallGap : std::numeric_limits<double>::quiet_NaN());   // what is held up, or still being sewn, meets no condition
  set(Quantity::kInversion, seam.join.inversion);
  set(Quantity::kTailDifference, seam.join.tailDifference);
  set(Quantity::kWallShare, lastBite >= 0 ? seam.wallShare[lastBite] : 0.0);
}

/// Thread between the tissue and the knot, mean of its two strands.  [m]
double gapToKnot(const State& s) {
  if (s.knot.throws == 0 || s.strand.holeCount == 0) return 0.0;
  return std::fmax(0.0, 0.5 * (s.strand.holes[0].coordinate - s.knot.tail + s.knot.tip - s.strand.holes[s.strand.holeCount - 1].coordinate));
}

void measureSuture(const Model& m, State& s, StepOutput& out) {
  if (s.metrics.seam) followTip(m, s.strand, *s.metrics.seam);
  countBites(m, s, out);
  if (s.metrics.seam && s.step % kJoinInterval == 0) s.metrics.seam->join = measureJoin(m, s);
  measureStretch(m, s);
  measureDamage(m, s);
  MetricsState& metrics = s.metrics;
  metrics.openingArea = enclosedArea(edgeOf(m, s, 0), s.tissue.position);
  metrics.restOpeningArea = m.restOpening;
  for (double t : s.strand.tension) metrics.peakTension = std::fmax(metrics.peakTension, t);
  const auto tails = tailTensions(m, s);
  const auto set = [&](Quantity q, double value) { out.seen[static_cast<int>(q)] = value; };
  const int last = metrics.biteCount < kMaxBites ? metrics.biteCount - 1 : kMaxBites - 1;
  set(Quantity::kNeedleHeld, s.tools[0].holdsNeedle + s.tools[1].holdsNeedle);
  const ThreadSupply before = s.supply.value_or(ThreadSupply{});   // what other threads have done is counted no more
  set(Quantity::kBites, metrics.biteCount - before.bitesBefore);
  set(Quantity::kStitchAcrossOpening, metrics.acrossOpening);
  set(Quantity::kBiteSpacing, last >= 0 ? metrics.bites[last].spacing : 0.0);
  set(Quantity::kBiteDepth, last >= 0 ? metrics.bites[last].depth : 0.0);
  set(Quantity::kTailTension, std::fmin(tails[0], tails[1]));
  set(Quantity::kPeakTension, metrics.peakTension);
  set(Quantity::kOpeningFraction, m.restOpening > 0.0 ? metrics.openingArea / m.restOpening : 0.0);
  set(Quantity::kRimToAnvil, rimToRod(m, s.tissue.position));
  set(Quantity::kTailsHeld, (s.tools[0].threadCoordinate >= 0.0) + (s.tools[1].threadCoordinate >= 0.0));
  set(Quantity::kTears, metrics.tears - before.tearsBefore);
  if (metrics.seam) {
    measureSeam(*metrics.seam, last, s.knot.cuts > 0, out);
    set(Quantity::kFullThickness, metrics.seam->fullThickness - before.fullThicknessBefore);
  }
  const DamageMetrics& damage = metrics.damage;
  set(Quantity::kPerforations, metrics.perforations);
  set(Quantity::kForceTime, std::fmax(damage.forceTime[kLeft], damage.forceTime[kRight]));
  set(Quantity::kPeakPressure, damage.peakPressure[static_cast<int>(Presser::kInstrument)]);
  set(Quantity::kInjuredArea, damage.injured[static_cast<int>(Presser::kInstrument)]);
  if (metrics.cut) observe(*metrics.cut, out.seen);
  set(Quantity::kPartialThickness, partialBites(m, s.strand));
  if (s.instruments) set(Quantity::kSecondInstruments, s.instruments->second[kLeft] + s.instruments->second[kRight]);
  set(Quantity::kTissueHeld, (s.tools[0].grasp.count > 0) + (s.tools[1].grasp.count > 0) + (s.clamps ? s.clamps->count : 0));
  set(Quantity::kStitches, finishedStitches(m, s));
  set(Quantity::kThreadsLeft, before.left);
  const KnotState& knot = s.knot;
  set(Quantity::kThrows, knot.throws);
  if (s.assist) metrics.assistedKnots = s.assist->locks;
  set(Quantity::kKnotLocks, locks(knot) + (s.assist && s.assist->locked));
  set(Quantity::kWrongThrows, slides(knot));
  set(Quantity::kFirstTurns, knot.turns[0]);
  set(Quantity::kKnotGap, gapToKnot(s));
  const std::optional<TiedLoop> loop = out.seen[static_cast<int>(Quantity::kTailsHeld)] == 0.0 ? finishedLoop(m, s) : std::nullopt;
  set(Quantity::kLoopSlack, loop ? loopSlack(m, s, *loop) : std::numeric_limits<double>::quiet_NaN());   // what is held up meets no condition
  set(Quantity::kToolTurns, knot.toolTurns[kRight] < 0 ? -knot.toolTurns[kRight] : knot.toolTurns[kRight]);
  set(Quantity::kThreadBreaks, knot.breaks);
  set(Quantity::kThreadCuts, knot.cuts);
}

}  // namespace

void measure(const Model& m, const StepInput& input, State& s, StepOutput& out) {
  measureHands(s);
  out.seen[static_cast<int>(Quantity::kTime)] = s.step * m.params.dt;
  out.seen[static_cast<int>(Quantity::kPeakForce)] = std::fmax(s.metrics.hands[0].peakForce, s.metrics.hands[1].peakForce);
  switch (m.params.model) {
    case ModelKind::kSuture: measureSuture(m, s, out); break;
    case ModelKind::kNeedling: measureNeedling(m, input, s, out); break;
  }
}

}  // namespace halsted
