#include "scenes/tie_places.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/surface.h"
#include "sim/portable_math.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"
#include "sim/suture/knotting.h"
#include "sim/tools/instrument.h"

namespace halsted::scenes {
namespace {

constexpr double kRise = 0.12;                 // [1] of the driver's shaft over the level way to its handle: steeper, its device would come to its stop far over the stitch
constexpr double kTailRise = 0.7;              // [1] as it takes the tail: flatter, and the lower jaw would dig into the tissue on which that lies
constexpr double kWindRise = -kRise, kLeftRise = 0.7;   // [1] of the other hand's: along the driver's while it winds, or its shaft would pass through the jaws
constexpr double kUpJaws = 12e-3;              // [m] above the tips: where the thread goes round; what the jaws grip lies lower
constexpr double kSlant = 0.05;                // [1] of the thread toward the tips: turns lie side by side; more, and the first slides off
constexpr double kSlack = 6e-3;                // [m] kept in the long end so that the jaws can open inside the loop
constexpr double kPerThrow = 6e-3;             // [m] of each end that a throw takes up
constexpr double kLoop = 2.3e-3;               // [m] radius of a turn about the jaws
constexpr double kNearest = 6e-3, kFarthest = 35e-3;   // [m] of the winding hand from the driver
constexpr double kPerTurn = 20e-3;             // [m] of the long end that a second turn takes
constexpr double kSpare = 3e-3;                // [m] of the long end left at each turn: turns are wider than the jaws
constexpr double kJaws = 30e-3;                // [m] of the driver that may have thread wound about it
constexpr double kAbout = 25e-3, kOverTissue = 6e-3;   // [m] of tissue about the stitch; of the winding hand above it
constexpr double kLevel = 1e-6;                // [1] of the way down; less is rounding of whole turns
constexpr double kCling = 20e-3;               // [m] from the jaws; a needle that is cut off falls half a metre meanwhile
constexpr double kMostOfIt = 0.6;              // [1] of the way to where the long end is to be taken
constexpr double kFromEnd = 5e-3;              // [m] of tail beyond the jaws
constexpr double kLongTail = 40e-3, kBeyondGrip = 0.25;   // [m] of tail; of one that is longer [1]
constexpr double kSamePlace = 12e-3, kRoom = 8e-3, kFar = 0.1;   // [m] along the thread; no better with more; [1] room that one would give up to be nearer to where one would like to
constexpr double kUpright = 10e-3, kMostDetour = 15e-3;   // [m] above the stitch, past every edge; of thread that is no curl
constexpr double kElsewhere = 4e-3;            // [m] along the tail and back: all that lies beyond the jaws has to come through the loop with them

const StrandState& strand(const Scene& s) { return s.state.strand; }

/// The other hand's shaft, from the tips to the handle, and the way from the stitch up to the driver.  [1]
Vec3 leftShaft(const Scene& s, double rise) { return (rise * s.memory.knot.up - s.memory.knot.handle).normalized(); }   // [1]
Vec3 upward(const Scene& s) { return (s.memory.knot.up - kRise * s.memory.knot.handle).normalized(); }

/// Tool with its shaft this way, its jaws opening across `along`, whichever way round is nearer.
Pose laid(const Scene& s, int hand, const Vec3& position, std::array<Vec3, 2> shaftAndAlong) {   // [m], [1]
  const auto& [z, along] = shaftAndAlong;
  Vec3 y = along - along.dot(z) * z;
  y = y.norm() > 0.1 ? Vec3(y.normalized()) : Vec3(z.cross(s.memory.knot.up).normalized());
  if (y.dot(s.memory.hand[hand].command.orientation * Vec3::UnitY()) < 0.0) y = -y;
  Mat3 axes;
  axes << y.cross(z), y, z;
  return {position, Quat(axes).normalized()};
}

/// Of the long end that winding may use.  [m]
double longLength(const Scene& s) {
  const double hole = std::fmax(s.memory.knot.hole, longHole(s).coordinate);   // [m]
  return s.state.tools[kLeft].threadCoordinate - hole - kSlack - std::fmax(kPerThrow * s.memory.knot.current, s.memory.knot.detour);
}
int turns(const Scene& s) { return s.memory.knot.throws[s.memory.knot.current].turns; }   // of this throw
/// The driver above the stitch: so high that the thread is straight all the way round, but not on the tissue.  [m]
double heightOf(const Scene& s) {
  const double straight = longLength(s) - kNearest - kSpare * turns(s) - kLoop * (wholeTurns(s) - 0.5 * kPi);   // [m]
  return std::fmax(kOverTissue, straight - s.memory.knot.lower);
}

}  // namespace

const Hole& tailHole(const Scene& s) { return strand(s).holes[0]; }
const Hole& longHole(const Scene& s) { return strand(s).holes[strand(s).holeCount - 1]; }

/// Middle between the two places where the ends leave the tissue.  [m]
Vec3 stitch(const Scene& s) {
  const auto& x = s.state.tissue.position;
  return 0.5 * (holePoint(s.model, tailHole(s), x) + holePoint(s.model, longHole(s), x));
}

double overTissue(const Scene& s) {            // [m]
  const Vec3 from = stitch(s);
  double high = 0.0;                           // [m]
  for (int v : s.model.surface.vertices) {
    const Vec3 off = s.state.tissue.position[v] - from;   // [m]
    if (off.norm() < kAbout && exposedVertex(s.model.surface, s.state.tissue.gone, v)) high = std::fmax(high, off.dot(s.memory.knot.up));
  }
  return high + kOverTissue;
}

bool mayStandLower(const Scene& s) { return heightOf(s) > kOverTissue; }

Vec3 driverShaft(const Scene& s) { return (s.memory.knot.handle + kRise * s.memory.knot.up).normalized(); }

Vec3 driverPlace(const Scene& s) { return stitch(s) + heightOf(s) * upward(s) - kUpJaws * driverShaft(s); }
Pose driverPose(const Scene& s, double back) {   // [m] along its shaft
  return laid(s, kRight, driverPlace(s) + back * driverShaft(s), {driverShaft(s), s.memory.knot.side});
}

namespace {

/// Where the tail lies by itself, but not where it was missed the last time.  [m]
double clearPlace(const Scene& s, double like) {   // [m]
  double best = like, most = -1.0;             // [m]
  for (double c = kFromEnd; c < 0.5 * tailHole(s).coordinate; c += 1e-3) {
    if (std::fabs(c - s.memory.knot.missed) < 0.5 * kElsewhere) continue;
    const double room = std::fmin(kRoom, fromOtherThread(s, c, kSamePlace)) - kFar * std::fabs(c - like);   // [m]
    if (room > most) { most = room; best = c; }
  }
  return best;
}

}  // namespace

double tailPlace(const Scene& s) {             // [m]
  const double tail = tailHole(s).coordinate;  // [m]
  const double place = tail > kLongTail && s.memory.knot.current == 0 ? kBeyondGrip * tail : kFromEnd;   // [m] nearer to the stitch on a long tail, until throws have taken up most of it
  if (s.memory.knot.beside > 1) return clearPlace(s, place);
  const double aside = s.memory.knot.beside == 0 ? 0.0 : place > kElsewhere + kFromEnd ? -kElsewhere : kElsewhere;   // [m]
  return std::fmin(place + aside, 0.5 * tail);
}
/// Between the stitch and the hand that winds.  [m]
double longEnd(const Scene& s) {
  int most = 1;
  for (const PlannedThrow& t : s.memory.knot.throws) most = std::max(most, t.turns);
  return s.action.longEnd + kPerTurn * (most - 1);
}
double longPlace(const Scene& s) {             // [m]
  return std::fmin(longHole(s).coordinate + longEnd(s), threadEnd(s.model, s.state, longHole(s).coordinate) - kFromEnd);
}
bool holdsLong(const Scene& s) {
  const double c = s.state.tools[kLeft].threadCoordinate;   // [m]
  const double from = longHole(s).coordinate;  // [m]
  return c > from + kMostOfIt * (longPlace(s) - from) && c < std::fmin(from + 1.2 * longEnd(s), threadEnd(s.model, s.state, from));
}
bool holdsTooFar(const Scene& s) { return !holdsLong(s) && s.state.tools[kLeft].threadCoordinate > longPlace(s); }
bool needleClings(const Scene& s) {
  const StrandModel& m = s.model.strand;
  const double away = (strand(s).needle.apply(m.needleCentre) - s.state.tools[kLeft].proxy.position).norm();   // [m]
  return threadEnd(s.model, s.state, longHole(s).coordinate) < m.length && away < kCling;
}
bool driverHoldsLong(const Scene& s) { return s.state.tools[kRight].threadCoordinate > longHole(s).coordinate; }
bool holdsTail(const Scene& s) {
  const double c = s.state.tools[kRight].threadCoordinate;   // [m]
  return c >= 0.0 && c < tailHole(s).coordinate;
}

/// Where the winding hand is, having gone so far round the driver, with its thread all but straight if that is not too far. `driver`: the tips.
Pose windingPose(const Scene& s, const Vec3& driver, double swept) {   // [m], [rad]
  const KnotPlan& k = s.memory.knot;
  const Vec3 out = cosine(swept) * k.side + sine(swept) * k.throws[k.current].over * upward(s);
  const Vec3 shaft = s.memory.hand[kRight].command.orientation * Vec3::UnitZ();   // [1]
  const Vec3 loop = driver + kUpJaws * shaft;
  const double length = longLength(s) - k.given;   // [m]
  const Vec3 from = loop - holePoint(s.model, longHole(s), s.state.tissue.position);
  double free = length - from.norm() - kLoop * (swept - 0.5 * kPi);      // [m] beyond the jaws
  if (swept < 0.5 * kPi) {                     // the thread does not touch them yet: |from + free out| = length
    const double b = from.dot(out), rest = b * b - from.squaredNorm() + length * length;   // [m], [m^2]
    free = rest > 0.0 ? std::sqrt(rest) - b : kNearest;
  }
  const double down = -out.dot(k.up), room = (loop - stitch(s)).dot(k.up) - k.floor;   // [1], [m] under the driver
  if (down > kLevel && down * free > room) free = room / down;   // slack rather than caught on the edges
  const double distance = std::fmin(kFarthest, std::fmax(kNearest, free));   // [m]
  return laid(s, kLeft, loop + distance * (out - kSlant * shaft), {leftShaft(s, swept < wholeTurns(s) ? kWindRise : kLeftRise), k.side});
}

double detour(const Scene& s) {                // [m]
  if (!s.state.cut) return 0.0;                // no edge to go over: a curl near the hole would be taken for one, and the driver stand too low
  const Vec3 hole = holePoint(s.model, longHole(s), s.state.tissue.position);   // [m]
  for (int i = threadSpot(s.model.strand, longHole(s).coordinate).node + 1; i < s.model.strand.nodes; ++i) {
    const Vec3 up = strand(s).position[i] - hole;   // [m]
    if (up.dot(s.memory.knot.up) > kUpright) return std::fmin(kMostDetour, s.model.strand.place[i] - longHole(s).coordinate - up.norm());
  }
  return 0.0;
}

double wholeTurns(const Scene& s) { return 2.0 * kPi * turns(s); }   // [rad]

Pose keepTurn(const Scene& s, int hand, const Vec3& position) { return {position, s.memory.hand[hand].command.orientation}; }

Pose upright(const Scene& s, int hand) { return laid(s, hand, s.memory.hand[hand].command.position, {s.memory.knot.up, s.memory.knot.side}); }

bool standsUpright(const Scene& s, int hand) { return (s.memory.hand[hand].command.orientation * Vec3::UnitZ()).dot(s.memory.knot.up) > 0.9; }

bool loopOnJaws(const Scene& s) {
  const double near = 2.0 * toolOf(s.model, s.state, kRight).jawRadius;   // [m]
  for (int i = threadSpot(s.model.strand, longHole(s).coordinate).node + 1; i < s.model.strand.nodes; ++i) {
    const Vec3 p = s.state.tools[kRight].proxy.inverseApply(strand(s).position[i]);
    if (p.z() > 0.0 && p.z() < kJaws && p.head<2>().norm() < near) return true;
  }
  return false;
}

double woundRoundDriver(const Scene& s) {
  double turned = 0.0;                         // [rad]
  const Pose& driver = s.state.tools[kRight].proxy;
  Vec3 p = driver.inverseApply(strandPoint(s.model.strand, strand(s), longHole(s).coordinate));   // [m] in the tool frame
  for (int i = threadSpot(s.model.strand, longHole(s).coordinate).node + 1; i < s.model.strand.nodes; ++i) {
    if (s.model.strand.place[i] > s.state.tools[kLeft].threadCoordinate) break;
    const Vec3 q = driver.inverseApply(strand(s).position[i]);
    if (std::fmin(p.z(), q.z()) > 0.0 && std::fmax(p.z(), q.z()) < kJaws) {
      const double cross = p.x() * q.y() - p.y() * q.x(), dot = p.x() * q.x() + p.y() * q.y();   // [m^2]
      const double length = std::sqrt(cross * cross + dot * dot);
      const double angle = length > 0.0 ? arcSine(cross / length) : 0.0;
      turned += dot >= 0.0 ? angle : (angle < 0.0 ? -kPi : kPi) - angle;
    }
    p = q;
  }
  return std::fabs(turned) / (2.0 * kPi);
}

/// Grip on the tail from the driver's side.
Pose tailGrip(const Scene& s) {
  const StrandState& x = strand(s);
  const Vec3 shaft = (s.memory.knot.handle + kTailRise * s.memory.knot.up).normalized();   // [1]
  return laid(s, kRight, strandPoint(s.model.strand, x, tailPlace(s)), {shaft, strandTangent(s.model.strand, x, tailPlace(s))});
}

}  // namespace halsted::scenes
