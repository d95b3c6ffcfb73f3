#include "sim/procedure.h"

namespace halsted {
namespace {

constexpr std::array<const char*, kQuantities> kNames = {
    "time",          "needle_held",  "bites",            "stitch_across_opening", "bite_spacing", "bite_depth", "tail_tension",
    "peak_tension",  "opening_fraction", "rim_to_anvil", "tails_held",            "peak_force",   "tears",
    "crossings",     "rim_gap",      "wall_gap",         "released_gap", "inversion",             "tail_difference", "wall_share", "thread_cuts", "full_thickness", "partial_thickness",
    "throws",        "knot_locks",   "wrong_throws",     "first_turns",           "knot_gap",     "loop_slack",  "tool_turns",
    "thread_breaks", "stitches",     "threads_left",
    "tip_to_point",  "finger_to_point", "skin_pressed",    "entry_offset",          "needle_depth", "depth_error", "angle_error",
    "layers_punctured", "twirls",       "lifts",           "needle_grasp",          "withdrawal_speed", "needle_out",
    "cut_share_outer", "cut_share_inner", "cut_error", "overshoot", "cut_time", "cut_energy", "current", "specimen_free", "specimen_taken", "tissue_held",
    "perforations", "force_time", "peak_pressure", "injured_area", "second_instruments"};
static_assert(kNames.back() != nullptr, "every quantity has a name");

bool holds(const Condition& condition, const Observation& seen) {
  const double value = seen[static_cast<int>(condition.quantity)];   // unit of the quantity
  return value >= condition.min && value <= condition.max;           // a quantity that is not a number holds nothing
}

bool same(const Condition& a, const Condition& b) {
  return a.quantity == b.quantity && a.min == b.min && a.max == b.max;
}

/// Adds dt while the condition holds without a gap. Half a step of slack: sums of dt are not exact.
bool heldLongEnough(const Condition& condition, const Observation& seen, double dt, double& held) {   // dt, held [s]
  if (!holds(condition, seen)) {
    held = 0.0;
    return false;
  }
  held += dt;
  return held >= condition.hold - 0.5 * dt;
}

/// True in the step in which a fault begins; it counts again only after it has ended.
bool faultBegins(const ProcedureStep& step, const Observation& seen, double dt, ProcedureState& state) {   // dt [s]
  if (!step.hasFault) return false;
  if (!heldLongEnough(step.fault, seen, dt, state.heldFault)) {
    if (state.heldFault == 0.0) state.inFault = false;
    return false;
  }
  if (state.inFault) return false;
  state.inFault = true;
  return true;
}

bool becomesLate(const ProcedureStep& step, double time, ProcedureState& state) {   // time [s]
  if (step.limit <= 0.0 || state.late || time - state.stepStart <= step.limit) return false;
  state.late = true;
  return true;
}

void enter(std::span<const ProcedureStep> table, std::int32_t next, double time, ProcedureState& state) {   // time [s]
  const ProcedureStep& left = table[state.current];
  state.current = next;
  const bool completed = state.current == static_cast<std::int32_t>(table.size());
  // A fault that goes on under the same condition is still the same occurrence, not a new one of the next step.
  const bool goesOn = !completed && table[state.current].hasFault && left.hasFault && same(left.fault, table[state.current].fault);
  state.inFault = state.inFault && goesOn;
  state.heldDone = 0.0;
  if (!goesOn) state.heldFault = 0.0;
  state.stepStart = time;
  state.late = false;
}

void enterNext(std::span<const ProcedureStep> table, const Observation& seen, double time, ProcedureState& state) {   // time [s]
  const ProcedureStep& left = table[state.current];
  state.finished[state.current] = time;
  const bool again = left.repeatFrom >= 0 && left.repeatFrom <= state.current && !holds(left.enough, seen);
  enter(table, again ? left.repeatFrom : state.current + 1, time, state);
}

}  // namespace

const char* name(Quantity quantity) {
  const int i = static_cast<int>(quantity);
  return i >= 0 && i < kQuantities ? kNames[i] : "unknown";
}

bool parseQuantity(const std::string& text, Quantity& out) {
  for (int i = 0; i < kQuantities; ++i) {
    if (text != kNames[i]) continue;
    out = static_cast<Quantity>(i);
    return true;
  }
  return false;
}

ProcedureEvent advance(std::span<const ProcedureStep> table, const Observation& seen, double time, double dt, ProcedureState& state) {
  const auto steps = static_cast<std::int32_t>(table.size());
  if (state.current < 0 || state.current >= steps || state.current >= kMaxProcedureSteps) return ProcedureEvent::kNone;
  const ProcedureStep& step = table[state.current];
  const bool done = heldLongEnough(step.done, seen, dt, state.heldDone);

  // One event a call: what else begins in the very moment of a fault, or is done, does so one call later.
  if (faultBegins(step, seen, dt, state)) {
    ++state.faults[state.current];
    return ProcedureEvent::kFault;
  }
  if (becomesLate(step, time, state)) {
    ++state.faults[state.current];
    return ProcedureEvent::kLate;
  }
  if (!done && step.againFrom >= 0 && step.againFrom < state.current && holds(step.undone, seen)) {
    enter(table, step.againFrom, time, state);
    return ProcedureEvent::kBegunAnew;
  }
  if (!done) return ProcedureEvent::kNone;
  enterNext(table, seen, time, state);
  return state.current == steps ? ProcedureEvent::kCompleted : ProcedureEvent::kStepDone;
}

}  // namespace halsted
