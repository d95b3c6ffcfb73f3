#pragma once
/// Clamps that stay on the tissue while the hands do something else. A hand that has closed an Allis clamp on tissue gives it to the assistant as an
/// explicit act (`Command::kHandOver`, recorded with the step's input) and is given another ([assistant] clamps of the scene). The assistant
/// keeps it where it was taken over, gives way as much as a hand's coupling does, and lets go of a piece that has come free once a hand holds it.
/// A standing clamp meets nothing but the tissue between its jaws, and that tissue meets no tool. Physics thread; no heap.
#include "sim/model.h"
#include "sim/state.h"
#include "sim/step.h"

namespace halsted {

/// Begins the step. The assistant takes the clamp of a hand, or says in an event and in `State::clamps` why not.
void handOverClamp(const Model&, int hand, State&, StepOutput&);

/// Is this triangle, or a neighbour that shares a corner with it, between the jaws of a standing clamp?
bool inStandingClamp(const Model&, const State&, int triangle);

/// The instrument that a standing clamp is.
inline const ToolParams& clampOf(const Model& m, const StandingClamp& c) { return c.second == 1 ? m.params.second[c.hand] : m.params.tools[c.hand]; }

/// What a holder grips: `holder` is a hand, or kHands + the number of a standing clamp.
TissueGrasp& graspOf(State&, int holder);

/// Stiffness of the hand behind a holder.  [N/m]
double couplingOf(const Model&, const State&, int holder);

/// Appends what standing clamps hold to `work.touch`.
void findStandingGrasps(const Model&, State&);

/// After the tissue has answered: each clamp goes where the tissue draws it, what it could not hold slides through its jaws.
void settleStandingClamps(const Model&, State&, StepOutput&);

/// Lets go of what is gone.
void dropStandingGrasps(const Model&, State&, StepOutput&);

}  // namespace halsted
