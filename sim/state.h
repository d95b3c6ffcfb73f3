#pragma once
/// Everything a step changes. One field list (`visitFields`) serves hash, save, load and diff.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/cutting/cut_state.h"
#include "sim/exchange.h"
#include "sim/metrics.h"
#include "sim/needling/needling.h"
#include "sim/procedure.h"
#include "sim/strand/strand_state.h"
#include "sim/strand/thread_contacts.h"
#include "sim/suture/assist_knot.h"
#include "sim/suture/knot_state.h"
#include "sim/suture/thread_supply.h"
#include "sim/suture/tied_stitches.h"
#include "sim/tissue/tissue_state.h"
#include "sim/tools/clamp_state.h"
#include "sim/tools/instrument_state.h"
#include "sim/tools/tool_state.h"
#include "sim/types.h"
#include "sim/work.h"

namespace halsted {

struct State {
  std::uint64_t step = 0;                      // time = step * dt
  std::uint64_t random = 1;                    // generator state (splitmix64)
  TissueState tissue;
  StrandState strand;
  ThreadContactState threadContacts;           // empty unless `thread.knots`
  KnotState knot;                              // nothing unless `thread.knots`
  std::optional<AssistKnot> assist;            // with `thread.assist`
  std::optional<TiedStitches> stitches;        // where stitches are tied and cut off
  std::optional<ThreadSupply> supply;          // with `thread.spare`
  std::optional<CutState> cut;                 // where tissue can be cut
  std::array<ToolState, kHands> tools;
  std::optional<InstrumentState> instruments;  // where a second instrument is laid out
  std::optional<StandingClamps> clamps;        // where the assistant takes some over
  ProcedureState procedure;
  MetricsState metrics;
  std::vector<std::array<double, kPressers>> bruise;   // [s] per particle: for how long its cell has borne more than bowel does (sim/damage.h)
  std::optional<NeedlingState> needling;       // of a body that is needled; then tissue and strand are empty
  StepWork work;                               // scratch: not hashed, saved or compared
};

/// FNV-1a over every field, in field-list order.
std::uint64_t hash(const State&);
std::vector<std::uint8_t> save(const State&);
/// False (and `error` says which field) when the bytes do not fit this state's sizes.
bool load(const std::vector<std::uint8_t>& bytes, State&, std::string& error);
/// Empty when equal; otherwise the first difference: field, index and both values.
std::string diff(const State& a, const State& b);

}  // namespace halsted
