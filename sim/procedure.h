#pragma once
/// The procedure manager: a table of steps, measured quantities, and a state that advances through it.
/// A step that needs new logic gets a new measured quantity, never a callback.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/types.h"

namespace halsted {

/// What a scene measures after each step. Names as in scene.toml.
enum class Quantity : std::uint8_t {
  kTime,                   // time                     [s]
  kNeedleHeld,             // needle_held              [1] hands that hold the needle
  kBites,                  // bites                    [1] completed bites in the tissue
  kStitchAcrossOpening,    // stitch_across_opening    [1] bites not adjacent to their predecessor
  kBiteSpacing,            // bite_spacing             [m] last gap between neighbouring bites
  kBiteDepth,              // bite_depth               [m] last distance from entry to the rim
  kTailTension,            // tail_tension             [N] the smaller of the two tails' tensions, where a hand holds them
  kPeakTension,            // peak_tension             [N] largest tension so far
  kOpeningFraction,        // opening_fraction         [1] opening area / its rest value
  kRimToAnvil,             // rim_to_anvil             [m] mean gap between the rim and the anvil's surface
  kTailsHeld,              // tails_held               [1] hands that hold the thread
  kPeakForce,              // peak_force               [N] largest force on a hand so far
  kTears,                  // tears                    [1] channels torn
  kCrossings,              // crossings                [1] stretches of thread from one bowel to the other
  kRimGap,                 // rim_gap                  [m] largest distance of the two edges along the sewn stretch
  kWallGap,                // wall_gap                 [m] the same between the outer walls near the edges
  kReleasedGap,            // released_gap             [m] wall_gap of a stitch whose needle is cut off and whose thread no hand holds; else not a number
  kInversion,              // inversion                [1] sine of the edges' mean turn toward their lumen
  kTailDifference,         // tail_difference          [m] between the lengths of the two tails
  kWallShare,              // wall_share               [1] depth of the last bite in the wall: 0 serosa, 1 mucosa
  kThreadCuts,             // thread_cuts              [1] made with blades
  kFullThickness,          // full_thickness           [1] bites that went through the mucosa
  kPartialThickness,       // partial_thickness        [1] bites of the thread in the tissue that came out on the side on which they went in
  kThrows,                 // throws                   [1] tied in the thread
  kKnotLocks,              // knot_locks               [1] throws that lie square on the one before (=)
  kWrongThrows,            // wrong_throws             [1] throws wound the same way as the one before (x): granny
  kFirstTurns,             // first_turns              [1] turns of the first throw: 2 in a surgeon's knot
  kKnotGap,                // knot_gap                 [m] thread between tissue and knot: more than a few mm is an air knot
  kLoopSlack,              // loop_slack               [m] thread of a stitch that is cut off and let go, beyond the way round its holes; 0 where it pulls; else not a number
  kToolTurns,              // tool_turns               [1] turns of thread about the right tool, of either sense
  kThreadBreaks,           // thread_breaks            [1] places where the thread has parted
  kStitches,               // stitches                 [1] tied and cut off, still in the tissue
  kThreadsLeft,            // threads_left             [1] needled threads on the table
  kTipToPoint,             // tip_to_point             [m] needle's tip from the acupoint
  kFingerToPoint,          // finger_to_point          [m] pressing finger from the acupoint
  kSkinPressed,            // skin_pressed             [m] skin pressed in by the finger
  kEntryOffset,            // entry_offset             [m] where the skin was pierced, from the acupoint; 0 before
  kNeedleDepth,            // needle_depth             [m] of the tip below the skin, along the needle; 0 outside
  kDepthError,             // depth_error              [m] beyond the acupoint's depth; negative: short of it
  kAngleError,             // angle_error              [rad] between needle and skin against the acupoint's angle
  kLayersPunctured,        // layers_punctured         [1] skin, fat, muscle
  kTwirls,                 // twirls                   [1] to and fro within the range of a twirl, since the skin was pierced
  kLifts,                  // lifts                    [1] up and down within the range of lifting and thrusting
  kNeedleGrasp,            // needle_grasp             [1] friction over that of a needle never turned
  kWithdrawalSpeed,        // withdrawal_speed         [m/s] of the needle on its way out; 0 outside
  kNeedleOut,              // needle_out               [1] 1 once the needle has been in and is out again
  kCutShareOuter,          // cut_share_outer          [1] of the outer wall's circumference that is cut through
  kCutShareInner,          // cut_share_inner          [1] the same of the inner wall
  kCutError,               // cut_error                [m] worst distance of the cut from its line
  kOvershoot,              // overshoot                [J] heat in tissue that should not be touched
  kCutTime,                // cut_time                 [s] with current through tissue
  kCutEnergy,              // cut_energy               [J] that the pen has given to tissue
  kCurrent,                // current                  [1] 1 while current flows through tissue
  kSpecimenFree,           // specimen_free            [1] pieces that hang on nothing, and those carried away
  kSpecimenTaken,          // specimen_taken           [1] pieces carried away
  kTissueHeld,             // tissue_held              [1] hands and standing clamps that hold tissue
  kPerforations,           // perforations             [1] times that an instrument has gone through the wall
  kForceTime,              // force_time               [N s] of a hand's instrument on the wall; the larger of both hands'
  kPeakPressure,           // peak_pressure            [Pa] of an instrument on a cell of the wall, so far
  kInjuredArea,            // injured_area             [m^2] of the wall that instruments have injured
  kSecondInstruments,      // second_instruments       [1] hands that hold the second instrument laid out for them
  kCount
};
inline constexpr int kQuantities = static_cast<int>(Quantity::kCount);
const char* name(Quantity);                                  // as in scene.toml
bool parseQuantity(const std::string& text, Quantity& out);  // false: unknown name

using Observation = std::array<double, kQuantities>;         // indexed by Quantity

/// `min <= quantity <= max`, held for `hold` seconds without a gap.
struct Condition {
  Quantity quantity = Quantity::kTime;
  double min = -1e300, max = 1e300;                          // [unit of the quantity]
  double hold = 0.0;                                         // [s]
};

struct ProcedureStep {
  std::string id, instruction;
  Condition done;
  bool hasFault = false;
  Condition fault;
  std::string faultName;
  double limit = 0.0;                                        // [s] 0 = none; exceeding it is the fault "too slow"
  int repeatFrom = -1;                                       // index of an earlier step, or this one: back there once this is done, unless `enough`
  Condition enough;
  int againFrom = -1;                                        // index of an earlier step: back there as soon as `undone`, what was begun is gone
  Condition undone;
};

inline constexpr int kMaxProcedureSteps = 32;

/// Part of `State`. Arrays are indexed by procedure step.
struct ProcedureState {
  std::int32_t current = 0;                                  // == table size: completed
  double heldDone = 0.0, heldFault = 0.0;                    // [s]
  double stepStart = 0.0;                                    // [s] when the current step began
  std::array<double, kMaxProcedureSteps> finished{};         // [s] the last time, of a step that is done again
  std::array<std::int32_t, kMaxProcedureSteps> faults{};     // counted once per occurrence
  bool inFault = false, late = false;
};

enum class ProcedureEvent : std::uint8_t { kNone, kStepDone, kFault, kLate, kBegunAnew, kCompleted };   // late: a fault, too, but of the step's time

/// Advances the procedure by one step. Pure: same table, observation and state give the same state.  time, dt [s]
ProcedureEvent advance(std::span<const ProcedureStep> table, const Observation& seen, double time, double dt, ProcedureState&);

}  // namespace halsted
