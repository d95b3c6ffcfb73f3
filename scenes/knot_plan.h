#pragma once
/// What a surgeon decides before a throw of an instrument tie: how often and which way to wind, and where the hands go. Private to scenes/.
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted::scenes {

/// One throw: turns of the long end round the driver, and the way it is wound from its own side: +1 over the driver first, -1 under it.
/// The ends change sides with every throw, so that over and over again makes a square knot.
struct PlannedThrow { int turns = 1, over = 1; };

/// "2=1=1": a double throw and two single ones, each wound the other way (=) than the one before, or the same way (x). Empty: not a knot.
std::vector<PlannedThrow> parseThrows(const std::string& notation);

/// Memory of a knot under way.
struct KnotPlan {
  std::vector<PlannedThrow> throws;
  std::size_t current = 0;
  int added = 0;                               // throws beyond those planned, as nothing locked
  Vec3 up = Vec3::UnitZ();                     // [1] away from the walls
  Vec3 handle = -Vec3::UnitY();                // [1] along the wound, toward the hand that holds the driver
  Vec3 side = Vec3::UnitX();                   // [1] across the wound, from the stitch toward the strand of the long end below this throw
  double floor = -1.0;                         // [m] above the stitch: the winding hand goes no lower
  double swept = 0.0;                          // [rad] of this throw's winding
  double hole = 0.0;                           // [m] coordinate of the long end's hole as this throw began: thread drawn through since is slack, not length to wind with
  double detour = 0.0;                         // [m] that the long end is longer than its straight way up from the hole: over an edge first
  double given = 0.0;                          // [m] by which the winding hand has given way
  double lower = 0.0;                          // [m] by which the driver stands nearer to the stitch than its thread allows: its device has come to a stop, or the winding hand has nothing more to give
  Vec3 longWay = -Vec3::UnitX();               // [1] in which the long end of this throw is drawn
  double beyond = 0.0;                         // [m] of thread in the loop beyond the way from hole to hole, as its last throw was drawn
  double hung = 1.0;                           // [m] of that as this throw's loop was last seen to hang: farther than any can
  double tailOut = 0.0;                        // [m] coordinate at which the tail left the throws that lay as it was taken; with none, its hole
  int throwsBefore = 0, turnsBefore = 0;       // what was tied as this throw was begun
  int stepsMore = 0, stepsSame = 0;            // since it is drawn, with the knot read in full: it shows more than before, or no more
  bool loose = false;                          // as this one was begun, nothing locked the throw below it: later its own loop, still wide, may be read as a lock
  int redrawn = 0;                             // how often a throw has been drawn again, as its loop hung
  int misses = 0;                              // of the tail, or of a loop that clings or slides off, in this throw
  int beside = 0;                              // how often of these the jaws closed beside the tail, or the loop did not reach so far: it is taken a little further along
  double missed = -1.0;                        // [m] coordinate where the jaws closed beside the tail the last time
  std::array<double, kHands> drawn{}, felt{};  // [m], [N]
  double settled = 0.0;                        // [s]
};

/// The loop has come off beside the tail: what is tied, seen in full, is what was tied before. For most of the time, as a tail that lies across its
/// throw may read as half a turn more for a look.
inline bool noThrowCame(const KnotPlan& k) { return k.stepsSame > k.stepsMore; }

}  // namespace halsted::scenes
