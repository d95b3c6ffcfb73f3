#pragma once
/// The memory of a scripted surgeon (scenes/expert.h). Private to scenes/.
#include "scenes/bite_plan.h"
#include "scenes/cut_ring.h"
#include "scenes/expert.h"
#include "scenes/hand_motion.h"
#include "scenes/knot_plan.h"

namespace halsted::scenes {

/// Where the needle goes in and how far, as commanded.
struct NeedlePlan {
  int point = -1;                              // of the body's acupoints
  Vec3 entry = Vec3::Zero(), axis = Vec3::UnitZ();   // [m], [1] inward
  Quat orientation = Quat::Identity();         // of the tool, not twirled
  double depth = 0.0;                          // [m] of the tip past `entry`
  double twist = 0.0;                          // [rad]
};

/// A pen on its way round a wall.
struct CutCourse {
  CutRing ring;
  int first = 0, done = 0;                     // columns: where it began; parted since, one after the other
  double quiet = 0.0;                          // [s] since current last flowed
  bool lifted = false;                         // on its way out of the wall, to come down anew
  int vain = 0;                                // how often it has come down since and met nothing
};

struct ExpertState {
  std::size_t action = 0;
  int phase = 0;
  std::uint64_t actionStart = 0, phaseStart = 0;   // [steps]
  bool started = false;
  std::array<HandMotion, kHands> hand;
  bool planned = false;                        // the action under way has looked for its places
  BitePlan plan;
  std::int32_t bite = 0;                       // number that the bite under way will have
  TissuePlace counter;                         // where the other hand holds the wall
  double tipAngle = 0.0;                       // [rad] commanded on the plan's circle
  int attempt = 0;                             // at the bite under way
  double dip = 0.0;                            // [m] its circle below the places
  int misses = 0;                              // of the needle by the driver, in this bite
  double pressed = 0.0;                        // [m] how far the needle was pushed along its point to get in
  bool slid = false;                           // along the wall, at this bite
  Vec3 pressAlong = Vec3::UnitX();             // [1]
  Vec3 pullFrom = Vec3::Zero(), pullAlong = Vec3::UnitZ();   // [m], [1]
  double pulled = 0.0;                         // [m]
  std::array<double, kHands> drawn{};          // [m] of each tail
  std::array<double, kHands> felt{};           // [N] tension of each tail as the hand feels it
  double place = 0.0;                          // [m] coordinate where a tail is to be taken
  bool crossed = false;                        // the tails have changed sides, as an odd number of throws leaves them
  std::int32_t cutsBefore = 0;                 // of the thread, before this cut
  double settled = 0.0, stuck = 0.0;           // [s] since the tails stopped coming; since they only hold, or close nothing more
  bool closed = false;                         // as far as it is to be drawn
  double leastOpen = 0.0;                      // [1] of the opening at rest, since it is drawn
  std::array<Pose, kHands> goal;               // of the phase under way
  std::array<Pose, kHands> pass;               // on the way to `goal`
  KnotPlan knot;
  Command spoken;                              // to be said
  std::int32_t handedBefore = 0;               // threads, before this one was asked for
  std::int32_t secondBefore = 0;               // whether a hand held its second instrument, before the change
  std::int32_t clampsBefore = 0;               // in the assistant's hands, before this one
  NeedlePlan needle;
  CutCourse cut;
};

/// What a phase may look at, and its clock.
struct Scene {
  const Model& model;
  const State& state;
  ExpertState& memory;
  const ExpertAction& action;
  double dt = 0.0;                             // [s]
  double inPhase = 0.0;                        // [s] since the phase began
};

/// One bite, from the approach to the thread drawn through. Each returns true when the action is finished.
bool runBite(const Scene&, std::string& failure);
bool runDraw(const Scene&, std::string& failure);
bool runTakeTails(const Scene&, std::string& failure);
bool runTighten(const Scene&, std::string& failure);
bool runCut(const Scene&, std::string& failure);
bool runTraction(const Scene&, std::string& failure);
/// One knot, throw after throw, with the right hand's driver; both hands hold the ends when it is done.
bool runTie(const Scene&, std::string& failure);
/// Both tails crossed over the stitch between two ends and drawn apart; with `thread.assist = "knot"` that ties it.
bool runCrossed(const Scene&, std::string& failure);
/// Both hands let go and rise.
bool runLetGo(const Scene&);
/// Both hands let go, and the driver draws the thread out of the tissue again by its long end. Not a needle that is in it, nor a tied knot.
bool runTakeOut(const Scene&);
/// Both hands let go and go aside; the assistant is asked for a new thread and loads the driver with it.
bool runFreshThread(const Scene&, std::string& failure);
/// Both hands let go and go aside; the assistant changes the instrument of every hand that has a second one.
bool runChangeTools(const Scene&, std::string& failure);
/// The left clamp takes the fold of a prolapse and draws it toward the surgeon until it is felt.
bool runHoldFold(const Scene&, std::string& failure);
/// The left hand gives its clamp, as it is, to the assistant, and draws the one that it is given for it clear of the tissue.
bool runHandOver(const Scene&, std::string& failure);
/// The right pen goes once round a wall, to and fro wherever it has not parted yet.
bool runCutRing(const Scene&, std::string& failure);
/// The left clamp carries off what has come free, and lets go of it.
bool runTakeAway(const Scene&, std::string& failure);
/// Every action of a needle. Returns true when it is finished.
bool runNeedling(const Scene&, std::string& failure);
/// Where both tools of a needling scene start.
std::array<Pose, kHands> needlingStart(const BodyModel&);

/// Begins a phase of the action under way; the one after this.
void goTo(const Scene&, int phase);
void nextPhase(const Scene&);

/// Reusable pieces.
Pose above(const Pose& tool, double distance);                   // [m] back along the tool's own shaft
bool moveHand(const Scene&, int hand, const Pose& goal, double speed);   // [m/s]
/// Comes down on `grip` along the shaft with open jaws and closes them; true once closed. Uses phases `first` to `first + 2`.
bool pickUp(const Scene&, int hand, const Pose& grip, int first);
/// The driver holds the long end: the other hand lets go of what it holds and takes the thread that hangs from the driver; true once it
/// has. Uses `kHangingPhases` phases from `first` on.
inline constexpr int kHangingPhases = 4;
inline constexpr double kHanging = 22e-3;      // [m] below the driver that holds it
bool takeHanging(const Scene&, int first);
Pose parked(int hand);
/// Another turn of the thread, farther along it than `near`, lies between the closed jaws: it would be drawn along, and the walls with it.
bool pinchesAnother(const Scene&, int hand, double near);   // [m]
/// Grip on the thread at a coordinate: from the surgeon's side, jaws opening across the thread, whichever way round is nearer.
Pose threadGrip(const Scene&, int hand, double coordinate);   // [m]
/// Distance of a place on the thread from all of it that lies farther than `near` along it.  [m]
double fromOtherThread(const Scene&, double coordinate, double near);   // [m]

}  // namespace halsted::scenes
