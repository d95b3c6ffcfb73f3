#pragma once
/// What a hand holds. A scene may lay out a second instrument for a hand ([tool.left.second], [tool.right.second]); the assistant changes
/// them as an explicit act (`Command::kChangeInstrument`, recorded with the step's input): the jaws are empty and neither the instrument
/// that is given back nor the one that is handed stands in the tissue. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"

namespace halsted {

struct StepOutput;

/// The instrument in this hand now; its `couplingStiffness` does not count, that is the hand's own (`SimParams::tools`).
inline const ToolParams& toolOf(const Model& m, const State& s, int hand) {
  return s.instruments && s.instruments->second[hand] ? m.params.second[hand] : m.params.tools[hand];
}

/// Begins the step. Changes the instrument of a hand for its other one, or says in an event and in `State::instruments` why not.
void changeInstrument(const Model&, int hand, State&, StepOutput&);

}  // namespace halsted
