#pragma once
/// A scripted surgeon. It reads `expert.toml` (anatomical terms: bite at an angle, depth; find a point, insert, twirl), looks at the
/// simulated scene as a person would, and says where each hand wants to be. It never touches the physics: the targets move the
/// simulated hands that hold the virtual devices. Pure: same script, model, state and memory give the same targets.
/// Runs on the physics thread, after each step.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/model.h"
#include "sim/state.h"

namespace halsted::scenes {

struct ExpertAction {
  std::string kind;                            // a suture's: "bite", "draw", "take_tails", "tighten", "tie", "cut", "take_stay", "traction", "let_go",
                                               // "take_out", "fresh_thread", "change_tools", "hold": see scenes/expert_run.cpp
                                               // an excision's: "hold_fold", "hand_over", "cut_ring", "take_away": see scenes/expert_excise.cpp
                                               // a needle's: "find", "press", "insert", "twirl", "lift_thrust", "withdraw", "hold"
  double angleDegrees = 0.0;                   // angle_deg [deg] round the opening, 0 at +x, counter-clockwise seen by the surgeon; from_deg: where a cut begins; of a needle
                                               // to the skin, 0: as the point's textbook says
  int bowel = 0;                               // bowel: 1 or 2 in the file, the left and the right one of two ends; wall: "outer" or "inner"
  double height = 0.0;                         // height_mm [m] of a cut over the base; 0: along the planned line
  double depth = 5e-3;                         // depth_mm [m] entry from the rim; of a needle's tip, 0: the textbook's; of a pressing finger; of the clamp over the fold;
                                               // of the pen's tip in the wall at most
  double exitDepth = 0.0;                      // exit_depth_mm [m] a bite across the edge comes out here, at the same angle; 0: along the rim
  bool counterClockwise = false;               // counter_clockwise: the bite runs the other way along the rim
  bool across = false;                         // across: in one go through both walls, one in the other, mucosa to mucosa; depths from the edges that a cut has left
  bool through = false;                        // through: outside in and inside out, the needle crosses the lumen between; else it stays in the wall
  double sink = 0.0;                           // sink_mm [m] deeper than the places ask: through the mucosa and back
  double tilt = 0.0;                           // tilt_deg [deg] of the needle's plane, lifts the driver's shaft off the wall; of the pen toward the surgeon
  double width = 6e-3;                         // width_mm [m] entry to exit, clockwise along the rim
  double pull = 0.03;                          // pull_mm [m] of thread drawn through after the bite, or by "draw"
  double tail = 0.0;                           // tail_mm [m] of thread between the stitch and the jaws that take it; 0: where it is clear and near. Of a knot tied by friction: a
                                               // longer tail is drawn to this length first; 0: as it is
  double tension = 1.0;                        // tension_n [N] at which tightening stops
  double seconds = 60.0;                       // limit_s [s] of the action; of a hold, its length
  std::string tie;                             // tie: throws as surgeons write them, "1=1", "2=1=1", "1x1"
  double drawDegrees = 0.0;                    // draw_deg [deg] of the line along which the ends of a throw are drawn apart to the straight line over the stitch, the tail toward the surgeon
  double gap = 0.0;                            // gap_mm [m] of a knot tied by friction: walls that come farther apart under a throw that nothing locks are drawn together again; 0: not looked at
  double beyondHand = 0.012;                   // beyond_hand_mm [m] past the hand that holds the long end: where it is cut at the nearest
  double longEnd = 0.065;                      // long_end_mm [m] of thread between the stitch and the hand that winds it, for single turns
  std::optional<ThreadAssist> assist;          // assist = "none" or "knot": done at this level of assistance only; absent: at any
  bool unlessHeld = false;                     // unless_held: of "take_tails" and "take_stay": not done, and takes no time, where each hand holds a tail already
  std::string point;                           // point: an acupoint's id; empty: the one the scene is set for
  int cycles = 1;                              // cycles [1] twirls or lifts
  double twirlDegrees = 150.0;                 // twirl_deg [deg] from end to end
  double lift = 5e-3;                          // lift_mm [m] up from the depth and down again
  double period = 1.0;                         // period_s [s] of a twirl or lift
  double speed = 5e-3;                         // speed_mm_s [m/s] in or out; of the pen along the wall
  double distance = 25e-3;                     // distance_mm [m] of the pressing finger from the point
  int line = 0;                                // in the file, for messages
  int stitch = -1, attempt = 0;                // of stitch_at_deg, of again_deg: set when the script is read; -1: belongs to no stitch
};

/// `stitch_at_deg = [0, 20, -20]` in a file: its actions (those after the last "change_tools", if there is one) are done once for each, the number added to every angle_deg of the left (or only)
/// bowel and taken from that of the right one, which is seen from its other side: 0 is where the actions themselves say.
/// `stitch_at_deg = { knot = [0, 20, -20], none = [0, 20] }`: other places, or another order, at each level of assistance.
/// No further one is set once the procedure is completed: the last places may be for stitches that tear out after they were tied.
/// `again_deg = [4, -4]`: a stitch that cannot be finished (a bite that does not come out, a throw that is lost too often, thread that leaves the tissue) is taken out and set anew with a
/// fresh thread, so far from its place, as often as there are numbers; without the key the script ends there.
struct ExpertScript {
  std::string origin;                          // its file, for messages
  std::string scene;                           // folder name of the scene it is for
  int sceneLine = 1;                           // where the file says so, for messages
  std::string text;                            // as read, kept for the session record
  std::vector<ExpertAction> actions;
};

/// Throws InputError (scenes/scene.h) naming file, line and key, also for an impossible bite.
ExpertScript readExpert(const std::string& path);
ExpertScript parseExpert(const std::string& text, const std::string& origin);

/// Is it an action on tissue and thread? Needles have their own; "hold" is both.
bool isSutureAction(const std::string& kind);

/// The surgeon's memory: which action and phase, since when, what was seen at its start.
struct ExpertState;
struct ExpertStateDeleter { void operator()(ExpertState*) const; };
using ExpertStatePtr = std::unique_ptr<ExpertState, ExpertStateDeleter>;
/// Throws InputError naming file, line and key for an action that this scene does not have, or a bite that its wall has no place for.
ExpertStatePtr beginExpert(const ExpertScript&, const Model&);

/// Where both tools start, in the world; the virtual devices are placed there.
std::array<Pose, kHands> startPoses(const Model&);

/// What the surgeon has asked for aloud since this was last called: a fresh thread, mostly nothing. It goes into the next step's input.
Command takeSpokenCommand(ExpertState&);

/// True while there is something left to do. `failure` is set when an action ran out of time or cannot be done; with true, its stitch is set anew.
bool advanceExpert(const ExpertScript&, const Model&, const State&, ExpertState&, std::array<HandTarget, kHands>& targets,
                   std::string& failure);

}  // namespace halsted::scenes
