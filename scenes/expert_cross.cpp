/// Tails of a stitch between two ends: crossed over it and drawn apart, so that each pulls its own side toward the other. With the
/// assistance `thread.assist = "knot"` that is the whole tie.
#include <algorithm>
#include <cmath>

#include "scenes/expert_state.h"
#include "scenes/stitch_frame.h"
#include "sim/strand/strand.h"
#include "sim/suture/holes.h"

namespace halsted::scenes {
namespace {

constexpr double kCrossSpeed = 0.05;           // [m/s]
constexpr double kPass = 8e-3;                 // [m] one hand passes in front of the other
constexpr double kOver = 5e-3;                 // [m] lower by this, and the one behind higher: its shaft comes from the front too, and would catch the other's thread
constexpr double kSlack = 0.9;                 // [1] of the tail's length: it is not drawn while the hands cross
constexpr int kAgain = 2;                      // times that they come back and go past each other anew
constexpr double kFarther = 4e-3;              // [m] from each other each time
constexpr double kRise = 0.6;                  // [1] up over sideways, of the drawn tails: flat, or they lift the stitch; the tools stay clear of the walls
constexpr double kDraw = 0.02;                 // [m/s]
constexpr double kReach = 0.06;                // [m] as far as an arm draws
constexpr double kFeel = 0.5, kFeelTime = 0.1; // [N], [s]
constexpr double kHangs = 2.0, kCreep = 0.1;  // [N] felt though both tails are slack: one has caught on the other tool; [1] of the speed: as good as none
constexpr double kHoldTight = 0.5;             // [s] after the knot has locked, or the walls have met
constexpr double kWallsMeet = 0.25e-3;         // [m]
constexpr double kTight = 0.6;                 // [1] of the speed: next to nothing comes any more
constexpr double kGive = 8e-3;                 // [m] back, when the knot is to be left alone
constexpr double kPatience = 2.0;              // [s] tight and still apart: this is as far as it goes
constexpr double kSeated = 0.5;                // [s] that the knot has been drawn on the tissue: more would only cut in

enum Phase { kLook, kPassBy, kCross, kDrawApart, kGiveWay };

/// +1 for the hand that holds the tail: it goes to the long end's side. -1 for the other. 0: holds neither.
double wayOf(const Scene& s, int hand) {       // [1]
  const StrandState& strand = s.state.strand;
  const double c = s.state.tools[hand].threadCoordinate;   // [m]
  if (c < 0.0) return 0.0;
  if (c < strand.holes[0].coordinate) return 1.0;
  return c > strand.holes[strand.holeCount - 1].coordinate ? -1.0 : 0.0;
}

double lengthHeld(const Scene& s, int hand) {  // [m] between hand and tissue
  const StrandState& strand = s.state.strand;
  const double c = s.state.tools[hand].threadCoordinate;   // [m]
  return c < strand.holes[0].coordinate ? strand.holes[0].coordinate - c : c - strand.holes[strand.holeCount - 1].coordinate;
}

bool crossedAlready(const Scene& s) {
  const int tail = wayOf(s, kLeft) > 0.0 ? kLeft : kRight;
  return halfTurns(s.model, s.state, s.state.tools[tail].threadCoordinate, s.state.tools[1 - tail].threadCoordinate) != 0;
}

void begin(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (s.state.strand.holeCount < 2) { failure = "there is no stitch in the tissue"; return; }
  const StitchFrame f = stitchFrame(s);
  for (int h = 0; h < kHands; ++h) {
    const double way = wayOf(s, h), length = kSlack * lengthHeld(s, h);   // [1], [m]
    if (way == 0.0 || way == wayOf(s, 1 - h)) { failure = "the hands do not hold the two tails"; return; }
    const Vec3 aside = (way * f.side + kRise * f.up).normalized();
    e.goal[h] = {f.middle + length * aside, e.hand[h].command.orientation};
    const Vec3 over = f.middle + (0.8 * length - way * kOver) * f.up + way * kPass * f.front;
    e.pass[h] = {over, e.hand[h].command.orientation};
  }
  e.drawn = e.felt = {};
  e.settled = e.stuck = 0.0;
  nextPhase(s);
  if (!crossedAlready(s)) return;
  for (int h = 0; h < kHands; ++h) e.goal[h] = e.hand[h].command;
  e.phase = kDrawApart;
}

bool passBy(const Scene& s) {
  bool there = true;
  for (int h = 0; h < kHands; ++h) there = moveHand(s, h, s.memory.pass[h], kCrossSpeed) && there;
  return there;
}

enum class Passed { kNotYet, kYes, kCaught };

/// The hands go past each other, slower as they feel something: drawn on, a tail that hangs on the other tool tears the wall. Anew they go one after the
/// other, the one in front first, so that its tail is out of the way of the other.
Passed crossOver(const Scene& s) {
  ExpertState& e = s.memory;
  bool there = true, caught = false;
  const int front = wayOf(s, kLeft) > 0.0 ? kLeft : kRight;
  for (const int h : {front, 1 - front}) {
    feel(e.felt[h], s.state.tools[h].force.norm(), s.dt, kFeelTime);
    const double pace = std::clamp((kHangs - e.felt[h]) / kFeel, 0.0, 1.0);   // [1]
    const bool waits = e.attempt > 0 && !there;
    there = !waits && moveHand(s, h, e.goal[h], pace * kCrossSpeed) && there;
    caught = caught || pace < kCreep;
  }
  if (there) return Passed::kYes;
  return caught ? Passed::kCaught : Passed::kNotYet;
}

/// Back to where they were over the stitch, farther from each other.
void passAgain(const Scene& s) {
  ExpertState& e = s.memory;
  const StitchFrame f = stitchFrame(s);
  for (int h = 0; h < kHands; ++h) e.pass[h].position += wayOf(s, h) * kFarther * f.front;
  e.felt = {};
  ++e.attempt;
  goTo(s, kPassBy);
}

void beginToDraw(const Scene& s) {
  ExpertState& e = s.memory;
  for (int h = 0; h < kHands; ++h) e.goal[h].position = e.hand[h].command.position;
  e.felt = {};
  nextPhase(s);
}

/// Each hand draws its tail outward until it feels the tension; true once the walls have met for a moment, the knot lies on them, or nothing
/// more comes.
bool drawApart(const Scene& s) {
  ExpertState& e = s.memory;
  const StitchFrame f = stitchFrame(s);
  double fastest = 0.0;                        // [1] of the drawing speed
  for (int h = 0; h < kHands; ++h) {
    feel(e.felt[h], s.state.tools[h].threadForce.norm(), s.dt, kFeelTime);
    const double pace = std::clamp((s.action.tension - e.felt[h]) / kFeel, -1.0, 1.0);   // [1]
    e.drawn[h] = std::clamp(e.drawn[h] + pace * kDraw * s.dt, 0.0, kReach);
    fastest = std::fmax(fastest, e.drawn[h] < kReach ? pace : 0.0);
    const Vec3 out = (e.goal[h].position - f.middle).normalized();
    moveHand(s, h, {e.goal[h].position + e.drawn[h] * out, e.goal[h].orientation}, 0.1);
  }
  const auto& seam = s.state.metrics.seam;     // none where a knot closes one end
  e.settled = seam && seam->join.wallGap < kWallsMeet ? e.settled + s.dt : 0.0;
  if (s.action.kind == "tie" && s.state.assist->seated > kSeated) return true;
  if (s.action.kind == "tie") e.settled = 0.0;   // walls that other stitches have closed are not yet tied here
  e.stuck = std::fmax(0.0, e.stuck + (fastest < kTight ? s.dt : -s.dt));   // what is felt swings
  return e.settled > kHoldTight || e.stuck > kPatience;
}

}  // namespace

bool runCrossed(const Scene& s, std::string& failure) {
  ExpertState& e = s.memory;
  if (e.phase == kLook) { begin(s, failure); return false; }
  if (s.state.strand.holeCount < 2) { failure = "the thread has left the tissue"; return false; }
  if (e.phase == kGiveWay) {
    for (int h = 0; h < kHands; ++h) moveHand(s, h, e.goal[h], kCrossSpeed);
    return s.state.assist->locked && s.inPhase > kHoldTight;
  }
  if (e.phase == kDrawApart) {
    if (!drawApart(s)) return false;
    if (s.action.kind != "tie") return true;
    const StitchFrame f = stitchFrame(s);
    for (int h = 0; h < kHands; ++h) e.goal[h] = {s.memory.hand[h].command.position + kGive * (f.middle - s.memory.hand[h].command.position).normalized(), e.goal[h].orientation};
    nextPhase(s);
    return false;
  }
  if (e.phase == kPassBy) {
    if (passBy(s)) nextPhase(s);
    return false;
  }
  const Passed passed = crossOver(s);
  if (passed == Passed::kCaught && e.attempt < kAgain) passAgain(s);
  else if (passed != Passed::kNotYet) beginToDraw(s);
  return false;
}

}  // namespace halsted::scenes
